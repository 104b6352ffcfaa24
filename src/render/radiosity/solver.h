// The radiosity equation on the device: progressive refinement (S30), or Gauss-Seidel on the full matrix (S29). In: rows of form factors.
// Out: radiosity per element, unshot energy, the ledger. Inside this room only.
#pragma once

#include "gpu/recorder.h"
#include "radiosity/patches.h"

#include <memory>
#include <span>

namespace lightbench {

// Per element, RGB; radiosity (power per area), not radiance. Covered elements have none.
struct RadiosityState {
    std::vector<glm::vec3> radiosity;                      // B = E + rho H; follows from H, so set_state() does not read it
    std::vector<glm::vec3> unshot;                         // dB
    std::vector<glm::vec3> received;                       // H, irradiance
    std::vector<glm::vec3> unshot_carry, received_carry{}; // what the last rounding took from the two; empty: 0
    glm::dvec3 escaped{0};                                 // Ledger's
    std::uint64_t shots = 0;                               // of patches
};

// emitted = absorbed + unshot + escaped, whatever was shot and however (RS-4).
struct Ledger {
    glm::dvec3 emitted{0}, absorbed{0}, unshot{0}; // sums of area times E, (1 - rho) H, dB
    glm::dvec3 escaped{0};                         // what rows that sum to less than 1 let out of the scene
    double unshot_fraction() const;                // largest of the channels that are emitted at all; 0 if nothing is
};

struct SolverState;

// Owns the state on the device. O(n) memory.
class ProgressiveSolver {
  public:
    // emission and reflectance: one an element; rho < 1 in every channel (RS-6, the caller has checked).
    ProgressiveSolver(gpu::Device& device, const PatchMesh& mesh, std::span<const glm::vec3> emission,
                      std::span<const glm::vec3> reflectance, unsigned batch);
    ProgressiveSolver(ProgressiveSolver&&) noexcept;
    ~ProgressiveSolver();

    gpu::Buffer& unshot(); // a table of SolveState (shaders/shared/solve.h): what is there to shoot until record_shots()
    gpu::Buffer& chosen(); // uint each: the patches that the last record_choice() chose, or kNoElement
    // The patches of largest unshot energy (area times dB, the channels' sum), at most `batch` and at most `most` of them, all different;
    // of equal ones the lowest numbers, the largest energy first.
    void record_choice(gpu::Recorder& recorder, unsigned most);
    // S30 for the patches of the last choice: dB_i += rho_i dB_j F_ji A_j / A_i; what they had is shot. All of a batch shoot what they had
    // when they were chosen; what they receive from each other is unshot afterwards. Each element adds up in the order of choice, and sums
    // are compensated (RS-8). Rows above 1 are brought down to 1 (RS-1). A row's entries begin at its number times the elements.
    void record_shots(gpu::Recorder& recorder, gpu::Buffer& rows);
    // After submission. The ledger is cheap: its sums are there, one a patch.
    Ledger ledger();
    unsigned last_shots(); // how many of the chosen ones really shot
    RadiosityState state();
    void set_state(const RadiosityState& state); // goes on bit for bit where it was left
    void restart();                              // nothing is shot
    // S31: to be added to what is displayed, times rho_i. Goes to 0 with what is unshot.
    glm::vec3 ambient();

  private:
    std::unique_ptr<SolverState> state_;
};

// All rows at once, each patch one element.
struct FullSolution {
    std::vector<glm::vec3> radiosity;
    unsigned sweeps = 0;
    gpu::Timings times;       // of the sweeps
    double closure_error = 0; // largest |1 - sum of a row| before rows above 1 were brought down to 1 (RS-1)
};
// Gauss-Seidel until the largest change relative to the largest radiosity is below `tolerance`. `matrix`: n * n uints, row i from element i
// to all.
FullSolution solve_full(gpu::Device& device, const PatchMesh& mesh, gpu::Buffer& matrix, std::span<const glm::vec3> emission,
                        std::span<const glm::vec3> reflectance, double tolerance, unsigned most_sweeps);

} // namespace lightbench
