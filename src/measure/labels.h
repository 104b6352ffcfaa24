// Where the names of points stand in a plot, so that they cover neither each other nor points. In: pixels. Out: pixels, y upwards.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace lightbench {

struct PlotBox {
    glm::dvec2 low, high;
};

struct PlotLabel {
    std::string text;
    glm::dvec2 point; // what it names
};

constexpr double kLabelHeight = 15; // of a line, and
constexpr double kLetterWidth = 7;  // of a letter on average, at the labels' font size of 12 pixels

// A box a label, in order: the nearest place that is free of `obstacles` and of the labels before it, else the least covered.
std::vector<PlotBox> place_labels(std::span<const PlotLabel> labels, const PlotBox& area, std::span<const PlotBox> obstacles);

std::size_t letters(const std::string& text); // characters of UTF-8

// At most `most` letters, the last of them an ellipsis if some are cut off.
std::string shortened(const std::string& text, std::size_t most);

// Broken between words into lines of at most `most` letters, where the words allow it.
std::vector<std::string> wrapped(const std::string& text, std::size_t most);

} // namespace lightbench
