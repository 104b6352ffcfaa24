#include "app/command_line.h"

#include "plan/explain.h"
#include "scene/write_number.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr const char* kSampling[] = {"none", "uniform", "jittered", "adaptive"};
constexpr const char* kFilters[] = {"box", "gaussian"};
constexpr const char* kStructures[] = {"none", "bvh", "sphere-bvh", "grid", "octree"};
constexpr const char* kSolvers[] = {"progressive", "full"};
constexpr const char* kShows[] = {"light", "patches", "form-factors", "hemicube"};
constexpr const char* kModels[] = {"phong", "cook-torrance"};
constexpr const char* kLaws[] = {"none", "linear", "inverse-square"};

template <class T, std::size_t n> std::string name_in(const char* const (&names)[n], T value) {
    return names[static_cast<std::size_t>(value)];
}

struct Words {
    std::vector<std::string> list;
    void add(const char* flag, std::string value) { list.push_back(flag), list.push_back(std::move(value)); }
    void add_if(bool given, const char* flag, std::string value) {
        if (given) add(flag, std::move(value));
    }
    void flag_if(bool given, const char* flag) {
        if (given) list.push_back(flag);
    }
};

void add_image(Words& words, const Request& r) {
    const Request d;
    words.add_if(r.method != d.method, "--method", std::string(name_of(r.method)));
    words.add_if(r.shading != d.shading, "--shading", std::string(name_of(r.shading)));
    words.add_if(r.precision != d.precision, "--precision", "float64");
    if (r.size) words.add("--size", fmt::format("{}x{}", r.size->x, r.size->y));
    if (r.crop) words.add("--crop", fmt::format("{},{},{},{}", r.crop->offset.x, r.crop->offset.y, r.crop->size.x, r.crop->size.y));
    if (r.placed)
        words.add("--camera", text_of(*r.placed));
    else
        words.add_if(!r.camera.empty(), "--camera", r.camera);
    if (r.frame) words.add("--frame", fmt::format("{}", *r.frame));
    words.add_if(r.subdivide != d.subdivide, "--subdivide", fmt::format("{}", r.subdivide));
    words.add_if(r.seed != d.seed, "--seed", fmt::format("{}", r.seed));
    words.add_if(r.exposure != d.exposure, "--exposure", decimal(r.exposure));
    words.flag_if(r.terms, "--terms");
    words.flag_if(r.count, "--count");
}

void add_samples(Words& words, const Request& r) {
    const Request d;
    words.add_if(r.sampling != d.sampling, "--sampling", name_in(kSampling, r.sampling));
    words.add_if(r.spp != d.spp, "--spp", fmt::format("{}", r.spp));
    if (r.filter == Filter::gaussian) {
        words.add("--filter", name_in(kFilters, r.filter));
        words.add("--filter-width", fmt::format("{},{}", decimal(r.filter_width), decimal(r.filter_sigma)));
    }
    if (r.sampling != Sampling::adaptive) return;
    words.add_if(r.contrast != d.contrast, "--contrast", decimals(r.contrast, ","));
    words.add_if(r.max_level != d.max_level, "--max-level", fmt::format("{}", r.max_level));
}

void add_edits(Words& words, const Request& r) {
    if (r.model) words.add("--model", name_in(kModels, *r.model));
    if (r.attenuation) words.add("--attenuation", name_in(kLaws, *r.attenuation));
    std::string without;
    for (std::size_t i = 0; i < kStrippable.size(); ++i)
        if (r.edits.without >> i & 1) without += fmt::format("{}{}", without.empty() ? "" : ",", kStrippable[i]);
    words.add_if(!without.empty(), "--without", without);
}

std::string text_of(const AccelParameters& p) {
    std::string text;
    const auto add = [&](const std::string& item) { text += (text.empty() ? "" : ",") + item; };
    if (p.leaf > 0) add(fmt::format("leaf={}", p.leaf));
    if (p.cells != glm::uvec3(0)) add(fmt::format("cells={},{},{}", p.cells.x, p.cells.y, p.cells.z));
    if (p.density > 0) add("density=" + decimal(p.density));
    if (p.depth > 0) add(fmt::format("depth={}", p.depth));
    if (p.builder == TreeBuilder::device) add("builder=device");
    return text;
}

void add_rays(Words& words, const Request& r) {
    const Request d;
    words.add_if(r.depth != d.depth, "--depth", fmt::format("{}", r.depth));
    words.add_if(r.cutoff != d.cutoff, "--cutoff", decimal(r.cutoff));
    words.flag_if(r.opaque_shadows, "--opaque-shadows");
    words.add_if(r.accel != d.accel, "--accel", name_in(kStructures, r.accel));
    if (const std::string text = text_of(r.accel_parameters); !text.empty()) words.add("--accel-param", text);
}

void add_radiosity(Words& words, const RadiosityParameters& r) {
    const RadiosityParameters d;
    words.add_if(r.hemicube != d.hemicube, "--hemicube", fmt::format("{}", r.hemicube));
    words.add_if(r.patch > 0, "--patch", decimal(r.patch));
    words.add_if(r.element > 0, "--element", decimal(r.element));
    words.add_if(r.solver != d.solver, "--solver", name_in(kSolvers, r.solver));
    if (r.shots) words.add("--shots", fmt::format("{}", *r.shots));
    words.add_if(r.until != d.until, "--until", decimal(r.until));
    words.flag_if(!r.ambient, "--no-ambient");
    words.flag_if(r.feed, "--feed-lights");
    words.add_if(r.show != d.show, "--show", name_in(kShows, r.show));
    if (r.pick) words.add("--pick", fmt::format("{},{}", r.pick->x, r.pick->y));
    words.add_if(!r.correct_near, "--form-factors", "hemicube");
}

bool is_plain(const std::string& word) {
    return !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/%@") == word.npos;
}

} // namespace

std::string text_of(const Camera& camera) {
    std::string text = fmt::format("{}:{}:{}:{}", decimals(camera.position, ","), decimals(camera.target, ","), decimals(camera.up, ","),
                                   decimal(degrees_for(camera.fov)));
    if (camera.hither > 0) text += ":" + decimal(camera.hither);
    return text;
}

std::vector<std::string> options_of(const Request& request) {
    Words words;
    add_image(words, request);
    add_samples(words, request);
    add_edits(words, request);
    add_rays(words, request);
    if (request.method == Method::radiosity) add_radiosity(words, request.radiosity);
    return words.list;
}

std::string shell_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        line += line.empty() ? "" : " ";
        if (is_plain(word)) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
    }
    return line;
}

} // namespace lightbench
