// Greedy: each label takes the cheapest of the places around its point. Christensen, Marks, Shieber 1995, "An empirical study of algorithms
// for point-feature label placement", sec. 3 (there are better ones; plots of twenty points do not need them).
#include "measure/labels.h"

#include <algorithm>

namespace lightbench {
namespace {

double overlap(const PlotBox& a, const PlotBox& b) {
    const glm::dvec2 size = glm::min(a.high, b.high) - glm::max(a.low, b.low);
    return size.x > 0 && size.y > 0 ? size.x * size.y : 0;
}

double outside(const PlotBox& box, const PlotBox& area) {
    const glm::dvec2 over = glm::max(area.low - box.low, glm::dvec2(0)) + glm::max(box.high - area.high, glm::dvec2(0));
    return over.x + over.y;
}

double gap_between(const PlotBox& box, const glm::dvec2& point) {
    return glm::distance(glm::clamp(point, box.low, box.high), point);
}

// Beside another point a name would be read as that one's.
double confusion(const PlotBox& box, std::span<const PlotLabel> labels, const PlotLabel& own) {
    double sum = 0;
    for (const PlotLabel& other : labels) sum += &other == &own ? 0 : 2 * std::max(0.0, 14 - gap_between(box, other.point));
    return sum;
}

// Eight directions, right above first, at growing distances.
std::vector<PlotBox> places_around(const PlotLabel& label) {
    const glm::dvec2 size(kLetterWidth * static_cast<double>(letters(label.text)), kLabelHeight);
    const glm::dvec2 sides[] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}};
    std::vector<PlotBox> places;
    for (const double gap : {8.0, 15.0, 26.0, 42.0, 60.0})
        for (const glm::dvec2& side : sides) {
            const glm::dvec2 middle = label.point + side * (gap + 0.5 * size * glm::dvec2(1, 0.6));
            places.push_back({middle - 0.5 * size, middle + 0.5 * size});
        }
    return places;
}

bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

} // namespace

std::vector<PlotBox> place_labels(std::span<const PlotLabel> labels, const PlotBox& area, std::span<const PlotBox> obstacles) {
    std::vector<PlotBox> taken(obstacles.begin(), obstacles.end()), placed;
    for (const PlotLabel& label : labels) {
        PlotBox best{};
        double least = 1e300;
        for (const PlotBox& place : places_around(label)) {
            double cost = gap_between(place, label.point) + confusion(place, labels, label) + 50 * outside(place, area);
            for (const PlotBox& other : taken) cost += overlap(place, other);
            if (cost < least) least = cost, best = place;
        }
        taken.push_back(best), placed.push_back(best);
    }
    return placed;
}

std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

std::string shortened(const std::string& text, std::size_t most) {
    if (letters(text) <= most) return text;
    std::string out;
    std::size_t count = 0;
    for (const char c : text) {
        if (!continues(c) && ++count == most) break;
        out += c;
    }
    return out + "\u2026";
}

std::vector<std::string> wrapped(const std::string& text, std::size_t most) {
    std::vector<std::string> lines(1);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        if (!lines.back().empty() && letters(lines.back()) + 1 + letters(word) > most) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
        at = end + 1;
    }
    return lines;
}

} // namespace lightbench
