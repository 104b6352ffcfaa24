// report.html: what a cost report says as one file that needs no other, no network and no program but a browser.
#pragma once

#include "measure/report.h"

#include <filesystem>

namespace lightbench {

// Pictures are read from folder / point.image and put into the page. Tables are plain HTML, readable without script; charts, pictures and
// sorting are added by the page's own script. Throws FileError if a picture cannot be read.
std::string report_html(const CostReport& report, const std::filesystem::path& folder);

} // namespace lightbench
