// The compilation of edited shaders: a copy of the folder with functions replaced and sliders made, glslang over it, errors brought home.
#include "gpu/errors.h"
#include "image/child_process.h"
#include "image/file_bytes.h"
#include "render/live/fits.h"
#include "render/live/shader_tree.h"
#include "render/shaders.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <future>
#include <regex>
#include <sstream>
#include <thread>
#include <unistd.h>

namespace lightbench {

namespace fs = std::filesystem;

namespace {

struct Stage {
    fs::path folder;
    Stage() {
        std::string name = (fs::temp_directory_path() / "lightbench-shaders-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw gpu::EnvironmentError(
                fmt::format("{}: no folder can be made there: {}", fs::temp_directory_path().string(), std::strerror(errno)));
        folder = name;
    }
    Stage(const Stage&) = delete;
    ~Stage() {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
};

// Where names of the copy came from.
struct Origins {
    const fs::path& root;
    const std::map<std::string, fs::path>& user_files;
    const std::map<std::string, std::string>& texts;
    std::string stage;

    ShaderError error_at(std::string file, unsigned line, std::string message) const {
        if (file.starts_with(stage)) file = file.substr(stage.size() + 1);
        ShaderError error{file, line, std::move(message), ""};
        if (const auto text = texts.find(file); text != texts.end() && line > 0) error.text = line_of(text->second, line);
        if (const auto user = user_files.find(file); user != user_files.end())
            error.file = user->second.string();
        else if (texts.contains(file) || !file.starts_with('/'))
            error.file = (root / file).string();
        return error;
    }
};

void add(ShaderErrors& errors, const ShaderError& error) {
    const auto same = [&](const ShaderError& e) { return e.file == error.file && e.line == error.line && e.message == error.message; };
    if (std::ranges::none_of(errors, same)) errors.push_back(error);
}

// What follows from an error before it, or says no more than that there was one.
bool says_nothing(std::string_view message) {
    return message.find("compilation terminated") != message.npos || message.find("cannot be preceded by another token") != message.npos ||
           message.find("No code generated") != message.npos;
}

// "ERROR: lib/phong.glsl:62: 'x' : undeclared identifier". What has no line is of the linker, and follows from what has.
void read_errors(const std::string& text, const Origins& origins, ShaderErrors& errors) {
    static const std::regex located(R"(^ERROR: ([^:\n]{1,500}):(\d{1,9}): ([^\n]{0,1000}))");
    ShaderErrors without_place;
    std::istringstream lines(text);
    std::smatch match;
    const std::size_t before = errors.size();
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("ERROR: ") || says_nothing(line)) continue;
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (line.size() < 2000 && std::regex_match(line, match, located))
            add(errors, origins.error_at(match[1], static_cast<unsigned>(std::stoul(match[2])), match[3]));
        else
            without_place.push_back(origins.error_at("", 0, line.substr(7)));
    }
    if (errors.size() == before)
        for (const ShaderError& error : without_place) add(errors, error);
}

struct Output {
    std::string name;
    ChildResult child;
    std::vector<std::uint32_t> words;
};

Output compile_one(const fs::path& stage, const std::string& name, std::chrono::milliseconds limit) {
    const std::string out = (stage / (name + ".spv")).string();
    Output output{name,
                  run_child({"glslangValidator", "--quiet", "-V", "--target-env", "vulkan1.3", fmt::format("-I{}", stage.string()), "-o",
                             out, (stage / name).string()},
                            "", limit),
                  {}};
    if (output.child.code != 0) return output;
    const auto bytes = read_file(out);
    output.words.resize(bytes.size() / 4);
    std::memcpy(output.words.data(), bytes.data(), output.words.size() * 4);
    return output;
}

void take(Output output, const Origins& origins, CompiledShaders& result) {
    const auto fail = [&](std::string message) { add(result.errors, origins.error_at(output.name, 0, std::move(message))); };
    if (!output.child.started())
        throw gpu::EnvironmentError("glslangValidator, which compiles edited shaders, is not installed (package glslang-tools)");
    if (output.child.timed_out) return fail("compiling it takes too long");
    if (output.child.code != 0) {
        const std::size_t before = result.errors.size();
        read_errors(output.child.out + output.child.err, origins, result.errors);
        if (result.errors.size() == before && result.errors.empty())
            fail(fmt::format("the compiler ended with code {}", output.child.code));
        return;
    }
    const auto sentences = misfits(find_shader(output.name), output.words);
    for (const std::string& sentence : sentences) fail(sentence);
    if (sentences.empty()) result.modules[output.name] = std::move(output.words);
}

// Several at a time, as there are cores.
std::vector<Output> compile_all(const fs::path& stage, const std::set<std::string>& names, std::chrono::milliseconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    std::vector<std::string> list(names.begin(), names.end());
    std::vector<Output> outputs(list.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < list.size(); i = next++) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
            outputs[i] = compile_one(stage, list[i], std::max(left, std::chrono::milliseconds(1)));
        }
    };
    std::vector<std::future<void>> workers;
    const std::size_t most = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 8);
    for (std::size_t i = 0; i < std::min(most, list.size()); ++i) workers.push_back(std::async(std::launch::async, work));
    for (auto& worker : workers) worker.get();
    return outputs;
}

} // namespace

CompiledShaders ShaderTree::compile(const std::set<std::string>& entry_points, std::chrono::milliseconds limit) const {
    CompiledShaders result;
    const Stage stage;
    const Origins origins{root_, user_files_, texts_, stage.folder.string()};
    auto staged = stage_texts(result);
    for (const auto& [name, text] : staged) {
        fs::create_directories((stage.folder / name).parent_path());
        std::ofstream(stage.folder / name, std::ios::binary) << text;
    }
    std::set<std::string> present;
    for (const std::string& name : entry_points)
        if (texts_.contains(name))
            present.insert(name);
        else
            add(result.errors, origins.error_at(name, 0, "is gone"));
    for (Output& output : compile_all(stage.folder, present, limit)) take(std::move(output), origins, result);
    return result;
}

} // namespace lightbench
