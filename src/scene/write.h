// Writes a Scene as a file; the format is chosen by the extension (.toml .nff .obj .ply). What a format cannot express is a Problem.
#pragma once

#include "scene/problem.h"
#include "scene/scene.h"

#include <filesystem>

namespace lightbench {

// Empty: written, whole or not at all. Numbers are printed so that reading them gives the same value.
// .toml  everything; meshes go into files of their own beside it (STEM-mesh-0.obj, or .ply when large)
// .nff   spheres, polygons, open cones and cylinders, point lights without attenuation: for scenes too large for TOML
// .obj .ply  the geometry of meshes and polygons alone
// Throws std::system_error if the file cannot be written (no such folder, disk full).
Problems write_scene(const Scene& scene, const std::filesystem::path& file);

} // namespace lightbench
