// The table of effects: one row each. A row says which bit of the mask it sets, when a scene calls for it and why, and what it reads.
// Rows without a bit are effects that no method of this version draws: a scene that asks for one is told what it gets instead.
#pragma once

#include "plan/facts.h"
#include "plan/request.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

struct Verdict {
    bool wanted = false;
    std::string reason;
};

struct Effect {
    std::string_view name;
    std::uint32_t bit = 0; // EFFECT_... (shaders/shared/effects.h); 0: not of the illumination model
    Verdict (*wanted)(const Facts&, const Request&);
    std::vector<std::string_view> reads; // resources, besides the geometry
    std::string_view instead;            // what a method that does not draw it draws in its place
    std::uint32_t ray_bit = 0;           // RAY_... (shaders/shared/rays.h): drawn where rays are traced
};

std::span<const Effect> effects();

// Whether anything of the image depends on lights: there are some, and a surface that answers to them (or a layer of the light itself).
bool is_lit(const Facts& facts, const Request& request);

} // namespace lightbench
