// What both sides of the comparison are given and give back: rays in the frame, and the distance of what each meets.
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <vector>

namespace lightbench {

constexpr float kMiss = std::numeric_limits<float>::infinity();

struct BenchRay {
    glm::vec3 origin{0}, direction{0, 0, 1}; // frame; unit
    float limit = kMiss;                     // what lies beyond is not met
    glm::vec3 normal{0};                     // of the surface that a shadow ray leaves
};

// How it is traced. Eight that go together may share a walk; of a shadow ray only whether it arrives is asked.
enum class Travel { together, alone, shadow };

// Frame units, kMiss for none; of a shadow ray 0 if it is stopped.
using Distances = std::vector<float>;

} // namespace lightbench
