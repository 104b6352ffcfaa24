// What the solvers of radiosity share with the host. Scalar block layout; structs are whole texels of RGBA32UI.
#ifndef LIGHTBENCH_SHARED_SOLVE_H
#define LIGHTBENCH_SHARED_SOLVE_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace lightbench::gpu_layout {
using glm::vec3;
using uint = std::uint32_t;
#endif

// Bits of CONSTANT_FETCH_STORAGE in these passes.
#define FETCH_SOLVE_TABLES 0x1u                 // all that are the solver's own
#define FETCH_SOLVE_ROWS 0x2u                   // form factors

const uint kSolveElementTexels = 2u, kSolveStateTexels = 3u, kSolveTallyTexels = 2u;
const uint kChooseLanes = 256u, kShootLanes = 128u, kTallyLanes = 128u;

struct SolveElement {
    vec3 reflectance; float area;
    uint patch_number; uint unused0, unused1, unused2;
};

struct SolvePatch {
    uint first, count; // elements
    uint unused0, unused1;
};

// Sums with what their last rounding took (lib/sum.glsl).
struct SolveState {
    vec3 received; float unshot_r;       // H
    vec3 received_carry; float unshot_g; // dB
    vec3 unshot_carry; float unshot_b;
};

// Of a patch: sums of area times dB, all channels together, and of area times (1 - rho) H.
struct SolveTally {
    vec3 unshot; float key;
    vec3 absorbed; uint unused;
};

// A patch that shoots: area times dB; once its row was summed, in units of a row's entries.
struct SolveShot {
    vec3 energy; uint patch_number;
};

// Of a place in the batch, over all shots: what left the scene, and how many there were.
struct SolveSlot {
    vec3 escaped; uint shots;
    vec3 escaped_carry; uint unused;
};

// A row's sum is 65536 high + low.
struct SolveRowSum {
    uint high, low;
    float scale; // what brings a sum above 1 down to 1; otherwise 1
    uint unused;
};

// An element in Gauss and Seidel's iteration.
struct SolveRadiosity {
    vec3 radiosity; float change; // largest of the channels
};
struct SolveSurface {
    vec3 emission; uint unused0;
    vec3 reflectance; uint unused1;
};

struct ChoosePush {
    uint patches, batch, most; // most: at most so many are chosen
};
struct ShootPush {
    uint elements, batch;
};
struct TallyPush {
    uint patches, lanes; // lanes: a power of two, that share a patch
};
struct SweepPush {
    uint elements, start; // start: first row of the block; a work group a row
};

#ifdef __cplusplus
static_assert(sizeof(SolveElement) == 16 * kSolveElementTexels && sizeof(SolveState) == 16 * kSolveStateTexels);
static_assert(sizeof(SolveTally) == 16 * kSolveTallyTexels && sizeof(SolvePatch) == 16 && sizeof(SolveShot) == 16);
static_assert(sizeof(SolveRowSum) == 16 && sizeof(SolveRadiosity) == 16 && sizeof(SolveSurface) == 32 && sizeof(SolveSlot) == 32);
} // namespace lightbench::gpu_layout
#endif

#endif
