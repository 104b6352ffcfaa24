// Layouts of the passes that build a tree of boxes on the device. Scalar block layout; lengths are in frame units (scene/tessellate.h).
#ifndef LIGHTBENCH_SHARED_BUILD_H
#define LIGHTBENCH_SHARED_BUILD_H

#include "shared/rays.h"

#ifdef __cplusplus
namespace lightbench::gpu_layout {
#endif

// Specialisation constants of these passes.
#define CONSTANT_BUILD_TYPES 16         // a bit a type, by kType...: those in the tree
#define CONSTANT_SORT_DIGITS 17         // values of a digit, a power of two, at most kSortDigits
#define CONSTANT_SORT_MOVE 18           // MOVE_...
#define CONSTANT_COPY_TEXELS 19         // of a primitive

#define MOVE_KEYS 0x1u                  // keys go along
#define MOVE_VALUES 0x2u                // so do values; otherwise an element's value is its number
#define MOVE_RANKS 0x4u                 // where each element went is kept

// A code has kMortonBits bits of each coordinate. Twice a box's centre c lies in cell floor(c * 2^k) - floor(low * 2^k), which is exact:
// k is the largest whole number for which all cells have numbers below 2^kMortonBits, and at most kMortonFinest, where |c| 2^k < 2^31.
const uint kMortonBits = 10u;
const int kMortonFinest = 27;

const uint kSortDigits = 256u;          // of a pass over keys; work groups of the scan have so many invocations
const uint kBuildNodeTexels = 4u;       // (low, reference), (high, 0) of each child; references as in the narrow tree
const uint kBoxTexels = 2u;             // (low, 0), (high, 0)

struct SortPush {
    uint count;                         // elements
    uint chunk;                         // elements of a lane, a multiple of 4
    uint lanes;                         // a multiple of 64
    uint shift;                         // of the digit in a key
};

struct BuildPush {
    uint count;                         // invocations that have work
    uint items;                         // primitives in the tree: triangles, then spheres, then shapes
    uint triangles, spheres;            // of them
    uint leaves;                        // of the pyramid of boxes: items rounded up to a power of two
    uint first;                         // element of a list that the first invocation reads; of the pyramid: the node that it makes
    uint levels;                        // of the pyramid that a pass makes, 1 to 3
    uint leaf;                          // primitives of a leaf at most
    float pad;                          // of boxes
    vec3 origin;                        // of the narrow tree's planes
    vec3 per_step;                      // planes a frame unit
    vec3 margin;                        // planes
};

// Filled by the passes. Of twice the boxes' centres: the least, and the least of their negatives, as ordered words; all bits set at first.
struct BuildBounds {
    uint low[3], high[3];
    uint deepest;                       // inverted: levels below the root
};

#ifdef __cplusplus
static_assert(sizeof(BuildPush) <= 128);
} // namespace lightbench::gpu_layout
#endif
#endif
