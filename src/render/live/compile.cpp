// The compilation of edited shaders: a copy of the folder with functions replaced and sliders made, glslang over it, errors brought home.
#include "gpu/errors.h"
#include "image/child_process.h"
#include "image/file_bytes.h"
#include "image/temporary_folder.h"
#include "render/live/compiler_errors.h"
#include "render/live/endless.h"
#include "render/live/fits.h"
#include "render/live/shader_tree.h"
#include "render/shaders.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <future>
#include <thread>

namespace lightbench {

namespace fs = std::filesystem;

namespace {

struct Output {
    std::string name;
    ChildResult child;
    std::vector<std::uint32_t> words;
};

// `lines`: with the place of everything.
Output compile_one(const fs::path& stage, const std::string& name, std::chrono::milliseconds limit, const std::function<bool()>& stop,
                   bool lines = false) {
    const std::string out = (stage / (name + ".spv")).string();
    std::vector<std::string> command = {"glslangValidator", "--quiet", "-V", "--target-env", "vulkan1.3"};
    if (lines) command.emplace_back("-g");
    command.insert(command.end(), {fmt::format("-I{}", stage.string()), "-o", out, (stage / name).string()});
    Output output{name, run_child(command, "", limit, stop), {}};
    if (output.child.code != 0) return output;
    const auto bytes = read_file(out);
    output.words.resize(bytes.size() / 4);
    std::memcpy(output.words.data(), bytes.data(), output.words.size() * 4);
    return output;
}

// A loop without a way out, at its place, for which the shader is compiled once more: one for all shaders, as they share it mostly. True: there
// is such a loop.
bool find_endless(const Output& output, const Origins& origins, const std::function<bool()>& stop, ShaderErrors& errors) {
    const std::string message = "this loop has no way out";
    if (!endless_loop(output.words)) return false;
    if (std::ranges::find(errors, message, &ShaderError::message) != errors.end()) return true;
    const Output placed = compile_one(origins.stage, output.name, std::chrono::seconds(10), stop, true);
    const auto loop = endless_loop(placed.words).value_or(EndlessLoop{});
    add_error(errors, origins.error_at(loop.file.empty() ? output.name : loop.file, loop.line, message));
    return true;
}

void take(Output output, const Origins& origins, const std::function<bool()>& stop, CompiledShaders& result) {
    const auto fail = [&](std::string message) { add_error(result.errors, origins.error_at(output.name, 0, std::move(message))); };
    if (!output.child.started())
        throw gpu::EnvironmentError("glslangValidator, which compiles edited shaders, is not installed (package glslang-tools)");
    if (output.child.timed_out) {
        const std::string message = "compiling it takes too long";
        if (std::ranges::find(result.errors, message, &ShaderError::message) == result.errors.end()) fail(message); // one for all
        return;
    }
    if (output.child.code != 0) {
        if (!read_errors(output.child.out + output.child.err, output.name, origins, result.errors))
            fail(fmt::format("the compiler ended with code {}", output.child.code));
        return;
    }
    const auto sentences = misfits(find_shader(output.name), output.words);
    for (const std::string& sentence : sentences) fail(sentence);
    if (sentences.empty() && !find_endless(output, origins, stop, result.errors)) result.modules[output.name] = std::move(output.words);
}

// Several at a time, as there are cores.
std::vector<Output> compile_all(const fs::path& stage, const std::set<std::string>& names, std::chrono::milliseconds limit,
                                const std::function<bool()>& stop) {
    const auto end = std::chrono::steady_clock::now() + limit;
    std::vector<std::string> list(names.begin(), names.end());
    std::vector<Output> outputs(list.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < list.size(); i = next++) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
            outputs[i] = compile_one(stage, list[i], std::max(left, std::chrono::milliseconds(1)), stop);
            if (outputs[i].child.stopped) return;
        }
    };
    std::vector<std::future<void>> workers;
    const std::size_t most = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 8);
    for (std::size_t i = 0; i < std::min(most, list.size()); ++i) workers.push_back(std::async(std::launch::async, work));
    for (auto& worker : workers) worker.get();
    return outputs;
}

} // namespace

// The copy that is compiled. It is kept: ext4 searches long for inodes after so many files were deleted.
struct ShaderTree::Stage {
    TemporaryFolder folder{"shaders"};
    std::map<std::string, std::string> texts;
};

void ShaderTree::update(Stage& stage, const std::map<std::string, std::string>& texts) {
    for (const auto& [name, text] : stage.texts)
        if (!texts.contains(name)) fs::remove(stage.folder.path / name);
    for (const auto& [name, text] : texts) {
        if (const auto known = stage.texts.find(name); known != stage.texts.end() && known->second == text) continue;
        fs::create_directories((stage.folder.path / name).parent_path());
        stage.texts.erase(name);
        std::ofstream out(stage.folder.path / name, std::ios::binary);
        if (out << text << std::flush) stage.texts[name] = text; // what is cut short, on a full disk, is written again
    }
    std::erase_if(stage.texts, [&](const auto& known) { return !texts.contains(known.first); });
}

CompiledShaders ShaderTree::compile(const std::set<std::string>& entry_points, std::chrono::milliseconds limit,
                                    const std::function<bool()>& stop) const {
    CompiledShaders result;
    std::set<std::string> spoilt, present;
    const auto staged = stage_texts(result, spoilt);
    if (entry_points.empty()) return result;
    if (!stage_) stage_ = std::make_shared<Stage>();
    const fs::path& stage = stage_->folder.path;
    update(*stage_, staged);
    const Origins origins{root_, sources_.user_files, sources_.texts, stage.string()};
    for (const std::string& name : entry_points)
        if (!sources_.texts.contains(name))
            add_error(result.errors, origins.error_at(name, 0, "is gone"));
        else if (sources_.texts.at(name).find_first_not_of(" \t\r\n") == std::string::npos && !spoilt.contains(name))
            add_error(result.errors, origins.error_at(name, 0, "is empty"));
        else if (!spoilt.contains(name))
            present.insert(name);
    std::vector<Output> outputs = compile_all(stage, present, limit, stop);
    result.stopped = std::ranges::any_of(outputs, [](const Output& output) { return output.child.stopped; });
    if (result.stopped) return result;
    for (Output& output : outputs) take(std::move(output), origins, stop, result);
    return result;
}

} // namespace lightbench
