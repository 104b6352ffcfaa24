// Wavefront OBJ, read line by line for what Assimp accepts in silence or reports without a place (the format: Alias|Wavefront, "Advanced
// Visualizer" manual, appendix B1). In: the text. Out: problems with their lines, the libraries and materials that it names, and the text
// with comments in place of all that is not geometry, since Assimp takes any line that begins with f, p or l for a face, point or line.
#pragma once

#include "scene/import_report.h"

#include <string>
#include <string_view>
#include <vector>

namespace lightbench::importer {

struct ObjName {
    std::string name;
    unsigned line = 0;
};

struct ObjContents {
    std::vector<ObjName> libraries; // the rest of each mtllib line, as it stands
    std::vector<ObjName> materials; // each usemtl name once, where it is first used
    std::size_t vertices = 0, faces = 0;
};

// Keeps the length of the text, but for a line end that it adds.
ObjContents check_obj(std::string& text, Report& report);

} // namespace lightbench::importer
