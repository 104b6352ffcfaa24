#include "app/view/trial.h"

#include "app/command_line.h"
#include "gpu/errors.h"
#include "gpu/spec_defaults.h"
#include "image/child_process.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <stdlib.h>

namespace lightbench::view {

namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "lightbench-trial-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw gpu::EnvironmentError(
                fmt::format("{}: no folder can be made there: {}", fs::temp_directory_path().string(), std::strerror(errno)));
        path = name;
    }
    Folder(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

// Few pixels, a sample each, one shot: every pipeline runs, and little more.
Request small(Request r, Method method) {
    if (r.method != method) r.accel_parameters = {};
    r.method = method, r.size = glm::uvec2(64, 36), r.crop.reset();
    r.spp = 1, r.sampling = Sampling::none, r.filter = Filter::box;
    r.radiosity.shots = 1, r.radiosity.pick.reset(), r.radiosity.show = Show::light;
    r.radiosity.solver = Solver::progressive;
    return r;
}

std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \n");
    if (end == text.npos) return "it said nothing";
    const std::size_t begin = text.rfind('\n', end);
    return text.substr(begin == text.npos ? 0 : begin + 1, end - (begin == text.npos ? 0 : begin + 1) + 1);
}

} // namespace

std::string try_shaders(const Trial& trial, Method method, const ShaderModules& modules, const gpu::Constants& constants) {
    const Folder folder;
    ShaderModules set;
    for (const auto& [name, words] : modules) set[name] = gpu::with_defaults({name, words}, constants);
    write_modules(set, folder.path / "spirv");
    std::vector<std::string> words = {"/proc/self/exe", "render", trial.scene.string()};
    for (std::string& word : options_of(small(trial.request, method))) words.push_back(std::move(word));
    words.insert(words.end(), trial.options.begin(), trial.options.end());
    for (std::string word : {std::string("--quiet"), std::string("--spirv"), (folder.path / "spirv").string(), std::string("-o"),
                             (folder.path / "trial.png").string()})
        words.push_back(std::move(word));
    const auto limit = method == trial.request.method ? kTrialLimit : kOtherTrialLimit;
    const ChildResult child = run_child(words, "", limit);
    if (child.timed_out) return fmt::format("a first small picture, drawn aside, ran for more than {} s", limit.count());
    if (child.code > 128) return fmt::format("a first small picture, drawn aside, ended the program with signal {}", child.code - 128);
    if (child.code == 2 && method != trial.request.method) return ""; // the scene or its options are not of that method
    if (child.code != 0) return fmt::format("a first small picture, drawn aside, failed: {}", last_line(child.err));
    return "";
}

} // namespace lightbench::view
