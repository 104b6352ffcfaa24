// MTL, the material libraries of OBJ (the format: Alias|Wavefront and D. Ramey, "MTL material format", 1995).
// In: the text of a library. Out: its materials by name, as Scene has them but for the pictures, which stay names of files.
#pragma once

#include "scene/import_report.h"
#include "scene/scene.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace lightbench::importer {

// A map_... statement: the file's name as written, and those of its options that Scene can express.
struct MtlMap {
    std::string file;
    glm::dvec2 scale{1};     // -s
    double strength = 1;     // -bm
    bool normal_map = false; // `norm`: directions, not heights
    bool clamp = false;      // -clamp on: the border's color beyond 0 to 1
};

struct MtlMaterial {
    Material material;
    std::optional<MtlMap> diffuse_map, bump_map;
};

using MtlLibrary = std::map<std::string, MtlMaterial, std::less<>>;

// What each statement becomes:
//   Kd Ks Ke Ns Ni   diffuse, specular, emission, shininess, ior; Kd and Ks are brought into [0, 1]
//   d, Tr            opacity d or 1 - Tr (S13)
//   illum            which of the other statements count; 2 where it is absent. What the format says, and what becomes of it. Rasterised
//                    pictures have no rays: there 3 and up show highlights, and what lies behind where opacity is below 1
//                      0   color only                           lit as 1, with a remark: S1 to S6 have no unlit surfaces
//                      1   diffuse                              no highlights, no reflection
//                      2   and highlights                       no reflection
//                      3   and reflection by rays               reflection Ks
//                      4   glass, reflection by rays            reflection Ks, opacity (S13): of d < 1 the part 1 - d is filtered by Tf
//                      5   mirror with Fresnel                  reflection Ks, Fresnel
//                      6   refraction, no Fresnel               reflection Ks, transmission Tf with index Ni (S16)
//                      7   refraction with Fresnel              the same, Fresnel
//                      8   reflection without rays              as 3: rays are ours to cast or not
//                      9   glass without rays                   as 4
//                      10  shadows onto invisible surfaces      as 2
//   Tf               of 4, 6, 7 and 9 only; absent it is 1. Writers put 0 0 0 and 1 1 1 alike into opaque materials, so it makes nothing
//                    transparent by itself, and 0 0 0 does not filter
//   map_Kd, map_bump, bump, norm   texture and bump; a height map's amplitude is -bm times the default. -s and -clamp of map_Kd
//   Ka               not used: ambient light is weighted by Kd (S1)
// Adds to `into`; a name that is there already is replaced, as the later library wins.
void read_mtl(std::string_view text, const std::string& file, MtlLibrary& into, Report& report);

} // namespace lightbench::importer
