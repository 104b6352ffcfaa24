// Form factors as a dense matrix in double precision: solved directly, made reciprocal, balanced. What the solvers are held against, and what
// reports of accuracy are made from. In: rows. Out: values. Pure.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lightbench {

struct FormMatrix {
    std::size_t size = 0;
    std::vector<double> factors; // row by row: F of i to j, the fraction of what leaves i that reaches j
    double& at(std::size_t i, std::size_t j) { return factors[i * size + j]; }
    double at(std::size_t i, std::size_t j) const { return factors[i * size + j]; }
    double row_sum(std::size_t i) const;
};

FormMatrix make_form_matrix(std::size_t size);                               // of zeros
FormMatrix from_rows(std::span<const std::uint32_t> rows, std::size_t size); // entries in units of 1 / kHemicubeOne
// What progressive refinement solves for: entry (i, j) is what i gets of a shot from j, F_ji A_j / A_i. Equal to `rows` if they are reciprocal.
FormMatrix from_shots(const FormMatrix& rows, std::span<const double> areas);

// B = E + rho F B, by Gaussian elimination with partial pivoting (Golub and Van Loan 2013, "Matrix Computations", sec. 3.4), a channel at a
// time. rho < 1 and rows that sum to at most 1.
std::vector<glm::dvec3> solve_directly(const FormMatrix& matrix, std::span<const glm::dvec3> emission,
                                       std::span<const glm::dvec3> reflectance);

// How far A_i F_ij and A_j F_ji are apart, relative to the larger of the two (HC-8).
struct Reciprocity {
    double worst = 0;         // of all pairs
    std::size_t i = 0, j = 0; // that pair
    double mean = 0;          // over the pairs, each by the larger of its two
};
Reciprocity reciprocity_error(const FormMatrix& matrix, std::span<const double> areas);

// A_i F_ij and A_j F_ji become their mean, to within the rounding of a quotient.
void enforce_reciprocity(FormMatrix& matrix, std::span<const double> areas);

struct Balance {
    unsigned rounds = 0;
    double closure_error = 0; // largest |1 - sum of a row| that is left
};
// Makes the matrix reciprocal with rows that sum to 1: factors d with A_i F_ij d_i d_j (Knight, Ruiz and Ucar 2014, "A symmetry preserving
// algorithm for matrix scaling": Sinkhorn and Knopp's iteration, its symmetric form). Until the error is at most `tolerance`, which not every
// matrix allows (two patches that see nothing but each other must be equally large).
Balance balance(FormMatrix& matrix, std::span<const double> areas, double tolerance, unsigned most_rounds);

// Sums over all elements of area times E, (1 - rho) H and what escapes, (1 - row sum) B; H and the last one as the matrix gives them.
struct EnergySums {
    glm::dvec3 emitted{0}, absorbed{0}, escaped{0};
};
EnergySums energy_sums(const FormMatrix& matrix, std::span<const double> areas, std::span<const glm::dvec3> emission,
                       std::span<const glm::dvec3> reflectance, std::span<const glm::dvec3> radiosity);

} // namespace lightbench
