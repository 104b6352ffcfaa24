// One door for scene files: the loader is chosen by the extension (.toml .nff .obj .gltf .glb .ply .stl).
#pragma once

#include "scene/problem.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>

namespace lightbench {

struct LoadOptions {
    bool allow_outside = false;     // may a scene name files outside its own folder?
    std::size_t max_problems = 100; // further ones are counted, not listed
};

struct Loaded {
    std::optional<Scene> scene; // present iff `problems` is empty
    Problems problems;          // if some are not listed, the last one says how many
    std::size_t unlisted = 0;   // found, beyond LoadOptions::max_problems
};

// Never throws for bad input: every problem found comes back with its line. Throws std::bad_alloc and the like only.
Loaded load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

} // namespace lightbench
