// Sub-commands whose names are fixed but which this version does not have: one sentence, so that nobody looks for a mistake of their own.
#include "app/commands.h"
#include "app/errors.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lightbench {

void add_later(CLI::App& app, int&) {
    for (const char* name : {"view"}) {
        CLI::App* sub = app.add_subcommand(name, "not in this version yet");
        sub->allow_extras();
        sub->callback([name] { throw UserError(fmt::format("lightbench {}", name), "not in this version yet"); });
    }
}

} // namespace lightbench
