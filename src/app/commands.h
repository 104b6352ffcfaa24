// The command line: one sub-command a file. Each adds itself to the parser; its callback runs it and sets the exit code if it is not 0.
#pragma once

namespace CLI {
class App;
}

namespace lightbench {

// Parses and runs; never throws. Returns the exit code: 0 fine, 1 a comparison or check failed, 2 the user's input, 3 the environment.
int run(int argc, char** argv);

void add_render(CLI::App& app, int& exit_code);
void add_plan(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_make(CLI::App& app, int& exit_code);
void add_devices(CLI::App& app, int& exit_code);
void add_gallery(CLI::App& app, int& exit_code);
void add_probe(CLI::App& app, int& exit_code);
void add_plot(CLI::App& app, int& exit_code);
void add_cost(CLI::App& app, int& exit_code);
void add_numerics(CLI::App& app, int& exit_code);
void add_view(CLI::App& app, int& exit_code);

} // namespace lightbench
