// PLY and STL, read once for what Assimp accepts in silence or reports without a place: sizes, counts, numbers and indices.
// In: the bytes of a file. Out: problems with their lines (text) or byte counts (binary).
#pragma once

#include "scene/import_report.h"

#include <cstdint>
#include <span>

namespace lightbench::importer {

using ByteView = std::span<const std::uint8_t>;

// G. Turk 1994, "The PLY polygon file format".
void check_ply(ByteView file, Report& report);

// 3D Systems 1989, "StereoLithography interface specification". Returns the part of the file that holds triangles: all of a text file,
// 84 + 50 n bytes of a binary one.
ByteView check_stl(ByteView file, Report& report);

} // namespace lightbench::importer
