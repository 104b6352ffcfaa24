// The eye ray of a sample. In: `camera`, an EyePush by whatever way it comes; wants_ray(). Out: the ray.
#ifndef LIGHTBENCH_RAYTRACE_EYE_GLSL
#define LIGHTBENCH_RAYTRACE_EYE_GLSL

#include "lib/vector.glsl"
#include "raytrace/sample.glsl"
#include "raytrace/tile.glsl"

// Point of the image that the i-th sample of the tile looks through, pixels, (0, 0) its upper left corner.
//   key  what numbers of the ray are drawn from
vec2 tile_point(uint i, out uint key) {
    uvec2 pixel = uvec2(camera.tile_x, camera.tile_y) + tile_pixel(i, uvec2(camera.tile_size & 0xffffu, camera.tile_size >> 16u));
    vec2 within = camera.shift;
    key = 0u; // nothing is drawn from it
    if (wants_ray(RAY_JITTER | RAY_SCATTER))
        within = sample_within(pixel, camera.sample_index, camera.seed, camera.shift, camera.cell, key);
    return vec2(ivec2(pixel)) + within; // pixels beside the image, which a wide filter sees, have negative coordinates too
}

Ray eye_ray(vec2 at, uint key) {
    vec3 d = fast_normalize(camera.corner + at.x * camera.across + at.y * camera.down);
    float after = camera.hither / max(dot(d, camera.axis), 1.1754944e-38);
    return Ray(camera.eye, after, d, kNothing, 0.0, 1u | 7u << 8u, 1.0, key);
}

#endif
