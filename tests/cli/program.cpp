#include "program.h"

#include <algorithm>
#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>

namespace lightbench::cli {

namespace fs = std::filesystem;

namespace {
const std::string kBallText = ball_scene(64, 48, "[environment]\nambient = [0.1, 0.1, 0.1]\nbackground = [0.05, 0.1, 0.2]\n");
}
const char* const kBall = kBallText.c_str();

const char* const kPlain = R"([[light]]
type = "directional"
direction = [0, -1, -1]
[[material]]
name = "chalk"
diffuse = 0.8
[[object]]
shape = "sphere"
material = "chalk"
)";

namespace {

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (char c : text) {
        if (c == '\'') out += "'\\'";
        out += c;
    }
    out += '\'';
    return out;
}

fs::path fresh_folder() {
    std::string name = (fs::temp_directory_path() / "lightbench-cli-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    return name;
}

} // namespace

Ran run(const std::vector<std::string>& arguments, const Environment& more, const std::string& before) {
    const fs::path folder = fresh_folder();
    std::string command = before + (before.empty() ? "" : "; ");
    command += "LIGHTBENCH_VALIDATION=1 ";
    for (const auto& [name, value] : more) command += name + "=" + quoted(value) + " ";
    command += quoted(LIGHTBENCH_PROGRAM);
    for (const std::string& argument : arguments) command += " " + quoted(argument);
    command += " >" + quoted((folder / "out").string()) + " 2>" + quoted((folder / "err").string()) + " </dev/null";
    const int status = std::system(command.c_str());
    Ran ran;
    ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ran.out = read_text(folder / "out"), ran.err = read_text(folder / "err");
    fs::remove_all(folder);
    return ran;
}

Cli::Cli() : folder(fresh_folder()) {}
Cli::~Cli() {
    fs::remove_all(folder);
}

std::string Cli::scene(const std::string& text, const std::string& name) const {
    write_text(folder / name, text);
    return in_folder(name);
}

std::vector<std::string> Cli::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace lightbench::cli
