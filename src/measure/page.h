// The parts of the report's page, kept in the program: files of measure/page/ and the plotting library d3 (Bostock, Ogievetsky, Heer 2011,
// "D3: data-driven documents").
#pragma once

#include <string_view>

namespace lightbench {

// By the name of the file; empty if there is none of that name.
std::string_view page_part(std::string_view name);

} // namespace lightbench
