// What `lightbench cost` found, as data: every writer (CSV, JSON, SVG, HTML) and every reader (--budget) sees this and nothing else.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lightbench {

// Errors by metric. Of pictures: "rmse" (linear light), "relative rmse" (over the reference's root mean square), "maximum", "flip" (mean).
// Of shader functions: "relative", "ulp".
using Errors = std::map<std::string, double, std::less<>>;

// One setting of a knob, measured.
struct CostPoint {
    std::string value; // as typed in --knob NAME=VALUE, and as a person reads it beside the point: "16", "gouraud/2"
    Errors errors;     // against the curve's reference
    double device_ms = 0, q1_ms = 0, q3_ms = 0; // median and quartiles of the runs, from device timestamps
    unsigned runs = 0;
    bool settled = false;                                    // the median's 95 % interval is within 5 % of it
    std::set<std::string> pareto;                            // metrics in which no other point of the curve is both faster and nearer
    std::string image;                                       // below the report's folder; empty for shader functions
    std::string command;                                     // renders this picture again
    std::map<std::string, std::string, std::less<>> options; // of that command: "--spp", "16"; empty for shader functions
    std::string note;                                        // what a person must know of this point; often empty
};

// How an error falls as a knob turns: the slope of a line through the logarithms.
struct Slope {
    std::string of;              // "jittered"; empty: all points of the curve
    std::string metric, against; // "rmse" against "samples a pixel"
    double measured = 0;
    std::optional<double> theory; // with its source in `why`
    std::string why;
};

// One knob.
struct CostCurve {
    std::string knob, meaning; // "spp", "samples a pixel"
    std::string reference;     // how it was computed, in words
    std::string reference_image, reference_command;
    Errors reference_error;        // its own uncertainty
    std::string metric;            // the one that plots show first
    bool time_only = false;        // all pictures must be equal: structures
    std::vector<CostPoint> points; // in the knob's order
    std::vector<Slope> slopes;
    std::vector<std::string> notes; // violated expectations, runs that did not settle
};

struct CostReport {
    std::string program; // "lightbench 0.1.0"
    std::string scene;   // as typed
    unsigned width = 0, height = 0;
    std::string device, driver, version; // as in --stats
    std::string command;                 // repeats the report
    std::vector<CostCurve> curves;
};

} // namespace lightbench
