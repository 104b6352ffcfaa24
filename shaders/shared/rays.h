// What the ray tracer adds to the layouts that C++ and GLSL share: primitives, nodes of the structures, rays, the ray tree, push constants.
// Scalar block layout; tables are read as RGBA32UI texels by fetch4(). Lengths are in frame units (scene/tessellate.h).
#ifndef LIGHTBENCH_SHARED_RAYS_H
#define LIGHTBENCH_SHARED_RAYS_H

#include "shared/layouts.h"

#ifdef __cplusplus
namespace lightbench::gpu_layout {
using glm::uvec4;
#endif

// Specialisation constants of the ray tracer, besides those of shared/effects.h.
#define CONSTANT_RAY_EFFECTS 6                  // RAY_... bits
#define CONSTANT_ACCEL 7                        // ACCEL_...
#define CONSTANT_STACK 8                        // entries that a traversal of this structure needs at most
#define CONSTANT_LOOSE 9                        // 4 bits a type: primitives that are in no tree; then a bit a type that is in the tree

#define RAY_TRIANGLES 0x1u                      // which primitives there are
#define RAY_SPHERES 0x2u
#define RAY_BOXES 0x4u                          // shapes: affine images of a box, a ball, a truncated cone, a torus
#define RAY_BALLS 0x8u
#define RAY_CONES 0x10u
#define RAY_TORI 0x20u
#define RAY_SHADOWS 0x40u                       // S15: some light is lit and something can stand before it
#define RAY_CLEAR_SHADOWS 0x80u                 // shadow rays are attenuated by what they pass
#define RAY_REFLECTED 0x100u                    // S14: some kr > 0
#define RAY_REFRACTED 0x200u                    // S16: some kt > 0
#define RAY_STRAIGHT 0x400u                     // S13: some opacity is below 1
#define RAY_FRESNEL 0x800u                      // some material splits kr and kt by Fresnel
#define RAY_SCATTER 0x1000u                     // S17
#define RAY_DISPERSION 0x2000u                  // S18
#define RAY_CUTOFF 0x4000u                      // S19: adaptive depth
#define RAY_COUNT 0x8000u                       // counters
#define RAY_RESUME 0x10000u                     // walks that spend their steps are put down and taken up again
#define RAY_SMOOTH 0x20000u                     // triangles have normals of their own at their corners (not flat)
#define RAY_UV 0x40000u                         // triangles have texture coordinates
#define RAY_PACKETS 0x80000u                    // eight rays share one walk through the structure
#define RAY_LIST 0x100000u                      // eye rays go through listed points, not through the pixels of a tile
#define RAY_JITTER 0x200000u                    // S25
#define RAY_EYE 0x400000u                       // the pass that traces eye rays makes them too

#define RAY_SHAPES (RAY_BOXES | RAY_BALLS | RAY_CONES | RAY_TORI)

#define ACCEL_NONE 0u
#define ACCEL_BVH 1u
#define ACCEL_SPHERE_BVH 2u
#define ACCEL_GRID 3u
#define ACCEL_OCTREE 4u

// A primitive is named by a reference: its type, and its index in the table of its type. References to several that follow each other in
// their table, as leaves have them, also hold their number - 1.
const uint kRefLeaf = 0x80000000u;     // of a node's child: primitives, not a node
const uint kRefType = 29u;             // shift; 2 bits
const uint kRefCount = 27u;            // shift; 2 bits: 1 to 4 primitives
const uint kRefIndex = 0x07ffffffu;
const uint kTypeTriangle = 0u;
const uint kTypeSphere = 1u;
const uint kTypeShape = 2u;
const uint kNothing = 0xffffffffu;     // no primitive, no node

const uint kRefracts = 0x80000000u;    // in the number of a primitive whose material refracts, where RAY_REFRACTED is set

const uint kTriangleTexels = 3u, kSphereTexels = 2u, kShapeTexels = 8u;

// `number` counts all primitives of the scene in one fixed order, triangles, then spheres, then shapes, whatever the structure: of two hits
// at the same distance the lower number counts.
struct RayTriangle {
    vec3 v0; uint number;
    vec3 v1; uint surface;   // index into materials
    vec3 v2; uint object;    // index into Scene::objects
};

struct RaySphere {
    vec3 center; float radius;
    uint number, surface, object, pad0;
};

const uint kShapeBox = 0u;             // [-1, 1]^3
const uint kShapeBall = 1u;            // radius 1
const uint kShapeCone = 2u;            // about z from -1 to 1; p0, p1 the radii at -1 and 1, p2 != 0: capped
const uint kShapeTorus = 3u;           // about z, major radius 1; p0 the minor one
// p_object = linear * (p_frame - center), rows of `linear`; p_frame = back * p_object + center.
struct RayShape {
    vec3 row_x; float center_x;
    vec3 row_y; float center_y;
    vec3 row_z; float center_z;
    uint kind; float p0, p1, p2;
    uint number, surface, object, pad0;
    vec3 back_x; float pad1;
    vec3 back_y; float pad2;
    vec3 back_z; float pad3;
};

// Corners of triangle i (by number): indices into the streams of vertices.
struct RayCorners {
    uint a, b, c, polygon;
};

// BVH of boxes, two children a node; planes are whole numbers of 1/65535 of the scene's box, rounded outwards. For rays that go their own way.
// A child: lo.x | hi.x << 16, lo.y | hi.y << 16, lo.z | hi.z << 16, reference (a node's index, or a leaf). Absent: reference kNothing.
const uint kNarrowTexels = 2u;
// The same tree with four children a node and exact planes, for rays that go together: texels lo.x, hi.x, lo.y, hi.y, lo.z, hi.z of the
// four children, then their references. Absent children have lo > hi and the reference kNothing.
const uint kWideTexels = 8u;           // the last is not used: nodes lie on 128 bytes

// BVH of spheres, two children a node: center and radius of each, then (reference, reference, 0, 0).
const uint kSphereNodeTexels = 3u;

// Grid of voxels, x fastest. Header: (origin, cells along x), (size of a cell, cells along y), (cells along z, first texel of references,
// 0, 0). Then the cells, two a texel: (first reference, their number) each. Then references, four a texel: type << kRefType | index.
const uint kGridHeaderTexels = 3u;

// Octree. Its planes are origin + k * step, k from 0 to kOctreeSide; bit kOctreeDepth - 1 of a voxel's coordinates says which half of the
// root it is in. Header: (origin, root), (step, first texel of leaves), (first texel of references, 0, 0, 0). Then the nodes: 8 children,
// x | y << 1 | z << 2. A child, or the root: a node's index; kRefLeaf | index of a leaf; kNothing, an empty leaf. Leaves and references as
// cells and references of the grid.
const uint kOctreeHeaderTexels = 3u;
const uint kOctreeNodeTexels = 2u;
const uint kOctreeDepth = 20u;
const uint kOctreeSide = 0x100000u;

struct Ray {
    vec3 origin; float after;          // hits at t > after count; at t == after those of a number > after_number
    vec3 direction; uint after_number; // unit
    float width;                       // of the ray's cone at its origin, frame units: what a pixel spans
    uint level;                        // 1: from the eye; straight rays (S13) have their parent's | the channels it carries << 8, a bit each
    float weight;                      // largest channel of the product of the weights on the way from the eye
    uint key;                          // of its random numbers: of the pixel, the sample and the way from the eye
};
const uint kRayTexels = 3u;

// What shading a hit found, for summing its lights.
struct RayPoint {
    vec3 position; uint surface;       // index into materials
    vec3 normal; uint children;        // of the node: see there
    vec3 origin; float pad0;           // of shadow rays: off the surface by its error, on the side that is seen
    vec3 face; float pad1;             // unit geometric normal, on the side that is seen
    vec3 diffuse; float pad2;          // kd, as the texture has it
    vec3 opacity; float pad3;          // t, likewise
};
const uint kRayPointTexels = 6u;

struct RayHit {
    float t;                           // frame units
    uint ref;                          // type << kRefType | index; kNothing: the ray leaves the scene
    float b1, b2;                      // of a triangle: weights of its second and third corner; of a shape: b1 holds the part, as bits
};

// A ray in the tree of its pixel: I = color + sum over its children of weight * I(child).
struct RayNode {
    vec3 color; uint children;         // index of the first << 3 | their number
    vec3 weight; uint kind;            // of this ray in its parent's sum; kRay...
};
const uint kRayNodeTexels = 2u;
const uint kRayEye = 0u;
const uint kRayReflected = 1u;
const uint kRayRefracted = 2u;
const uint kRayStraight = 3u;

// What a ray is inside of (S16), only where something refracts: surfaces + 1, the innermost first; 0: nothing.
struct RayMedia {
    uvec4 inside;
};

// A walk that is not finished: what the structure needs, the hit so far, what a shadow ray has passed; then the stack.
struct RayWalk {
    uint node, top, a, b;
    RayHit hit;
    vec3 clear; uint after_number;
    float after;
    float hit_t;                       // where something refracts: what orders hits is in hit.t then
};
const uint kRayWalkWords = 14u;

const uint kCollect = 2u;

// Push constants of the passes over rays; begins as ShadePush does, whose names shade.glsl reads.
struct RayPush {
    vec3 eye; uint first_light;
    vec3 ambient; uint end_light;
    vec3 background; uint count;       // rays of this generation
    TexelInfo environment;
    uint first;                        // node of its first ray
    uint next_first;                   // node of the first ray of the next
    uint next_capacity;                // rays that there is room for
    uint max_level;
    float cutoff;                      // S19
    float spread;                      // radians: how fast cones of rays widen
    uint seed;
    uint resume;                       // 1: the walks that were not finished go on; kCollect: all have ended
    uint more;                         // 1: the lights of this piece are added to those before
    uint layer;                        // of visibility: of the light that the first layer of work groups is for
    uint triangle_count, sphere_count, shape_count;
};

struct EyePush {
    vec3 eye; float hither;            // frame; along the viewing axis
    vec3 corner; uint count;           // of the image, at distance 1; samples of this dispatch
    vec3 across; uint tile_x;          // per pixel; of the tile's first pixel
    vec3 down; uint tile_y;
    vec3 axis; uint tile_size;         // unit viewing direction; width | height << 16, pixels
    vec2 shift;                        // within the pixel, [0, 1)^2; of a jittered sample: where its cell begins
    float cell;                        // side of a cell, pixels
    uint seed;
    uint sample_index;                 // which of a pixel's samples
    float spread;
    uint first;                        // of the list of points
    uint pad0;
    uvec4 media;                       // that the eye is inside of
};

struct FilmPush {
    uint tile_x, tile_y, tile_size;    // as EyePush; tile_x of a list: the first of its points
    uint count;
};

struct PixelsPush {
    uint tile_x, tile_y, tile_size;    // as FilmPush
    uint count;
    uvec2 offset;                      // pixels, of the crop in the image
    uint width;                        // of the crop
    float gain;                        // 2^exposure
};

// S25: of one frame.
struct FilterPush {
    uvec2 corner, size;                // of the crop, pixels
    vec2 shift;                        // as EyePush
    float cell;
    uint seed, sample_index;
    float radius, sigma;               // pixels
    uint margin;                       // of the frame around the crop, pixels
    uint first;                        // 1: the means begin with this frame
};

// S26: of a band of pixels.
const uint kMaxLatticeLevels = 6u;
struct LatticePush {
    uvec2 corner, size;                // of the band, pixels
    uint levels;                       // points lie 2^-levels pixels apart
    uint level;                        // of this pass; of the pixels: the deepest that counts
    uint count;                        // invocations
    uint seed;
    vec3 contrast;
};

struct GatherPush {
    uint first, count;                 // nodes
    uint parts;                        // of roots: a bit 1 << kRay... for each kind of children that count; kRayEye: their own color
};
const uint kAllParts = 15u;

// Filled by the passes, read by the host.
struct RayCounters {
    uint children;                     // rays that the next generation has, or would have, given room
    uint unfinished;                   // walks that spent their steps
    uint done;                         // invocations that ended
    uint nodes, voxels, triangles, spheres, boxes, balls, cones, tori; // RAY_COUNT: tests, visits
    uint hits, shadow_rays, reflected, refracted, straight;
};

#ifdef __cplusplus
static_assert(sizeof(RayTriangle) == 16 * kTriangleTexels && sizeof(RaySphere) == 16 * kSphereTexels &&
              sizeof(RayShape) == 16 * kShapeTexels && sizeof(Ray) == 16 * kRayTexels && sizeof(RayPoint) == 16 * kRayPointTexels && sizeof(RayMedia) == 16 && sizeof(RayWalk) == 4 * kRayWalkWords && sizeof(RayPush) <= 128 && sizeof(EyePush) <= 128 && sizeof(RayHit) == 16 && sizeof(RayNode) == 16 * kRayNodeTexels);
} // namespace lightbench::gpu_layout
#endif

#endif
