#include "app/gallery_page.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #222; --soft: #666; --line: #ccc; --paper: #fafafa; --card: #fff; }
@media (prefers-color-scheme: dark) { :root { --ink: #ddd; --soft: #999; --line: #444; --paper: #181818; --card: #222; } }
body { margin: 2rem auto; max-width: 100rem; padding: 0 1.5rem; font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); }
h1 { font-weight: 600; margin-bottom: 0; } h2 { font-weight: 600; margin: 3rem 0 0; }
p { max-width: 46rem; margin: .4rem 0 1rem; } .soft, dd, summary { color: var(--soft); }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(17rem, 1fr)); gap: 1rem; }
figure { margin: 0; background: var(--card); border: 1px solid var(--line); border-radius: 6px; overflow: hidden; }
figure img { display: block; width: 100%; height: auto; background: #000; }
figcaption { padding: .6rem .9rem .8rem; } figcaption strong { font-weight: 600; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0 .8rem; margin: .3rem 0; font-size: .9rem; } dt { color: var(--soft); }
dd { margin: 0; color: var(--ink); font-variant-numeric: tabular-nums; }
pre, code { font: 12px/1.45 ui-monospace, monospace; } pre { overflow-x: auto; margin: .5rem 0 0; } code { word-break: break-word; }
summary { cursor: pointer; font-size: .9rem; }
)";

std::string escaped(const std::string& text) {
    std::string out;
    for (char c : text) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        default: out += c;
        }
    }
    return out;
}

std::string term(const char* name, const std::string& value) {
    return fmt::format("<dt>{}</dt><dd>{}</dd>", name, value);
}

std::string ray_terms(const RayStatistics& rays) {
    const std::uint64_t all = rays.eye + rays.shadow + rays.reflected + rays.refracted + rays.straight;
    const std::uint64_t tests = rays.triangles + rays.spheres + rays.boxes + rays.balls + rays.cones + rays.tori;
    return term("eye rays", fmt::format("{}, of which {} hit", rays.eye, rays.eye_hit)) +
           term("shadow rays", fmt::format("{}", rays.shadow)) + term("mirrored rays", fmt::format("{}", rays.reflected)) +
           term("refracted rays", fmt::format("{}", rays.refracted)) +
           term("a ray", fmt::format("{:.1f} nodes, {:.1f} tests of primitives", static_cast<double>(rays.nodes) / static_cast<double>(all),
                                     static_cast<double>(tests) / static_cast<double>(all)));
}

std::string figures(const Shown& shown) {
    std::string text = term("device", fmt::format("{:.2f} ms", shown.device_ms));
    if (shown.peak) text += term("peak error", fmt::format("{:.3f}", *shown.peak));
    if (shown.flip) text += term("FLIP", fmt::format("{:.4f}", *shown.flip));
    if (shown.rays) text += ray_terms(*shown.rays);
    return text;
}

std::string figure(const Shown& shown) {
    return fmt::format(R"(<figure><a href="{0}"><img src="{0}" alt="{1}" loading="lazy"></a>
<figcaption><strong>{1}</strong><dl>{2}</dl><code>{3}</code>
<details><summary>plan</summary><pre>{4}</pre></details></figcaption></figure>
)",
                       escaped(shown.file), escaped(shown.caption), figures(shown), escaped(shown.command), escaped(shown.plan));
}

std::string section(const Exhibit& exhibit) {
    std::string text = fmt::format("<h2>{}</h2>\n<p>{}</p>\n", escaped(exhibit.title), escaped(exhibit.text));
    if (!exhibit.reference.empty())
        text += fmt::format("<p class=\"soft\">Errors are measured against: {}. Peak: the largest difference of a channel, 0 to 1.</p>\n",
                            escaped(exhibit.reference));
    text += "<div class=\"row\">\n";
    for (const Shown& shown : exhibit.pictures) text += figure(shown);
    return text + "</div>\n";
}

} // namespace

std::string gallery_page(const std::string& device, const std::vector<Exhibit>& exhibits) {
    std::string page = fmt::format(R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>lightbench gallery</title><style>{}</style></head><body>
<h1>lightbench gallery</h1>
<p class="soft">Rendered by lightbench {} on {}. Times are those of the device, from its own timestamps, after one run to warm up (rays, whose shaders are ready before they run, go once).</p>
)",
                                   kStyle, LIGHTBENCH_VERSION, escaped(device));
    for (const Exhibit& exhibit : exhibits) page += section(exhibit);
    return page + "</body></html>\n";
}

} // namespace lightbench
