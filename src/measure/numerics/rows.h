// The error bounds of the shader functions, one row a function and domain: what `lightbench numerics` prints and the kernel tests hold.
// A function's bound is written here and in the comment of its GLSL file, nowhere else.
#pragma once

#include "measure/numerics/verdict.h"

#include <string>
#include <string_view>
#include <vector>

namespace lightbench::kernels {

// One statement about the results of a function: `measure` of them is within `allowed` of what `oracle` says.
struct Claim {
    std::string what;  // "length", "direction"; empty: the result itself
    std::string bound; // in words, u = 2^-24
    Oracle oracle;
    Bound allowed;
    Measure measure = first_float;
};

struct Row {
    std::string function;                                           // as in GLSL
    std::string file;                                               // below shaders/
    std::string domain;                                             // in words
    std::string kernel;                                             // entry point below shaders/numerics/, without .comp
    std::size_t results = 1;                                        // floats a result
    std::function<Inputs(std::size_t count, unsigned seed)> inputs; // about `count` random tuples, and all the special ones
    std::vector<Claim> claims;
    Words words{}; // pictures, for kernels that read them
};
using Rows = std::vector<Row>;

// All rows, by file.
Rows all_rows();

// The first row of a function; CHECKs that there is one.
Row row_of(std::string_view function);

KernelRun run_row(gpu::Device& device, const Row& row, std::size_t count, unsigned seed);
inline Verdict judge(const KernelRun& run, const Claim& claim) {
    return judge(run, claim.oracle, claim.allowed, claim.measure);
}

// By topic, each in rows_TOPIC.cpp.
Rows power_rows();
Rows phong_rows();
Rows light_rows();
Rows facet_rows();
Rows fresnel_rows();
Rows vector_rows();
Rows refraction_rows();
Rows sphere_rows();
Rows triangle_rows();
Rows box_rows();
Rows cone_rows();
Rows torus_rows();
Rows offset_rows();
Rows mapping_rows();
Rows noise_rows();
Rows bump_rows();
Rows texel_rows();
Rows color_rows();
Rows form_factor_rows();
Rows sampling_rows();

} // namespace lightbench::kernels
