// What the page's script reads: the report as JSON, with the pictures as data: URIs.
#pragma once

#include "measure/report.h"

#include <filesystem>

namespace lightbench {

// Holds no "<", so that nothing in it can end the element it stands in. Pictures (PNG, below `folder`) are there once, however often they
// are shown. Throws FileError if one cannot be read.
std::string report_data(const CostReport& report, const std::filesystem::path& folder);

// RFC 4648, section 4.
std::string base64(std::string_view bytes);

// Every metric of the curve's points, its main one first.
std::vector<std::string> metrics_of(const CostCurve& curve);

} // namespace lightbench
