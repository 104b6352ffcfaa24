// lightbench check FILE...: reads scene files and prints every problem. Exit code 1 if there is one: the files failed the check.
#include "app/commands.h"

#include "plan/complete.h"
#include "render/materials.h"
#include "scene/check.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace lightbench {
namespace {

struct CheckArguments {
    std::vector<std::string> files;
    bool allow_outside = false;
};

// Pictures are decoded when a plan reads them; here all are.
void add_picture_problems(const Scene& scene, Problems& problems) {
    for (const Picture& picture : scene.pictures) try {
            decode_picture(picture);
        } catch (const FileError& error) {
            const std::string file = picture.file.string(), what = error.what();
            problems.push_back({file, 0, 0, what.starts_with(file + ": ") ? what.substr(file.size() + 2) : what});
        }
}

// Problems of the file, and of what would keep it from being rendered as it is (a camera without direction).
std::vector<std::string> lines_of(const std::string& file, const LoadOptions& options) {
    Loaded loaded = load_scene(file, options);
    if (loaded.scene) {
        loaded.problems = complete(*loaded.scene, {}).problems;
        add_picture_problems(*loaded.scene, loaded.problems);
    }
    return problem_lines(loaded, file);
}

bool check_one(const std::string& file, const LoadOptions& options) {
    const std::vector<std::string> lines = lines_of(file, options);
    for (const std::string& line : lines) fmt::print("{}\n", line);
    if (lines.empty()) fmt::print("0 problems in {}\n", file);
    return lines.empty();
}

bool check(const CheckArguments& arguments) {
    LoadOptions options;
    options.allow_outside = arguments.allow_outside;
    bool good = true;
    for (const std::string& file : arguments.files) good = check_one(file, options) && good;
    return good;
}

} // namespace

void add_check(CLI::App& app, int& exit_code) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* sub = app.add_subcommand("check", "reads scene files and prints every problem, file:line: what is wrong");
    sub->add_option("FILE", arguments->files, "scene files")->required();
    sub->add_flag("--allow-outside", arguments->allow_outside, "scenes may name files outside of their folders");
    sub->callback([arguments, &exit_code] { exit_code = check(*arguments) ? 0 : 1; });
}

} // namespace lightbench
