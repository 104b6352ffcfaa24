// The memory layouts that C++ and GLSL share, written once. Scalar block layout; every size is a multiple of 16 bytes, so that
// each struct is a whole number of RGBA32UI texels for fetch4(). Lengths are in frame units (scene/tessellate.h).
#ifndef LIGHTBENCH_SHARED_LAYOUTS_H
#define LIGHTBENCH_SHARED_LAYOUTS_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace lightbench::gpu_layout {
using glm::mat4;
using glm::uvec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;
#endif

const uint kLightPoint = 0u;
const uint kLightDirectional = 1u;
const uint kLightSpot = 2u;
const uint kAttenuationNone = 0u;
const uint kAttenuationLinear = 1u;
const uint kAttenuationInverseSquare = 2u;

struct PointPosition {
    vec3 position;     // frame
    uint polygon;      // vertices: the polygon that this vertex provokes (any, if none); polygons: their own number
};

struct PointNormal {
    vec3 normal;       // unit
    uint material;     // index into materials
};

struct Material {
    vec3 diffuse;      // kd
    float shininess;   // n
    vec3 specular;     // ks
    uint pad1;
    vec3 emission;     // radiance
    float pad0;
};

struct Light {
    vec3 position;     // frame; directional: unit vector towards the light
    uint type;         // kLight...
    vec3 intensity;    // Ip, scaled so that the attenuation law of the frame gives the world's value
    uint attenuation;  // kAttenuation...
    vec3 axis;         // unit, the way a spot shines
    float d0;          // frame units
    float cos_outer;   // cosine of a spot's half-angle
    float cos_inner;   // cosine of the angle where it begins to fade, >= cos_outer
    float pad0, pad1;
};

// Push constants of shading and drawing: 112 bytes of the 128 that every driver has.
struct ShadePush {
    mat4 clip_from_frame;
    vec3 eye;          // frame
    uint first_light;  // lights are summed in [first_light, end_light): bounded work per invocation
    vec3 ambient;      // Ia
    uint end_light;
    uint point_count;  // compute: points to shade
    uint pad0, pad1, pad2;
};

struct DisplayPush {
    uvec2 offset;      // pixels, of the crop in the image
    uvec2 size;        // pixels, of the crop
    float gain;        // 2^exposure
    uint pad0, pad1, pad2;
};

struct AccumulatePush {
    uvec2 size;        // pixels
    float weight;      // of the frame that is added
    uint first;        // 1: the sum is written, not added to
};

// Written by display/display.comp before any clamp.
struct Census {
    uint non_finite;   // pixels with a NaN or an infinity in a channel
    uint visited;      // pixels looked at: the host checks that none is missing
};

#ifdef __cplusplus
static_assert(sizeof(PointPosition) == 16 && sizeof(PointNormal) == 16);
static_assert(sizeof(Material) == 48 && sizeof(Light) == 64);
static_assert(sizeof(ShadePush) == 112 && sizeof(DisplayPush) == 32 && sizeof(AccumulatePush) == 16 && sizeof(Census) == 8);
} // namespace lightbench::gpu_layout
#endif
#endif
