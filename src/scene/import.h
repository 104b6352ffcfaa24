// Imported scene files: OBJ/MTL, glTF 2.0/GLB, PLY, STL, decoded by Assimp in a child process with limits of its own.
// In: a file that nobody here wrote. Out: the plain Scene, or every problem found; lights and cameras only if the file has some.
#pragma once

#include "scene/load.h"

#include <filesystem>

namespace lightbench {

// By extension alone, whatever its case: .obj .gltf .glb .ply .stl.
bool is_imported_format(const std::filesystem::path& file);

// The files that `file` names (material libraries, buffers, pictures) are relative to its own folder and may not leave `root`, the folder of
// the scene that places it, unless options.allow_outside; an empty root is the file's own folder.
// A mesh without `two_sided` in its material and a remark per thing that Scene cannot express are what the caller may expect.
Loaded import_file(const std::filesystem::path& file, const LoadOptions& options = {}, const std::filesystem::path& root = {});

} // namespace lightbench
