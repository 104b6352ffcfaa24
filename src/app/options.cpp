#include "app/options.h"

#include "app/accel_parameters.h"
#include "app/numbers.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

// One option of the command line.
struct OptionRow {
    const char* flag;
    const char* value; // how the help calls it; null: a switch
    const char* help;
};

constexpr OptionRow kOptions[] = {
    {"--method", "METHOD", "how light is computed: raster, raytrace, radiosity"},
    {"--shading", "MODE", "where the model is evaluated: flat, gouraud, phong (default)"},
    {"--subdivide", "N", "refinement levels of every surface, 0 to 8"},
    {"--model", "NAME", "in the place of the materials' own: phong or cook-torrance, with a highlight of the same width"},
    {"--attenuation", "LAW", "in the place of the lights' own: none, linear or inverse-square"},
    {"--size", "WxH", "pixels; default the scene's [film], else 1280x720"},
    {"--crop", "X,Y,W,H", "render this part of the image only"},
    {"--camera", "NAME",
     "one of the scene's cameras (default the first), or your own: PX,PY,PZ:TX,TY,TZ:UX,UY,UZ:FOV, its position, target, up "
     "and vertical field of view in degrees, and after one more colon the distance before which nothing is seen"},
    {"--without", "EFFECTS", "leave out: texture, bump, environment, transparency, reflection; several, with commas or again"},
    {"--frame", "N", "turntable: the camera turned by 3 N degrees about the target"},
    {"--frames", "A:B", "frames A to B, both included; -o with %04d"},
    {"--sampling", "PATTERN", "of the samples of a pixel: none, uniform, jittered, adaptive (raytrace: where neighbours differ)"},
    {"--spp", "N", "samples a pixel, a square; 1 and 4 are multisampling unless a pattern is named"},
    {"--seed", "N", "of everything random; default 0"},
    {"--exposure", "STOPS", "the picture is multiplied by 2^STOPS before it is displayed"},
    {"--filter", "NAME", "reconstruction: box, one pixel wide, or gaussian (raytrace)"},
    {"--filter-width", "R[,SIGMA]", "of the Gaussian: its radius, pixels, 1 to 16, and its sigma; default 1.5, and a third of the radius"},
    {"--contrast", "R,G,B", "of adaptive sampling: (max - min) / (max + min) above which it splits; default 0.25,0.2,0.4"},
    {"--max-level", "N", "of adaptive sampling: times that a pixel is split in four at most, 0 to 6; default 2"},
    {"--precision", "NAME", "of Phong's terms at each pixel (raster): float32 (default), or float64 where the device has it"},
    {"--terms", nullptr, "with an .exr: a layer for each term, reflected and refracted light, shadow, attenuation, normal, depth, object"},
    {"--stats", "FILE", "JSON about the run; - for standard output"},
    {"--count", nullptr, "fill rays and tests of --stats"},
    {"--progress", "WHEN", "auto, always, never"},
    {"--quiet", nullptr, "no messages but errors"},
    {"--device", "D", "Vulkan device: part of its name, or its index; also LIGHTBENCH_DEVICE"},
    {"--allow-outside", nullptr, "the scene may name files outside of its folder"},
    {"--depth", "N", "levels of the ray tree, the eye ray the first; default 5"},
    {"--cutoff", "X", "rays of a smaller weight are not sent; default 0"},
    {"--opaque-shadows", nullptr, "what one can see through casts shadows all the same"},
    {"--accel", "NAME", "structure that rays walk through: none, bvh (default), sphere-bvh, grid, octree"},
    {"--accel-param", "k=v",
     "of the structure: leaf=N, cells=L,M,N, density=X, depth=N, builder=host|device; several, with commas or again"},
    {"--hemicube", "N", "pixels along an edge of a hemi-cube, even, 8 to 1024; default 64"},
    {"--patch", "SIZE", "longest edge of a patch, which sends light, metres"},
    {"--element", "SIZE", "longest edge of an element, which receives light, metres; default a quarter of --patch"},
    {"--solver", "NAME", "of radiosity: progressive (default), or full: all form factors at once"},
    {"--shots", "N", "progressive: at most so many"},
    {"--until", "X", "progressive: until this share of the light is unshot; default 0.001"},
    {"--no-ambient", nullptr, "without an ambient term for the light that is still unshot"},
    {"--show", "WHAT", "of radiosity: light (default), patches, form-factors or hemicube (of the patch that --pick names)"},
    {"--pick", "X,Y", "the pixel whose patch is shown"},
    {"--solution", "FILE", "radiosity: goes on from what this file holds, if it exists, and keeps the solution in it"},
    {"--feed-lights", nullptr, "lights without area feed the surfaces even where some glow"},
    {"--shader", "FILE", "GLSL whose functions take the place of those of the same name below shaders/lib/; several, with commas or again"},
    {"--slider", "NAME=X", "value of a constant that a shader marks as @slider(least, most); several, with commas or again"},
    {"--form-factors", "NAME", "corrected (default): analytic where surfaces are near; hemicube: without that"},
};

struct Parser {
    const Given& given;
    Problems& problems;

    void problem(const char* flag, std::string text) { problems.push_back({flag, 0, 0, std::move(text)}); }
    bool has(const char* flag) const { return given.contains(flag); }
    std::string text(const char* flag) const { return has(flag) ? given.find(flag)->second : ""; }

    // Calls take(value) if the option was given and `parse` understands it; else says what it must be.
    template <class Parse, class Take> void value(const char* flag, Parse parse, const char* must_be, Take take) {
        if (!has(flag)) return;
        if (const auto parsed = parse(text(flag))) return take(*parsed);
        problem(flag, fmt::format("\"{}\" must be {}", text(flag), must_be));
    }

    // The index of the given name.
    std::optional<std::size_t> choice(const char* flag, const std::vector<std::string>& names) {
        if (!has(flag)) return std::nullopt;
        const std::string name = text(flag);
        if (const auto at = std::find(names.begin(), names.end(), name); at != names.end())
            return static_cast<std::size_t>(at - names.begin());
        problem(flag, fmt::format("\"{}\" is unknown; it must be {}", name, alternatives(names)));
        return std::nullopt;
    }
};

void parse_precision(Parser& p, Request& r) {
    if (const auto i = p.choice("--precision", {"float32", "float64"})) r.precision = static_cast<Precision>(*i);
    if (r.precision == Precision::float64 && (r.method != Method::raster || r.shading != Shading::phong))
        p.problem("--precision", "float64 belongs to --method raster with --shading phong; elsewhere it must be float32");
}

void parse_terms(Parser& p, Request& r) {
    r.terms = p.has("--terms");
    if (r.terms && r.method == Method::radiosity) p.problem("--terms", "radiosity has no layers: --method raster and raytrace have");
    if (r.terms && r.sampling == Sampling::adaptive)
        p.problem("--terms", "layers of adaptive samples would not add up: each would be split where its own contrast is");
}

void parse_choices(Parser& p, SceneOptions& o) {
    if (const auto i = p.choice("--method", {"raster", "raytrace", "radiosity"})) o.request.method = static_cast<Method>(*i);
    if (const auto i = p.choice("--accel", {"none", "bvh", "sphere-bvh", "grid", "octree"})) o.request.accel = static_cast<Structure>(*i);
    if (const auto i = p.choice("--filter", {"box", "gaussian"})) o.request.filter = static_cast<Filter>(*i);
    if (const auto i = p.choice("--shading", {"flat", "gouraud", "phong"})) o.request.shading = static_cast<Shading>(*i);
    parse_precision(p, o.request);
    if (const auto i = p.choice("--sampling", {"none", "uniform", "jittered", "adaptive"})) o.request.sampling = static_cast<Sampling>(*i);
    parse_terms(p, o.request);
    if (const auto i = p.choice("--model", {"phong", "cook-torrance"})) o.request.model = static_cast<Model>(*i);
    if (const auto i = p.choice("--attenuation", {"none", "linear", "inverse-square"}))
        o.request.attenuation = static_cast<Attenuation>(*i);
    if (const auto i = p.choice("--progress", {"auto", "always", "never"})) o.progress = static_cast<Progress>(*i);
}

void parse_image(Parser& p, Request& r) {
    p.value("--size", parse_size, "WIDTHxHEIGHT in pixels, like 1280x720", [&](glm::uvec2 size) { r.size = size; });
    p.value("--crop", parse_rect, "X,Y,W,H in pixels, like 0,0,64,64", [&](const Rect& rect) { r.crop = rect; });
    p.value("--subdivide", parse_unsigned<8>, "a whole number from 0 to 8", [&](std::uint32_t n) { r.subdivide = n; });
    p.value("--seed", parse_unsigned<0xffffffffu>, "a whole number from 0 to 4294967295", [&](std::uint32_t n) { r.seed = n; });
    // 2^127 is the largest power of two that a float holds.
    p.value("--exposure", parse_number<-127, 127>, "a number of stops from -127 to 127",
            [&](double x) { r.exposure = static_cast<float>(x); });
    r.placed = parse_camera(p.text("--camera"));
    if (!r.placed) r.camera = p.text("--camera");
}

void parse_edits(Parser& p, SceneEdits& edits) {
    if (!p.has("--without")) return;
    const std::vector<std::string> names(kStrippable.begin(), kStrippable.end());
    const std::string text = p.text("--without");
    for (const std::string_view word : split(text, ',')) {
        const auto at = std::find(names.begin(), names.end(), word);
        if (at == names.end())
            p.problem("--without", fmt::format("\"{}\" is unknown; it must be {}", word, alternatives(names)));
        else
            edits.without |= 1u << (at - names.begin());
    }
}

void parse_rays(Parser& p, Request& r) {
    p.value("--depth", parse_unsigned<255>, "a whole number from 1 to 255", [&](std::uint32_t n) {
        r.depth = n;
        if (n == 0) p.problem("--depth", "0 sees nothing; it must be at least 1, the eye ray");
    });
    p.value("--cutoff", parse_number<0, 1>, "a weight from 0 to 1", [&](double x) { r.cutoff = static_cast<float>(x); });
    r.opaque_shadows = p.has("--opaque-shadows"), r.count = p.has("--count");
    if (p.has("--accel-param"))
        for (std::string& text : parse_accel_parameters(p.text("--accel-param"), r.accel, r.accel_parameters))
            p.problem("--accel-param", std::move(text));
}

// Samples of an adaptive picture are shared between pixels and counted by none of them.
void parse_adaptive(Parser& p, Request& r) {
    if (r.method != Method::raytrace) p.problem("--sampling", "adaptive sampling needs rays: --method raytrace");
    if (r.spp > 1)
        p.problem("--spp", fmt::format("{} samples a pixel, but --sampling adaptive chooses their number; --max-level bounds it", r.spp));
    if (r.filter != Filter::box) p.problem("--filter", "adaptive sampling takes the mean over each pixel: it must be box");
    p.value("--contrast", parse_contrast, "R,G,B, three numbers from 0 to 1", [&](const glm::vec3& c) { r.contrast = c; });
    p.value("--max-level", parse_unsigned<6>, "a whole number from 0 to 6", [&](std::uint32_t n) { r.max_level = n; });
}

void parse_samples(Parser& p, Request& r) {
    p.value("--spp", parse_square<1024>, "a square from 1 to 1024 (1, 4, 9, 16, ...)", [&](std::uint32_t n) { r.spp = n; });
    if (p.text("--sampling") == "none" && r.spp > 1)
        p.problem("--sampling", fmt::format("none takes one sample a pixel, but --spp is {}; it must be uniform or jittered", r.spp));
    if (r.sampling == Sampling::adaptive) parse_adaptive(p, r);
    for (const char* flag : {"--contrast", "--max-level"})
        if (p.has(flag) && r.sampling != Sampling::adaptive) p.problem(flag, "belongs to --sampling adaptive");
    if (p.has("--filter-width") && r.filter != Filter::gaussian) p.problem("--filter-width", "belongs to --filter gaussian");
    p.value("--filter-width", parse_filter, "a radius from 1 to 16 pixels, and a sigma from 0.1 to 16 after a comma if wanted",
            [&](glm::vec2 f) { r.filter_width = f.x, r.filter_sigma = f.y; });
}

std::optional<unsigned> parse_hemicube(std::string_view text) {
    const auto n = parse_unsigned<1024>(text);
    return n && *n >= 8 && *n % 2 == 0 ? n : std::nullopt;
}

std::optional<double> parse_length(std::string_view text) {
    const auto length = parse_whole<double>(text);
    return length && *length > 0 && std::isfinite(*length) ? length : std::nullopt;
}

std::optional<double> parse_share(std::string_view text) {
    const auto share = parse_number<0, 1>(text);
    return share && *share > 0 && *share < 1 ? share : std::nullopt;
}

void parse_radiosity(Parser& p, const Request& request, RadiosityParameters& r) {
    const char* length = "a length in metres, above 0";
    p.value("--hemicube", parse_hemicube, "an even number from 8 to 1024", [&](unsigned n) { r.hemicube = n; });
    p.value("--patch", parse_length, length, [&](double x) { r.patch = x; });
    p.value("--element", parse_length, length, [&](double x) { r.element = x; });
    p.value("--shots", parse_unsigned<0xffffffffu>, "a whole number from 0 to 4294967295", [&](unsigned n) { r.shots = n; });
    p.value("--until", parse_share, "a share between 0 and 1", [&](double x) { r.until = x; });
    if (const auto i = p.choice("--solver", {"progressive", "full"})) r.solver = static_cast<Solver>(*i);
    if (const auto i = p.choice("--form-factors", {"corrected", "hemicube"})) r.correct_near = *i == 0;
    if (const auto i = p.choice("--show", {"light", "patches", "form-factors", "hemicube"})) r.show = static_cast<Show>(*i);
    p.value("--pick", parse_pixel, "X,Y, a pixel, like 320,180", [&](glm::uvec2 pixel) { r.pick = pixel; });
    if ((r.show == Show::form_factors || r.show == Show::hemicube) && !p.has("--pick"))
        p.problem("--show", "--pick X,Y must say of which patch");
    r.ambient = !p.has("--no-ambient"), r.feed = p.has("--feed-lights");
    if (r.solver == Solver::full && p.has("--element"))
        p.problem("--element", "belongs to --solver progressive: with the full matrix every patch is one element");
    for (const char* flag : {"--hemicube", "--patch", "--element", "--solver", "--shots", "--until", "--no-ambient", "--feed-lights",
                             "--solution", "--show", "--pick", "--form-factors"})
        if (p.has(flag) && request.method != Method::radiosity) p.problem(flag, "belongs to --method radiosity");
}

void parse_frames(Parser& p, SceneOptions& o) {
    p.value("--frame", parse_integer, "a whole number", [&](int n) { o.request.frame = n; });
    p.value("--frames", parse_range, "A:B, whole numbers with A <= B and at most 100000 frames",
            [&](const FrameRange& range) { o.frames = range; });
    if (p.has("--frame") && p.has("--frames")) p.problem("--frame", "one frame or --frames, not both");
}

void parse_sliders(Parser& p, std::map<std::string, float>& sliders) {
    const std::string text = p.text("--slider"); // the views are of it
    for (const std::string_view pair : split(text, ',')) {
        const std::size_t equals = pair.find('=');
        const auto value = equals == std::string_view::npos || equals == 0 ? std::nullopt : parse_whole<float>(pair.substr(equals + 1));
        const std::string name(pair.substr(0, equals));
        if (!value || !std::isfinite(*value))
            p.problem("--slider", fmt::format("\"{}\" must be NAME=NUMBER, like gain=0.5", pair));
        else if (!sliders.emplace(name, *value).second)
            p.problem("--slider", fmt::format("{} has two values; one of them must go", name));
    }
}

// One a line. A name with commas that is a file's is one, too.
void parse_shaders(Parser& p, SceneOptions& o) {
    const std::string texts = p.text("--shader");
    if (p.has("--shader"))
        for (const std::string_view text : split(texts, '\n')) {
            std::error_code ignored;
            const bool whole = std::filesystem::exists(text, ignored);
            for (const std::string_view file : whole ? std::vector{text} : split(text, ',')) o.shaders.emplace_back(file);
        }
    if (p.has("--slider")) parse_sliders(p, o.sliders);
}

} // namespace

std::string alternatives(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return text;
}

void declare_scene_options(CLI::App& sub, Given& given, bool scene_required) {
    sub.add_option_function<std::string>(
           "SCENE", [&given](const std::string& text) { given["SCENE"] = text; }, "scene file")
        ->required(scene_required);
    for (const OptionRow& row : kOptions) {
        const std::string flag = row.flag;
        if (row.value == nullptr)
            sub.add_flag_callback(
                flag, [&given, flag] { given[flag] = ""; }, row.help);
        else {
            CLI::Option* option = sub.add_option_function<std::string>(
                flag, [&given, flag](const std::string& text) { given[flag] = text; }, row.help);
            option->type_name(row.value);
            if (flag == "--accel-param" || flag == "--slider" || flag == "--without")
                option->multi_option_policy(CLI::MultiOptionPolicy::Join)->delimiter(',');
            if (flag == "--shader") option->multi_option_policy(CLI::MultiOptionPolicy::Join)->delimiter('\n');
        }
    }
}

SceneOptions parse_scene_options(const Given& given, Problems& problems) {
    SceneOptions options;
    Parser parser{given, problems};
    options.scene = parser.text("SCENE");
    parse_choices(parser, options);
    parse_image(parser, options.request);
    parse_edits(parser, options.request.edits);
    parse_samples(parser, options.request);
    parse_rays(parser, options.request);
    parse_radiosity(parser, options.request, options.request.radiosity);
    parse_frames(parser, options);
    options.device = parser.text("--device"), options.stats = parser.text("--stats");
    options.solution = parser.text("--solution");
    parse_shaders(parser, options);
    options.count = parser.has("--count"), options.quiet = parser.has("--quiet"), options.allow_outside = parser.has("--allow-outside");
    return options;
}

} // namespace lightbench
