// Hemi-cubes on the device (S28; Cohen and Greenberg 1985, "The Hemi-cube: A Radiosity Solution for Complex Environments"): from patches to
// what each element gets of them. In: a PatchMesh. Out: rows of form factors. Inside this room only.
#pragma once

#include "gpu/recorder.h"
#include "radiosity/patches.h"

#include <memory>

namespace lightbench {

enum class HemicubeWay { raster, rays }; // five drawn faces; rays through a tree of boxes

struct HemicubeRequest {
    unsigned resolution = 64; // pixels along a face's edge, even
    unsigned batch = 16;      // hemi-cubes a submission at most
    HemicubeWay way = HemicubeWay::rays;
    bool correct_near = false; // HC-3: elements nearer than five times a patch's size get analytic form factors with traced visibility
    unsigned near_rays = 16;   // of those, a square
    bool shares = false;       // record() is told what each element has to shoot
};

struct HemicubeState;

// Owns the mesh on the device, the structure over it, the tables of delta form factors and the item buffers.
class Hemicubes {
  public:
    Hemicubes(gpu::Device& device, const PatchMesh& mesh, const HemicubeRequest& request);
    Hemicubes(Hemicubes&&) noexcept;
    ~Hemicubes();

    // Tables that solvers read too (shaders/shared/radiosity.h): Receiver an element, Shooter a patch.
    gpu::Buffer& receivers();
    gpu::Buffer& shooters();

    // A row per hemi-cube, a uint per element: the form factor from the patch to the element in units of 1 / kHemicubeOne.
    gpu::Buffer make_rows(const char* name = "rows") const;
    // For the patches whose numbers stand in `chosen` (uint each, request.batch of them; kNoElement: none, its row is 0). A patch does not see
    // itself (HC-10). Deterministic.
    // With correct_near: elements nearer than `near_sizes` sizes of a patch are corrected; and if request.shares, by what `unshot`, a table
    // of SolveState (shaders/shared/solve.h), says of each of its elements.
    void record(gpu::Recorder& recorder, gpu::Buffer& chosen, gpu::Buffer& rows, float near_sizes = gpu_layout::kNearSizes,
                gpu::Buffer* unshot = nullptr);
    // After submission: EnvironmentError if a ray spent its steps, abort if the driver left out work. Until then rows are not to be trusted.
    void check();
    // The items of the last record()'s hemi-cube `index`, as shaders/shared/radiosity.h orders them: for pictures and tests.
    std::vector<std::uint32_t> items(unsigned index);

    HemicubeState& state() { return *state_; } // for this room

  private:
    std::unique_ptr<HemicubeState> state_;
};

} // namespace lightbench
