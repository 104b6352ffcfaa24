// Limits on what a scene file may ask for, so that a small file cannot exhaust the machine. Each is named in the message that cites it.
#pragma once

#include <cstddef>

namespace lightbench::limits {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;  // a scene or mesh file
constexpr std::size_t kMaxTomlBytes = std::size_t{1} << 26;  // a TOML file: the parser needs 20 times that; larger scenes go through NFF
constexpr std::size_t kMaxTomlValues = std::size_t{1} << 23; // values of a TOML file
constexpr std::size_t kMaxStringBytes = 65536;               // one name or text in a scene file
constexpr std::size_t kMaxObjects = std::size_t{1} << 22;    // objects of one scene (sphereflake of depth 6 has 597 872)
constexpr std::size_t kMaxTriangles = std::size_t{1} << 26;  // triangles after tessellation; 32-bit indices, 6 GiB of streams
constexpr std::size_t kMaxElements = std::size_t{1} << 22;   // of radiosity
constexpr std::size_t kMaxLights = std::size_t{1} << 20;
constexpr std::size_t kMaxMaterials = std::size_t{1} << 20;
constexpr std::size_t kMaxPolygonPoints = 65536;
constexpr std::size_t kMaxNesting = 64;   // tables in TOML, nodes in glTF
constexpr std::size_t kMaxIncludes = 64;  // files that one scene places
constexpr double kMaxCoordinate = 1e15;   // metres; float32 squares stay finite after normalisation
constexpr unsigned kMaxImageSide = 16384; // pixels

} // namespace lightbench::limits
