// The door of the program: builds the parser, runs what was asked for, turns every way of failing into a message and an exit code.
#include "app/commands.h"

#include "app/errors.h"
#include "gpu/errors.h"
#include "image/file_bytes.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fmt/format.h>
#include <new>
#include <system_error>

namespace lightbench {
namespace {

constexpr int kUser = 2, kEnvironment = 3;

int fail(int code, const std::string& sentence) {
    fmt::print(stderr, "lightbench: {}\n", sentence);
    return code;
}

int print_lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) fmt::print(stderr, "{}\n", line);
    return kUser;
}

// Help and version are results, and go to standard output.
int parse_failure(CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    fmt::print(stderr, "lightbench: {}\nlightbench --help and lightbench SUBCOMMAND --help say what there is\n", error.what());
    return kUser;
}

void add_all(CLI::App& app, int& exit_code) {
    for (auto add : {add_render, add_plan, add_compare, add_check, add_make, add_devices, add_gallery, add_probe, add_plot, add_cost,
                     add_numerics, add_view})
        add(app, exit_code);
    app.require_subcommand(1);
    const std::string version = fmt::format("lightbench {}", LIGHTBENCH_VERSION);
    app.set_version_flag("--version", version);
    for (CLI::App* sub : app.get_subcommands({})) sub->set_version_flag("--version", version);
}

int parse_and_run(int argc, char** argv) {
    CLI::App app{"lightbench: renders, compares and explains illumination models", "lightbench"};
    int exit_code = 0;
    add_all(app, exit_code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return parse_failure(app, error);
    }
    return exit_code;
}

} // namespace

int run(int argc, char** argv) {
    try {
        return parse_and_run(argc, argv);
    } catch (const UserError& error) {
        return print_lines(error.lines);
    } catch (const FileError& error) {
        return fail(error.blame == FileError::Blame::Input ? kUser : kEnvironment, error.what());
    } catch (const gpu::EnvironmentError& error) {
        return fail(kEnvironment, error.what());
    } catch (const std::system_error& error) {
        return fail(kEnvironment, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kEnvironment, "not enough memory");
    } catch (const std::length_error& error) { // a limit of scene/limits.h
        return fail(kUser, error.what());
    } catch (const std::exception& error) {
        fmt::print(stderr, "lightbench: an error that should not exist: {}\n", error.what());
        std::abort();
    }
}

} // namespace lightbench
