// Tables of the hemi-cube, and form factors in closed form or by quadrature where the closed form cancels.
#include "radiosity/form_factors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lightbench {
namespace {

using std::numbers::pi;

// From the centre to the rectangle [0, x] x [0, y] of the top, odd in both. Howell's catalogue B-3; its mixed derivative is the integrand of S28.
double top_corner(double x, double y) {
    const double p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * pi);
}

// Likewise of a side, but for functions of y or of z alone, which four corners take out again.
double side_corner(double y, double z) {
    const double p = std::sqrt(1 + z * z);
    return -std::atan(y / p) / (2 * pi * p);
}

// Cells [x0 + i dx, ...] x [y0 + j dy, ...] by their four corners, row by row.
template <class Corner> std::vector<double> cells(unsigned columns, unsigned rows, double y0, double y1, const Corner& corner) {
    std::vector<double> values;
    values.reserve(std::size_t{columns} * rows);
    const auto x = [&](unsigned i) { return -1 + 2.0 * i / columns; };
    const auto y = [&](unsigned j) { return y0 + (y1 - y0) * j / rows; };
    for (unsigned j = 0; j < rows; ++j)
        for (unsigned i = 0; i < columns; ++i)
            values.push_back((corner(x(i + 1), y(j + 1)) - corner(x(i), y(j + 1))) - (corner(x(i + 1), y(j)) - corner(x(i), y(j))));
    return values;
}

// Whole numbers that sum to `total`, the error of each rounding carried into the next.
void append_rounded(std::vector<std::uint32_t>& out, const std::vector<double>& values, std::int64_t total) {
    double sum = 0, running = 0;
    for (double v : values) sum += v;
    std::int64_t before = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        running += values[i];
        const std::int64_t now = i + 1 == values.size() ? total : std::llround(running / sum * static_cast<double>(total));
        out.push_back(static_cast<std::uint32_t>(now - before));
        before = now;
    }
}

constexpr int kNodes = 20;
struct Quadrature {
    std::array<double, kNodes> x, weight; // on [-1, 1]
};

// Abscissas by Newton's method from Chebyshev's guess. Abramowitz and Stegun 1964, "Handbook of mathematical functions", 25.4.29.
Quadrature gauss_legendre() {
    Quadrature q{};
    for (int i = 0; i < kNodes; ++i) {
        double x = std::cos(pi * (i + 0.75) / (kNodes + 0.5)), slope = 1;
        for (int step = 0; step < 8; ++step) {
            double p = 1, before = 0;
            for (int k = 1; k <= kNodes; ++k) {
                const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before = p, p = next;
            }
            slope = kNodes * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        q.x[static_cast<std::size_t>(i)] = x, q.weight[static_cast<std::size_t>(i)] = 2 / ((1 - x * x) * slope * slope);
    }
    return q;
}

template <class F> double integrate(double a, double b, const F& f) {
    static const Quadrature q = gauss_legendre();
    double sum = 0;
    for (std::size_t i = 0; i < kNodes; ++i) sum += q.weight[i] * f(0.5 * (a + b) + 0.5 * (b - a) * q.x[i]);
    return 0.5 * (b - a) * sum;
}

// What of the polygon is above the plane through the origin across `normal`. Sutherland, Hodgman 1974, "Reentrant polygon clipping".
std::vector<glm::dvec3> above_horizon(const std::vector<glm::dvec3>& polygon, const glm::dvec3& normal) {
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double ha = glm::dot(normal, a), hb = glm::dot(normal, b);
        if (ha > 0) kept.push_back(a);
        if ((ha > 0) != (hb > 0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    return kept;
}

} // namespace

DeltaFormFactors exact_delta_form_factors(unsigned n) {
    return {cells(n, n, -1, 1, top_corner), cells(n, n / 2, 0, 1, side_corner)};
}

// Cohen and Greenberg 1985, "The hemi-cube: a radiosity solution for complex environments", eqs. 7 and 8.
double sum_at_pixel_centers(unsigned n) {
    const double width = 2.0 / n, area = width * width;
    const auto center = [&](unsigned i) { return -1 + (i + 0.5) * width; };
    double top = 0, side = 0;
    for (unsigned j = 0; j < n; ++j)
        for (unsigned i = 0; i < n; ++i) {
            const double x = center(i), y = center(j), r = x * x + y * y + 1;
            top += area / (pi * r * r);
            if (y > 0) side += y * area / (pi * r * r); // y stands for z, x for y
        }
    return top + 4 * side;
}

std::vector<std::uint32_t> delta_form_factors(unsigned n) {
    const DeltaFormFactors exact = exact_delta_form_factors(n);
    double side = 0;
    for (double v : exact.side) side += v;
    constexpr std::int64_t kOne = std::int64_t{1} << 31;
    const std::int64_t of_side = std::llround(side * static_cast<double>(kOne));
    std::vector<std::uint32_t> table;
    table.reserve(exact.top.size() + exact.side.size());
    append_rounded(table, exact.top, kOne - 4 * of_side); // at most 2 more or less than its own share
    append_rounded(table, exact.side, of_side);
    return table;
}

double point_to_polygon(const glm::dvec3& point, const glm::dvec3& normal, std::span<const glm::dvec3> polygon) {
    std::vector<glm::dvec3> from_point;
    for (const glm::dvec3& corner : polygon) from_point.push_back(corner - point);
    const std::vector<glm::dvec3> seen = above_horizon(from_point, normal);
    double sum = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const glm::dvec3 &a = seen[i], &b = seen[(i + 1) % seen.size()], across = glm::cross(a, b - a);
        const double size = glm::length(across);
        if (size > 0) sum -= std::atan2(size, glm::dot(a, b)) * glm::dot(normal, across) / size;
    }
    return std::max(0.0, sum / (2 * pi));
}

// Howell's catalogue, C-11. Where one side is less than half the distance its terms cancel: then what is left of the definition once three
// of its four integrals are done, F = 2 / (pi X) int_0^X (X - x) atan(Y / s) / s^3 dx with s^2 = 1 + x^2, whose integrand is positive.
double parallel_rectangles(double a, double b, double c) {
    const double x = std::min(a, b) / c, y = std::max(a, b) / c;
    if (x < 0.5) {
        const auto slice = [&](double t) {
            const double s = std::sqrt(1 + t * t);
            return (x - t) * std::atan(y / s) / (s * s * s);
        };
        return 2 / (pi * x) * integrate(0, x, slice);
    }
    const double p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    const double logarithm = 0.5 * std::log1p(x * x * y * y / (1 + x * x + y * y));
    const double angles = x * q * std::atan(x / q) + y * p * std::atan(y / p) - x * std::atan(x) - y * std::atan(y);
    return 2 / (pi * x) * ((logarithm + angles) / y);
}

// Howell's catalogue, C-14, before its last integral is done, since what comes out cancels where b or c is small or large beside a:
// F = 1 / (2 pi a b) int_0^a (a - t) log(1 + b^2 c^2 / (t^2 (t^2 + b^2 + c^2))) dt, t = a exp(-s).
double perpendicular_rectangles(double a, double b, double c) {
    const double w = b / a, h = c / a, both = w * w + h * h;
    const auto slice = [&](double s) {
        const double t = std::exp(-s), r = w / t * (h / t);
        return (1 - t) * t * std::log1p(r * r * (t * t / (t * t + both)));
    };
    const int end = 45 + static_cast<int>(std::max(0.0, -std::log(std::min(w, h))));
    double sum = 0;
    for (int i = 0; i < end; ++i) sum += integrate(i, i + 1, slice);
    return sum / (2 * pi * w);
}

// Howell's catalogue, C-41, rationalised (HC-5): with q = r2 / r1, X - 2 q = (1 - q)^2 + (h / r1)^2.
double coaxial_discs(double r1, double r2, double h) {
    const double q = r2 / r1, k = h / r1, x = 1 + k * k + q * q;
    const double root = std::sqrt(((1 - q) * (1 - q) + k * k) * ((1 + q) * (1 + q) + k * k));
    return 2 * q * q / (x + root);
}

} // namespace lightbench
