// Writes a Scene as a file; the format is chosen by the extension (.toml .nff .obj .ply). What a format cannot express is a Problem.
#pragma once

#include "scene/problem.h"
#include "scene/scene.h"

#include <filesystem>
#include <string_view>

namespace lightbench {

// Empty: written, whole or not at all. Numbers are printed so that reading them gives the same value.
// .toml  everything; each mesh goes into a file of its own beside it, STEM-NAME.obj, or .ply if it is large
// .nff   spheres, polygons, open cones and cylinders, lights and materials as Haines knows them: for scenes too large for TOML
// .obj .ply  shape alone: meshes and polygons as one mesh in world space; cameras, lights and materials have no place there
// `comment` goes on top, line by line, where the format has comments.
// Throws std::system_error if the file cannot be written (no such folder, disk full).
Problems write_scene(const Scene& scene, const std::filesystem::path& file, std::string_view comment = {});

} // namespace lightbench
