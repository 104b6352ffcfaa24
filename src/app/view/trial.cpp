#include "app/view/trial.h"

#include "app/command_line.h"
#include "gpu/spec_defaults.h"

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

// The picture's name in the folder does not matter: nobody looks at it.
std::vector<std::string> command_for(const Trial& trial, const Request& request, const fs::path& folder) {
    std::vector<std::string> words = {"/proc/self/exe", "render", trial.scene.string()};
    for (std::string& word : options_for(trial, request)) words.push_back(std::move(word));
    for (const char* word : {"--quiet", "--spirv", "-", "--stats", "-", "-o"}) words.emplace_back(word);
    words.push_back((folder / "trial.png").string());
    return words;
}

std::chrono::seconds limit_of(const Request& request) {
    return request.method == Method::raster ? kTrialLimit : kLongTrialLimit;
}

const char* const kPicture = "a first small picture, drawn aside,";

// What a child that ended by itself says of the picture.
Tried read_report(const Request& request, const ChildResult& child) {
    Tried tried;
    const auto stats = nlohmann::json::parse(child.out, nullptr, false);
    if (!stats.is_object()) return {fmt::format("{} said nothing of itself", kPicture)};
    for (const auto& name : stats["shaders"]) tried.used.insert(name.get<std::string>());
    if (const double all = request.method == Method::raster ? seconds_of(request, stats["time"]["device"].get<double>()) : 0;
        all > kMostSeconds)
        return {fmt::format("{} took so long that the picture shown would take about {:.0f} s", kPicture, all)};
    return tried;
}

Tried report_of(const Request& request, const ChildResult& child) {
    if (child.stopped) return {"", {}, true};
    if (child.timed_out) return {fmt::format("{} ran for more than {} s", kPicture, limit_of(request).count())};
    if (child.code > 128) return {fmt::format("{} ended the program with signal {}", kPicture, child.code - 128)};
    if (child.code != 0) return {fmt::format("{} failed: {}", kPicture, last_line(child.err))};
    return read_report(request, child);
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

TrialRun::TrialRun(Trial trial) : trial_(std::move(trial)), folder_("trial") {
    std::set<std::vector<std::string>> done;
    for (const Request& request : trial_.requests)
        if (done.insert(options_for(trial_, request)).second)
            pictures_.push_back({request, Child(command_for(trial_, request, folder_.path), limit_of(request))});
}

Tried TrialRun::finish(const ShaderModules& modules, const gpu::Constants& constants, const std::function<bool()>& stop) {
    ShaderModules set;
    for (const auto& [name, words] : modules) set[name] = gpu::with_defaults({name, words}, constants);
    const fs::path spirv = folder_.path / "spirv";
    write_modules(set, spirv);
    Tried all;
    for (auto& [request, child] : pictures_) {
        Tried one = report_of(request, child.finish(spirv.string() + "\n", limit_of(request), stop));
        if (one.stopped || !one.problem.empty()) return one;
        all.used.merge(one.used);
    }
    return all;
}

} // namespace lightbench::view
