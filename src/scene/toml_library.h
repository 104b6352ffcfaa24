// The one place that chooses how toml++ is built: compiled once, in toml_library.cpp, because its parser takes six seconds to compile.
#pragma once

#define TOML_HEADER_ONLY 0
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>
