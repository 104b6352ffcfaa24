// Completes a scene that leaves things out: a camera that frames it, a headlight, the size of the image; each is a line of the plan.
#pragma once

#include "plan/plan.h"
#include "scene/problem.h"
#include "scene/tessellate.h"

namespace lightbench {

// Everything about the camera that the passes need, in double; world space and the frame.
struct View {
    glm::dvec3 eye{0};             // world
    glm::dmat4 view_from_world{1}; // rigid
    glm::dmat4 clip_from_view{1};  // reversed z, infinite far plane, y down in clip space as Vulkan has it
    double near = 0;               // metres
    double fov = 0;                // radians, vertical
    glm::uvec2 size{0};            // pixels
    double pixel_angle() const;    // radians that a pixel spans at the image's centre
    // clip_from_frame = clip_from_view * view_from_world * world_from_frame, composed in double with the eye as the pivot, then rounded.
    glm::mat4 clip_from_frame(const Frame& frame, glm::dvec2 shift_pixels = glm::dvec2(0)) const;
    glm::vec3 eye_in_frame(const Frame& frame) const;
    // World direction, unit, of the ray through a point of the image: (0, 0) is the upper left corner, (0.5, 0.5) that pixel's centre.
    glm::dvec3 direction_through(glm::dvec2 pixel) const;
};

// clip_from_view of a View; `aspect` is width over height.
glm::dmat4 perspective(double fov, double aspect, double near);

// A turn has this many frames of 3 degrees: frame N of the turntable is frame N + 120.
constexpr int kTurntableFrames = 120;

struct Completed {
    View view;
    std::vector<Line> notes;
    bool headlight = false; // was added
    Camera camera;          // that was chosen, turned
};

// Leaves out what `request` names, puts the laws that it names in the place of the scene's own (plan/laws.h), adds what it lacks (camera, light), chooses the camera that `request` names, turns it by the turntable's frame.
// Returns problems for a name that no camera has, an image beyond limits, a crop outside of it, a camera without a direction.
struct CompleteResult {
    std::optional<Completed> completed;
    Problems problems;
};
CompleteResult complete(Scene& scene, const Request& request);

} // namespace lightbench
