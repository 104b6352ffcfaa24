// What the header of the same name says.
#include "radiosity/matrix.h"

#include "shared/radiosity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lightbench {
namespace {

// a x = b; x takes b's place.
void eliminate(FormMatrix& a, std::vector<double>& b) {
    const std::size_t n = a.size;
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(a.at(i, k)) > std::abs(a.at(pivot, k))) pivot = i;
        if (pivot != k) {
            std::swap_ranges(&a.at(k, 0), &a.at(k, 0) + n, &a.at(pivot, 0));
            std::swap(b[k], b[pivot]);
        }
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = a.at(i, k) / a.at(k, k);
            if (factor == 0) continue;
            for (std::size_t j = k; j < n; ++j) a.at(i, j) -= factor * a.at(k, j);
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = i + 1; j < n; ++j) b[i] -= a.at(i, j) * b[j];
        b[i] /= a.at(i, i);
    }
}

// A_i F_ij: power that i hands to j if its radiosity is 1; symmetric where form factors are reciprocal.
FormMatrix exchanged(const FormMatrix& matrix, std::span<const double> areas) {
    FormMatrix s = matrix;
    for (std::size_t i = 0; i < s.size; ++i)
        for (std::size_t j = 0; j < s.size; ++j) s.at(i, j) *= areas[i];
    return s;
}

// The sums of rows of diag(d) s diag(d), each over its area.
std::vector<double> scaled_sums(const FormMatrix& s, const std::vector<double>& d, std::span<const double> areas) {
    std::vector<double> sums(s.size);
    for (std::size_t i = 0; i < s.size; ++i)
        sums[i] = d[i] * std::inner_product(d.begin(), d.end(), &s.factors[i * s.size], 0.0) / areas[i];
    return sums;
}

double closure(const std::vector<double>& sums) {
    double worst = 0;
    for (const double sum : sums) worst = std::max(worst, std::abs(1 - sum));
    return worst;
}

} // namespace

double FormMatrix::row_sum(std::size_t i) const {
    double sum = 0;
    for (std::size_t j = 0; j < size; ++j) sum += at(i, j);
    return sum;
}

FormMatrix make_form_matrix(std::size_t size) {
    return {size, std::vector<double>(size * size)};
}

FormMatrix from_rows(std::span<const std::uint32_t> rows, std::size_t size) {
    FormMatrix matrix = make_form_matrix(size);
    for (std::size_t k = 0; k < matrix.factors.size(); ++k) matrix.factors[k] = static_cast<double>(rows[k]) / gpu_layout::kHemicubeOne;
    return matrix;
}

FormMatrix from_shots(const FormMatrix& rows, std::span<const double> areas) {
    FormMatrix matrix = make_form_matrix(rows.size);
    for (std::size_t i = 0; i < rows.size; ++i)
        for (std::size_t j = 0; j < rows.size; ++j) matrix.at(i, j) = rows.at(j, i) * areas[j] / areas[i];
    return matrix;
}

std::vector<glm::dvec3> solve_directly(const FormMatrix& matrix, std::span<const glm::dvec3> emission,
                                       std::span<const glm::dvec3> reflectance) {
    std::vector<glm::dvec3> radiosity(matrix.size);
    for (int c = 0; c < 3; ++c) {
        FormMatrix a = matrix;
        std::vector<double> b(matrix.size);
        for (std::size_t i = 0; i < a.size; ++i) {
            for (std::size_t j = 0; j < a.size; ++j) a.at(i, j) = (i == j ? 1.0 : 0.0) - reflectance[i][c] * a.at(i, j);
            b[i] = emission[i][c];
        }
        eliminate(a, b);
        for (std::size_t i = 0; i < a.size; ++i) radiosity[i][c] = b[i];
    }
    return radiosity;
}

Reciprocity reciprocity_error(const FormMatrix& matrix, std::span<const double> areas) {
    Reciprocity r;
    double apart = 0, all = 0;
    for (std::size_t i = 0; i < matrix.size; ++i)
        for (std::size_t j = i + 1; j < matrix.size; ++j) {
            const double there = areas[i] * matrix.at(i, j), back = areas[j] * matrix.at(j, i);
            const double larger = std::max(there, back), difference = std::abs(there - back);
            apart += difference, all += larger;
            if (difference > r.worst * larger) r.worst = difference / larger, r.i = i, r.j = j;
        }
    r.mean = all > 0 ? apart / all : 0;
    return r;
}

void enforce_reciprocity(FormMatrix& matrix, std::span<const double> areas) {
    for (std::size_t i = 0; i < matrix.size; ++i)
        for (std::size_t j = i + 1; j < matrix.size; ++j) {
            const double mean = 0.5 * (areas[i] * matrix.at(i, j) + areas[j] * matrix.at(j, i));
            matrix.at(i, j) = mean / areas[i];
            matrix.at(j, i) = mean / areas[j];
        }
}

Balance balance(FormMatrix& matrix, std::span<const double> areas, double tolerance, unsigned most_rounds) {
    enforce_reciprocity(matrix, areas);
    const FormMatrix s = exchanged(matrix, areas);
    std::vector<double> d(s.size, 1.0), sums = scaled_sums(s, d, areas);
    Balance result{0, closure(sums)};
    while (result.closure_error > tolerance && result.rounds < most_rounds) {
        for (std::size_t i = 0; i < s.size; ++i)
            if (sums[i] > 0) d[i] /= std::sqrt(sums[i]);
        sums = scaled_sums(s, d, areas);
        result = {result.rounds + 1, closure(sums)};
    }
    for (std::size_t i = 0; i < s.size; ++i)
        for (std::size_t j = 0; j < s.size; ++j) matrix.at(i, j) = d[i] * d[j] * s.at(i, j) / areas[i];
    return result;
}

EnergySums energy_sums(const FormMatrix& matrix, std::span<const double> areas, std::span<const glm::dvec3> emission,
                       std::span<const glm::dvec3> reflectance, std::span<const glm::dvec3> radiosity) {
    EnergySums sums;
    for (std::size_t i = 0; i < matrix.size; ++i) {
        glm::dvec3 received(0);
        for (std::size_t j = 0; j < matrix.size; ++j) received += matrix.at(i, j) * radiosity[j];
        sums.emitted += areas[i] * emission[i];
        sums.absorbed += areas[i] * (1.0 - reflectance[i]) * received;
        sums.escaped += areas[i] * (1.0 - matrix.row_sum(i)) * radiosity[i];
    }
    return sums;
}

} // namespace lightbench
