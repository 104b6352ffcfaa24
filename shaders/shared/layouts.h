// The memory layouts that C++ and GLSL share, written once. Scalar block layout; every size is a multiple of 16 bytes, so that
// each struct is a whole number of RGBA32UI texels for fetch4(). Lengths are in frame units (scene/tessellate.h).
#ifndef LIGHTBENCH_SHARED_LAYOUTS_H
#define LIGHTBENCH_SHARED_LAYOUTS_H

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
namespace lightbench::gpu_layout {
using glm::mat4;
using glm::uvec2;
using glm::vec2;
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

const uint kMaterialTexels = 17u;  // of a Material
const uint kMaterialOpacity = 4u;  // the texel that begins with it
const uint kMaterialReflection = 13u;
const uint kMaterialRefraction = 15u;
const uint kMaterialCube = 16u;

struct PointPosition {
    vec3 position;     // frame
    uint polygon;      // vertices: the polygon that this vertex provokes (any, if none); polygons: their own number
};

struct PointNormal {
    vec3 normal;       // unit
    uint material;     // index into materials (scene/tessellate.h: a surface)
};

// Of meshes whose pictures are mapped by their own uv.
struct PointDetail {
    vec2 uv;
    uint pad0, pad1;
    vec3 u_gradient;   // of u along the surface, per frame unit: perpendicular to the normal; 0 where uv has no area
    uint pad2;
    vec3 v_gradient;
    uint pad3;
};

// A picture among the texels (image/texels.h). width 0: none.
struct TexelInfo {
    uint first;        // where its header is, in uvec4s
    uint width, height;
    uint flags;        // levels | wrap of u << 8 | wrap of v << 10 | bias << 16: stored values are the picture's times 2^-(bias - 128)
};
const uint kWrapRepeat = 0u;
const uint kWrapClamp = 1u;
const uint kWrapMirror = 2u;

const uint kMapUv = 0u;
const uint kMapSpherical = 1u;
const uint kMapCylindrical = 2u;
const uint kMapPlanar = 3u;
const uint kBumpNone = 0u;
const uint kBumpWaves = 1u;
const uint kBumpNoise = 2u;
const uint kBumpHeight = 3u;
const uint kBumpNormalMap = 4u;
const uint kModelPhong = 0u;
const uint kModelGaussian = 1u;    // Cook-Torrance
const uint kModelBeckmann = 2u;
const uint kTextureNone = 0u;
const uint kTexturePicture = 1u;
const uint kTextureChecker = 2u;
const uint kTextureWithAlpha = 3u; // a picture whose alpha multiplies the opacity

// A material on a surface: those with a mapping in object space are one an object.
struct Material {
    vec3 diffuse;      // kd
    float shininess;   // n
    vec3 specular;     // ks
    uint kinds;        // kModel... | kTexture... << 4 | kMap... << 8 | kBump... << 12
    vec3 emission;     // radiance
    float pad0;
    vec3 ior;          // Cook-Torrance: index of refraction per channel
    float roughness;   // rms slope m
    vec3 opacity;      // t
    float lobe;        // factor of the distribution (scene/distribution.h)
    TexelInfo texture;
    TexelInfo bump;
    vec2 repeats;      // of texture and bump pictures
    float amplitude;   // of the bump: frame units; of a normal map: its scale
    float pad1;
    vec3 bump_scale;   // waves and noise: their argument is bump_scale * (mapping-space point), cycles
    float pad2;
    vec3 mirror;       // weight of environment mapping, times kr where the material names one
    float pad3;
    vec4 map_x, map_y, map_z; // mapping_from_frame, a row each: the object's box becomes [-1, 1] on each axis; z is the polar axis
    vec3 reflection;   // kr; read where rays are traced, like what follows
    float scatter;     // rms slope of frosted surfaces
    vec3 transmission; // kt
    uint splits;       // kSplit... bits
    vec3 refraction;   // index of refraction, per channel
    float pad4;
    TexelInfo cube;    // six faces, rendered from where the surface is; height as in ShadePush::environment
};
const uint kSplitFresnel = 1u;     // kr + kt is split by Fresnel
const uint kSplitDispersion = 2u;  // the indices of the channels differ
const uint kOneSided = 4u;         // another bit of `splits`: its backs are not seen, rays pass them

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

// Push constants of shading and drawing: the 128 bytes that every driver has.
struct ShadePush {
    mat4 clip_from_frame;
    vec3 eye;          // frame
    uint first_light;  // lights are summed in [first_light, end_light): bounded work per invocation
    vec3 ambient;      // Ia
    uint end_light;
    uint point_count;  // compute: points to shade
    uint list_origin;  // transparency: x | y << 16 of the tile whose fragments are listed, pixels
    uint list_width;   // pixels of the tile along x
    uint pad0;
    TexelInfo environment;
};

// Of the passes over a tile's lists of layers.
struct LayersPush {
    uvec2 origin;      // pixels, of the tile in the image
    uvec2 size;        // pixels, of the tile
    uvec2 counted_origin; // pixels, of the area that was counted
    uint counted_width;   // pixels
    uint run;          // keys of a sorted run
    uint first_deep;   // of the list of pixels with many layers
    uint deep_count;
    uint pairs;        // of runs, of the pixel that has most
    uint pad0;
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
    uint mode;         // ACCUMULATE_...
};
#define ACCUMULATE_ADD 0u
#define ACCUMULATE_FIRST 1u // the sum is written, not added to
#define ACCUMULATE_MEAN 2u  // a running mean: equal frames stay what they are, to the bit

// Written by display/display.comp before any clamp.
struct Census {
    uint non_finite;   // pixels with a NaN or an infinity in a channel
    uint visited;      // pixels looked at: the host checks that none is missing
};

#ifdef __cplusplus
static_assert(sizeof(PointPosition) == 16 && sizeof(PointNormal) == 16);
static_assert(sizeof(PointDetail) == 48 && sizeof(Material) == 16 * kMaterialTexels && offsetof(Material, opacity) == 16 * kMaterialOpacity && offsetof(Material, reflection) == 16 * kMaterialReflection && offsetof(Material, refraction) == 16 * kMaterialRefraction && offsetof(Material, cube) == 16 * kMaterialCube && sizeof(Light) == 64);
static_assert(sizeof(ShadePush) == 128 && sizeof(LayersPush) == 48 && sizeof(DisplayPush) == 32 && sizeof(AccumulatePush) == 16 && sizeof(Census) == 8);
} // namespace lightbench::gpu_layout
#endif
#endif
