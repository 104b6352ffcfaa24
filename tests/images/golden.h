// Golden pictures: golden/NAME/KEY.png, KEY naming the driver that drew it, with the tolerance in golden/NAME/tolerance.toml beside.
// In: a picture and who drew it. Out: a verdict with its figures. A driver without a golden of its own is held against the pinned one's
// by what a person would see (FLIP). Only `./run test --update-golden NAME` writes one.
#pragma once

#include "image/image.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace lightbench {

// "llvmpipe-1.3.230-Mesa-22.3.6-LLVM-15.0.6-256": driver, version and vector width in bits, fit for a file name.
std::string driver_key(std::string_view driver, std::string_view version, unsigned subgroup_size);

struct Tolerance {
    std::string pinned;       // key of the driver whose golden stands for drivers that have none
    unsigned max_channel = 1; // 255ths; a pixel is off when one of its channels differs by more
    double fraction = 0.001;  // of the pixels that may be off
    double flip_mean = 0.002; // for other drivers: FLIP over the picture,
    double flip_p99 = 0.02;   // and the FLIP that 99 % of the pixels do not exceed
};

struct Verdict {
    bool pass = false;
    std::string report; // one line of figures, or what is wrong
};

Verdict judge_same_driver(const Image8& golden, const Image8& image, const Tolerance& tolerance);
Verdict judge_other_driver(const Image8& golden, const Image8& image, const Tolerance& tolerance);

struct GoldenStore {
    std::filesystem::path folder;   // holds one folder a name
    std::filesystem::path failures; // where a picture that fails is put, beside its difference
    std::string update;             // the one name that may be written; empty: none
};

// Of this checkout; the name to update is LIGHTBENCH_UPDATE_GOLDEN, which `run` sets.
GoldenStore golden_store();

Verdict check_golden(const GoldenStore& store, const std::string& name, const std::string& key, const Image8& image);

// The gtest form: fails with the report; prints it when a golden was written.
void expect_golden(const std::string& name, const std::string& key, const Image8& image);

} // namespace lightbench
