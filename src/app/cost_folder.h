// The folder of a cost report: what stands in its way, what an earlier report left there, the files of a new one.
#pragma once

#include "measure/report.h"
#include "scene/problem.h"

#include <filesystem>

namespace lightbench {

// As typed after -o: no folder to put it in, files where folders must be, folders where files must be.
void check_folder(const std::string& typed, Problems& problems);

struct ReportFolder {
    std::filesystem::path path;
    bool fresh = false; // begin_report() was called
};

// Makes the folder and images/ in it, and takes away what an earlier report left, so that none of its pictures stands beside new numbers. Once;
// call it when the first picture is there, so that a mistake does not cost a report. Throws FileError.
void begin_report(ReportFolder& folder);

// cost.csv, cost.json, the plots, report.html. Throws FileError, gpu::EnvironmentError.
void write_report(const CostReport& report, ReportFolder& folder);

// Pictures of a curve that was not finished.
void remove_pictures(const CostCurve& curve, const ReportFolder& folder);

} // namespace lightbench
