// Of repeated runs and of points on a curve: quartiles, how sure a median is, slopes. Pure.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace lightbench {

struct Quartiles {
    double q1 = 0, median = 0, q3 = 0;
};

struct Interval {
    double low = 0, high = 0;
};

// Hyndman and Fan 1996, "Sample Quantiles in Statistical Packages", definition 7. The sample is not empty.
Quartiles quartiles(std::vector<double> sample);

// The narrowest interval between two runs, as many below it as above it, that holds the median with this confidence at least, however runs
// are distributed. Nothing if all runs together do not suffice: 6 are needed for 95 %.
std::optional<Interval> median_interval(std::vector<double> sample, double confidence = 0.95);

// The interval above lies within this share of the sample's median, both ways; the median is above 0.
bool is_settled(const std::vector<double>& sample, double share, double confidence);

// Least squares through (log x, log y); nothing for fewer than two different x. All x and y are above 0.
std::optional<double> log_slope(const std::vector<std::pair<double, double>>& points);

} // namespace lightbench
