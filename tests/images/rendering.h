// From a Scene in memory to an image, the way the program does it; one device for all tests of a process, validation on.
#pragma once

#include "plan/complete.h"
#include "render/render.h"

namespace lightbench::testing {

gpu::Device& test_device();

struct Rendered {
    Plan plan;
    View view;
    RasterGeometry geometry;
    RenderOutput output;
};

// Completes, decides, tessellates, renders. `request.output` is radiance unless said otherwise. Fails the test on a validation message.
Rendered render_scene(Scene scene, Request request);

// One polygon, one material, no light: the beginning of most scenes here. The camera stands at `eye` and looks at the origin.
Scene plane_scene(glm::dvec3 eye);
Light point_light(glm::dvec3 position, glm::vec3 intensity, Attenuation law = Attenuation::none);

// Points, a sun and a spot, with attenuation and without, around the origin.
std::vector<Light> lights_of_every_kind();
// The same scene `s` times as large; pictures do not change.
void scale_scene(Scene& scene, double s);

Request radiance_request(Shading shading, glm::uvec2 size = {64, 48});

glm::dvec3 pixel(const ImageF& image, unsigned x, unsigned y);

} // namespace lightbench::testing
