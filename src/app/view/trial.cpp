#include "app/view/trial.h"

#include "app/command_line.h"
#include "gpu/spec_defaults.h"
#include "image/child_process.h"
#include "image/temporary_folder.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lightbench::view {

namespace fs = std::filesystem;

namespace {

// Few pixels and samples, one shot: every pipeline of the picture runs, and little more. The rasteriser's is drawn at once and cannot be given
// up half-way: of it enough pixels are drawn to tell how long all would take.
Request small(Request r) {
    r.size = r.method == Method::raster ? glm::uvec2(256, 144) : glm::uvec2(64, 36), r.crop.reset();
    r.spp = std::min(r.spp, 4u), r.max_level = std::min(r.max_level, 1u);
    r.radiosity.shots = 1, r.radiosity.pick.reset(), r.radiosity.show = Show::light;
    r.radiosity.hemicube = std::min(r.radiosity.hemicube, 16u);
    return r;
}

std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \n");
    if (end == text.npos) return "it said nothing";
    const std::size_t begin = text.rfind('\n', end);
    return text.substr(begin == text.npos ? 0 : begin + 1, end - (begin == text.npos ? 0 : begin + 1) + 1);
}

std::vector<std::string> options_for(const Trial& trial, const Request& request) {
    std::vector<std::string> words = options_of(small(request));
    words.insert(words.end(), trial.options.begin(), trial.options.end());
    return words;
}

// Seconds that all pixels take if these took so long.
double seconds_of(const Request& request, double small_milliseconds) {
    const glm::uvec2 all = request.crop ? request.crop->size : request.size.value_or(glm::uvec2(0)), few = *small(request).size;
    return small_milliseconds / 1000 * (double(all.x) * all.y) / (double(few.x) * few.y);
}

Tried try_picture(const Trial& trial, const Request& request, const fs::path& folder, const std::function<bool()>& stop) {
    std::vector<std::string> words = {"/proc/self/exe", "render", trial.scene.string()};
    for (std::string& word : options_for(trial, request)) words.push_back(std::move(word));
    for (const std::string& word : {std::string("--quiet"), std::string("--spirv"), (folder / "spirv").string(), std::string("--stats"),
                                    std::string("-"), std::string("-o"), (folder / "trial.png").string()})
        words.push_back(word);
    const auto limit = request.method == Method::raster ? kTrialLimit : kLongTrialLimit;
    const ChildResult child = run_child(words, "", limit, stop);
    const std::string picture = "a first small picture, drawn aside,";
    if (child.stopped) return {"", {}, true};
    if (child.timed_out) return {fmt::format("{} ran for more than {} s", picture, limit.count())};
    if (child.code > 128) return {fmt::format("{} ended the program with signal {}", picture, child.code - 128)};
    if (child.code != 0) return {fmt::format("{} failed: {}", picture, last_line(child.err))};
    Tried tried;
    const auto stats = nlohmann::json::parse(child.out, nullptr, false);
    if (!stats.is_object()) return {fmt::format("{} said nothing of itself", picture)};
    for (const auto& name : stats["shaders"]) tried.used.insert(name.get<std::string>());
    if (const double all = request.method == Method::raster ? seconds_of(request, stats["time"]["device"].get<double>()) : 0;
        all > kMostSeconds)
        return {fmt::format("{} took so long that the picture shown would take about {:.0f} s", picture, all)};
    return tried;
}

} // namespace

std::string key_of(const Trial& trial) {
    std::string key = trial.scene.string();
    for (Request request : trial.requests) {
        request.placed.reset(), request.seed = 0;
        for (const std::string& word : options_for(trial, request)) key += "\n" + word;
    }
    return key;
}

Tried try_shaders(const Trial& trial, const ShaderModules& modules, const gpu::Constants& constants, const std::function<bool()>& stop) {
    const TemporaryFolder folder("trial");
    ShaderModules set;
    for (const auto& [name, words] : modules) set[name] = gpu::with_defaults({name, words}, constants);
    write_modules(set, folder.path / "spirv");
    Tried all;
    std::set<std::vector<std::string>> done;
    for (const Request& request : trial.requests) {
        if (!done.insert(options_for(trial, request)).second) continue;
        Tried one = try_picture(trial, request, folder.path, stop);
        if (one.stopped || !one.problem.empty()) return one;
        all.used.merge(one.used);
    }
    return all;
}

} // namespace lightbench::view
