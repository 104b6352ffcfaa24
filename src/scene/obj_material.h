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
};

struct MtlMaterial {
    Material material;
    std::optional<MtlMap> diffuse_map, bump_map;
};

using MtlLibrary = std::map<std::string, MtlMaterial, std::less<>>;

// What each statement becomes:
//   Kd Ks Ke Ns Ni   diffuse, specular, emission, shininess, ior; Kd and Ks are brought into [0, 1]
//   d, Tr            opacity d or 1 - Tr (S13)
//   illum            0, 1: no specular. 3 and up: mirror reflection with Ks; else, and where it is absent, none.
//                    6, 7: refraction (S16) with Tf, 1 where it is absent. 5, 7: Fresnel
//   Tf               only with illum 6 and 7: writers put 0 0 0 and 1 1 1 alike into opaque materials
//   map_Kd, map_bump, bump, norm   texture and bump; a height map's amplitude is -bm times the default
//   Ka               not used: ambient light is weighted by Kd (S1)
// Adds to `into`; a name that is there already is replaced, as the later library wins.
void read_mtl(std::string_view text, const std::string& file, MtlLibrary& into, Report& report);

} // namespace lightbench::importer
