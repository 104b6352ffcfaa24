// The compiled part of toml++.
#define TOML_IMPLEMENTATION
#include "scene/toml_library.h"
