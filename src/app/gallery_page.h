// The gallery's page: pictures side by side with their times, errors and plans. In: what was rendered. Out: one HTML file, readable offline.
#pragma once

#include "render/render.h"

#include <optional>
#include <string>
#include <vector>

namespace lightbench {

struct Shown {
    std::string caption, file, command, plan; // file: beside the page
    double device_ms = 0;
    std::optional<double> peak, flip;  // against the exhibit's reference: largest difference of display values, mean FLIP
    std::optional<RayStatistics> rays; // if they were counted
};

struct Exhibit {
    std::string title, text, reference; // reference: the caption of the picture that errors are measured against, if any
    std::vector<Shown> pictures;
};

std::string gallery_page(const std::string& device, const std::vector<Exhibit>& exhibits);

} // namespace lightbench
