// The panel's rows of buttons, and how much room their texts have. Pure: no interface.
#pragma once

#include "app/view/state.h"

namespace lightbench::view {

// Units of the interface at scale 1. The scroll bar's room is always kept: what fits does so while it shows.
constexpr float kPanelWidth = 366, kPanelPadding = 8, kScrollBar = 14, kSpacing = 6, kFramePadding = 4;
constexpr float kLetter = 7; // each, of the interface's font

enum class Rows { scene, surfaces, detail, compare };
using Row = std::vector<Action>;
std::span<const Row> rows_of(Rows part);

// "structure  [G]  bvh"
std::string button_text(Action action, const State& state);

// Of each of `n` buttons beside one another.
constexpr float button_width(std::size_t n) {
    return (kPanelWidth - 2 * kPanelPadding - kScrollBar - static_cast<float>(n - 1) * kSpacing) / static_cast<float>(n);
}

} // namespace lightbench::view
