// The command line: one sub-command a file.
#pragma once

namespace lightbench {

// Parses and runs; never throws. Returns the exit code: 0 fine, 1 a comparison or check failed, 2 the user's input, 3 the environment.
int run(int argc, char** argv);

} // namespace lightbench
