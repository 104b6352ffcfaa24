// Numbers as text that reads back as the same number, in the fewest digits.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>

namespace lightbench {

std::string decimal(double value);
std::string decimal(float value); // the text reads back as this float by way of a double, too

std::string decimals(const glm::dvec3& v, std::string_view separator);
std::string decimals(const glm::vec3& v, std::string_view separator);

// The number of fewest digits within `tolerance` of the value; the value itself if it is not finite.
double shortest_near(double value, double tolerance);

// Degrees, in the fewest digits, that a reader multiplies by pi/180 to get these radians; if no double does, the nearest one does within an ulp.
double degrees_for(double radians);
double degrees_for(float radians); // the reader rounds the product to float

} // namespace lightbench
