// Searches for the shortest text by trying 1 to 17 digits: 17 name every double (Steele and White 1990, "How to Print Floating-Point Numbers").
#include "scene/write_number.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace lightbench {
namespace {

constexpr int kDigitsOfDouble = 17;

double rounded_to(double value, int digits) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    double result = value;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

// The first of the ever longer decimals of `value` that `good` accepts, else the value.
template <typename Good> double shortest(double value, Good good) {
    for (int digits = 1; digits <= kDigitsOfDouble; ++digits)
        if (const double candidate = rounded_to(value, digits); good(candidate)) return candidate;
    return value;
}

template <typename Radians> double degrees_that_read_as(Radians radians) {
    const auto reads_back = [&](double degrees) { return static_cast<Radians>(degrees * (glm::pi<double>() / 180)) == radians; };
    const double degrees = static_cast<double>(radians) * (180 / glm::pi<double>());
    const double found = shortest(degrees, reads_back);
    if (reads_back(found)) return found;
    for (const double far : {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()})
        if (const double next = std::nextafter(degrees, far); reads_back(next)) return next;
    return degrees;
}

template <typename Vector> std::string joined(const Vector& v, std::string_view separator) {
    return fmt::format("{}{}{}{}{}", decimal(v.x), separator, decimal(v.y), separator, decimal(v.z));
}

} // namespace

std::string decimal(double value) {
    return fmt::format("{}", value);
}

// The shortest decimal of a float may lie so near the middle of two floats that rounding it to double first takes it to the other one.
std::string decimal(float value) {
    std::string text = fmt::format("{}", value);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return static_cast<float>(read) == value ? text : decimal(static_cast<double>(value));
}

std::string decimals(const glm::dvec3& v, std::string_view separator) {
    return joined(v, separator);
}
std::string decimals(const glm::vec3& v, std::string_view separator) {
    return joined(v, separator);
}

double shortest_near(double value, double tolerance) {
    if (std::fabs(value) <= tolerance) return 0;
    return shortest(value, [&](double candidate) { return std::fabs(candidate - value) <= tolerance; });
}

double degrees_for(double radians) {
    return degrees_that_read_as(radians);
}
double degrees_for(float radians) {
    return degrees_that_read_as(radians);
}

} // namespace lightbench
