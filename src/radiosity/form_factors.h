// Form factors in closed form and as tables, in double precision: what the hemi-cube is made from and held against. Pure.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lightbench {

// Delta form factors of a hemi-cube of n x n pixels a face (n even), by the exact integral over each pixel, in units of 2^-31
// (kHemicubeOne): the top row by row, n n pixels; then one side, n / 2 rows from the horizon up, n pixels each. All five faces sum to
// kHemicubeOne exactly.
std::vector<std::uint32_t> delta_form_factors(unsigned n);

// The same before rounding. Sums: top 0.554126424, each side 0.111468394.
struct DeltaFormFactors {
    std::vector<double> top, side;
};
DeltaFormFactors exact_delta_form_factors(unsigned n);

// The sum of a hemi-cube's delta form factors by the formula at the centers of its pixels (S28, Cohen and Greenberg 1985), before any
// correction: 1 + 0.54 / n^2 or so (HC-1).
double sum_at_pixel_centers(unsigned n);

// From a point with a unit normal to a polygon that lies in front of it, all of it visible (Lambert 1760, "Photometria"; Baum, Rushmeier and
// Winget 1989, "Improving radiosity solutions through the use of analytically determined form-factors"). Clips at the horizon.
// The polygon faces the point if its corners turn counter-clockwise as seen from there; a back gives 0.
double point_to_polygon(const glm::dvec3& point, const glm::dvec3& normal, std::span<const glm::dvec3> polygon);

// Of two rectangles a x b opposite at distance c, and of two that share an edge of length a, b and c deep (Howell's catalogue C-11, C-14);
// of coaxial discs of radii r1, r2 at distance h. Series where the closed form cancels (HC-5). Relative error 1e-12.
double parallel_rectangles(double a, double b, double c);
double perpendicular_rectangles(double a, double b, double c); // from b to c
double coaxial_discs(double r1, double r2, double h);

} // namespace lightbench
