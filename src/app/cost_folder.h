// The folder of a cost report: what stands in its way, what an earlier report left there, the files of a new one.
#pragma once

#include "measure/report.h"
#include "scene/problem.h"

#include <filesystem>

namespace lightbench {

// As typed after -o: no folder to put it in, files where folders must be, folders where files must be.
void check_folder(const std::string& typed, Problems& problems);

// Folders where pictures and plots of these curves go, of which the points need no errors yet.
void check_outputs(const std::string& typed, const CostReport& outline, Problems& problems);

// That the folder can be made and written in, before minutes are spent; what it makes it takes away again. Throws FileError.
void try_folder(const std::filesystem::path& path);

struct ReportFolder {
    std::filesystem::path path;
    bool plots = true;  // SVG, too
    bool fresh = false; // begin_report() was called
};

// Makes the folder and images/ in it, and takes away what an earlier report left, so that none of its pictures stands beside new numbers. Once;
// call it when the first picture is there, so that a mistake does not cost a report. Throws FileError.
void begin_report(ReportFolder& folder);

// cost.csv, cost.json, report.html, the plots. Returns why there are no plots any more, if so: what was measured stays. Throws FileError.
std::string write_report(const CostReport& report, ReportFolder& folder);

// Pictures of a curve that was not finished.
void remove_pictures(const CostCurve& curve, const ReportFolder& folder);

} // namespace lightbench
