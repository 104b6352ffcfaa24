// Filtered pictures against interpolation in double of what the table holds: TX-1, TX-2, TX-6, BM-1.
#include "kernel_test.h"

#include "measure/numerics/album.h"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace lightbench::kernels {

namespace {

using gpu_layout::kWrapClamp, gpu_layout::kWrapMirror, gpu_layout::kWrapRepeat;

ImageF picture_of(unsigned width, unsigned height, const std::function<double(double, double)>& value) {
    ImageF image{.width = width, .height = height, .rgba = {}};
    for (unsigned y = 0; y < height; ++y)
        for (unsigned x = 0; x < width; ++x)
            for (int c = 0; c < 4; ++c) image.rgba.push_back(static_cast<float>(value((x + 0.5) / width, 1 - (y + 0.5) / height)));
    return image;
}

} // namespace

TEST_F(Kernel, SampleBilinear) {
    expect_rows(device, "sample_bilinear");
}

TEST_F(Kernel, SampleTrilinear) {
    expect_rows(device, "sample_trilinear");
}

// In the middle of a texel, on every level, there is that texel's very value.
TEST_F(Kernel, TexelCentresAreExact) {
    Album album;
    album.keep(album.table.add(random_picture(64, 32, 1), false, kWrapRepeat, kWrapClamp));
    Inputs in{4, {}};
    for (unsigned level = 0; level < 7; ++level)
        for (unsigned y = 0, h = std::max(1u, 32u >> level), w = std::max(1u, 64u >> level); y < h; ++y)
            for (unsigned x = 0; x < w; ++x)
                for (float value : {0.0f, (static_cast<float>(x) + 0.5f) / static_cast<float>(w),
                                    (static_cast<float>(y) + 0.5f) / static_cast<float>(h), static_cast<float>(level)})
                    in.values.push_back(value);
    const auto f = [&](std::span<const float> x) {
        const auto level = static_cast<unsigned>(x[3]), w = std::max(1u, 64u >> level), h = std::max(1u, 32u >> level);
        return album.texel(album.infos[0], level, static_cast<unsigned>(x[1] * static_cast<float>(w)),
                           h - 1 - static_cast<unsigned>(x[2] * static_cast<float>(h)), 0);
    };
    expect_within(run_kernel(device, "sample_bilinear", in, 4, album.table.words), {f, f}, Bound::exact());
    expect_within(run_kernel(device, "sample_trilinear", in, 4, album.table.words), {f, f}, Bound::exact());
}

TEST_F(Kernel, LodOf) {
    Album album;
    album.keep(album.table.add(random_picture(64, 16, 1), false, kWrapRepeat, kWrapRepeat));
    const auto f = [](std::span<const float> in) {
        const auto pixels = [&](std::size_t i) { return std::hypot(64 * static_cast<double>(in[i]), 16 * static_cast<double>(in[i + 1])); };
        return std::clamp(std::log2(std::max(pixels(1), pixels(3))), 0.0, 6.0);
    };
    const Inputs axis = log_grid(1e-6, 10, 20) + only({0, -0.1f});
    expect_within(run_kernel(device, "lod_of", only({0}) * axis * axis * axis * axis, 1, album.table.words), {f, f}, Bound::absolute(1e-5));
    const Inputs any = special_values();
    expect_within(run_kernel(device, "lod_of", only({0}) * any * any * any * only({kNaN, 1}), 1, album.table.words), constant(0),
                  Bound::absolute(6));
}

// A constant picture stays what it is, whatever the footprint; broken ones give finite values.
TEST_F(Kernel, SampleAnisotropic) {
    Album album;
    album.keep(album.table.add(picture_of(40, 24, [](double, double) { return 0.7; }), false, kWrapRepeat, kWrapMirror));
    const double value = album.texel(album.infos[0], 0, 0, 0, 0);
    const Inputs in = generate(kMillion / 8, 7, 1, [](Random& random, std::span<float> values) {
        values[0] = 0;
        for (std::size_t i = 1; i < 7; ++i) values[i] = static_cast<float>(uniform(random, -1, 1) * log_uniform(random, 1e-4, 10));
    });
    const Inputs broken = only({0}) * random_bits(kMillion / 8, 6, 1);
    const Inputs few = only({0, 0.1f, kNaN, std::numeric_limits<float>::infinity(), -kFloatMax, 1e-40f});
    const KernelRun run =
        run_kernel(device, "sample_anisotropic", in + broken + only({0}) * few * few * few * few * few * few, 4, album.table.words);
    for (std::size_t c = 0; c < 4; ++c) expect_within(run, constant(value), Bound::relative(16 * kU), component(c));
}

// Magnified, it is the bilinear sample of the picture itself, to the bit.
TEST_F(Kernel, SampleAnisotropicMagnified) {
    Album album;
    album.keep(album.table.add(random_picture(64, 32, 1), false, kWrapRepeat, kWrapClamp));
    const Inputs uv = generate(10000, 2, 1, [](Random& random, std::span<float> x) {
        for (float& c : x) c = static_cast<float>(uniform(random, -2, 2));
    });
    const Inputs steps = only({1 / 65.0f}) * only({0}) * only({0}) * only({1 / 40.0f}) + only({0}) * only({0}) * only({0}) * only({0}) +
                         only({1e-3f}) * only({-2e-3f}) * only({4e-3f}) * only({1e-9f});
    const KernelRun sharp = run_kernel(device, "sample_anisotropic", only({0}) * uv * steps, 4, album.table.words);
    const KernelRun once =
        run_kernel(device, "sample_bilinear", only({0}) * uv * (only({0}) + only({0}) + only({0})), 4, album.table.words);
    EXPECT_EQ(sharp.missing + once.missing, 0u);
    EXPECT_EQ(sharp.results, once.results);
}

// Means over footprints of a sine along an inclined direction against the Gaussian-like truth: across the footprint's long side the sine
// keeps its contrast though the long side spans many waves of nothing; along it, the sine is averaged away.
TEST_F(Kernel, SampleAnisotropicKeepsWhatAnIsotropicSampleBlurs) {
    Album album;
    constexpr unsigned kSide = 256;
    const auto stripes = [](double, double v) { return std::sin(2 * std::numbers::pi * 16 * v); }; // 16 texels a cycle
    album.keep(album.table.add(picture_of(kSide, kSide, stripes), false, kWrapRepeat, kWrapRepeat));
    const auto contrast = [&](float du, float dv) {
        Inputs in{7, {}};
        for (int i = 0; i < 1000; ++i)
            for (float x : {0.0f, 0.37f, static_cast<float>(i) / 1000.0f, du, 0.0f, 0.0f, dv}) in.values.push_back(x);
        double most = 0;
        const KernelRun run = run_kernel(device, "sample_anisotropic", in, 4, album.table.words);
        for (std::size_t i = 0; i < in.count(); ++i) most = std::max(most, static_cast<double>(run.result(i)[0]));
        return most;
    };
    constexpr float kTexel = 1.0f / kSide;
    EXPECT_GT(contrast(8 * kTexel, kTexel), 0.9); // eight times as long as wide, along the stripes
    EXPECT_GT(contrast(6 * kTexel, kTexel), 0.9);
    EXPECT_LT(contrast(kTexel, 64 * kTexel), 0.05); // across
    EXPECT_LT(contrast(16 * kTexel, 16 * kTexel), 0.3);
}

// Probes are placed evenly about the middle: the mean of a slope is its middle.
TEST_F(Kernel, SampleAnisotropicIsCentred) {
    Album album;
    constexpr unsigned kSide = 512;
    album.keep(album.table.add(picture_of(kSide, kSide, [](double u, double v) { return u + 0.5 * v; }), false, kWrapClamp, kWrapClamp));
    const Inputs in = generate(20000, 7, 1, [](Random& random, std::span<float> values) {
        values[0] = 0;
        for (std::size_t i = 1; i < 3; ++i) values[i] = static_cast<float>(uniform(random, 0.3, 0.7));
        const double angle = uniform(random, 0, 6.3), major = log_uniform(random, 1e-4, 0.1), minor = major * log_uniform(random, 0.02, 1);
        const double c = std::cos(angle), s = std::sin(angle), turn = uniform(random, 0, 6.3), p = std::cos(turn), q = std::sin(turn);
        const double jacobian[4] = {major * c * p - minor * s * q, major * s * p + minor * c * q, -major * c * q - minor * s * p,
                                    -major * s * q + minor * c * p};
        for (std::size_t i = 0; i < 4; ++i) values[3 + i] = static_cast<float>(jacobian[i]);
    });
    const auto plane = [](std::span<const float> x) { return static_cast<double>(x[1]) + 0.5 * static_cast<double>(x[2]); };
    // Halves of values near 1: 2^-11 at most.
    expect_within(run_kernel(device, "sample_anisotropic", in, 4, album.table.words), {plane, plane}, Bound::absolute(0x1p-11 + 16 * kU));
}

// BM-1: the angle between the normal of an analytic sine and that of its picture.
TEST_F(Kernel, HeightGradient) {
    Album album;
    constexpr double kPi = std::numbers::pi;
    const double a = 2 * kPi * 4, b = 2 * kPi * 2; // 128 texels a cycle each
    const double height = 1 / a;                   // slopes up to 1 in u, 1/2 in v
    const auto bump = [=](double u, double v) { return height * std::sin(a * u) * std::cos(b * v); };
    album.keep(album.table.add_heights(picture_of(512, 256, bump), kWrapRepeat, kWrapRepeat));
    const Inputs in = only({0}) * grid(-0.5, 1.5, 777) * grid(0, 1, 333) * only({0, -3});
    const Measure angle = [=](std::span<const float> x, std::span<const float> out) {
        const double u = static_cast<double>(x[1]), v = static_cast<double>(x[2]);
        const std::array<double, 3> n{-height * a * std::cos(a * u) * std::cos(b * v), height * b * std::sin(a * u) * std::sin(b * v), 1};
        const std::array<double, 3> m{-static_cast<double>(out[0]), -static_cast<double>(out[1]), 1};
        const double cross = std::hypot(n[1] * m[2] - n[2] * m[1], n[2] * m[0] - n[0] * m[2], n[0] * m[1] - n[1] * m[0]);
        return std::atan2(cross, n[0] * m[0] + n[1] * m[1] + n[2] * m[2]);
    };
    expect_within(run_kernel(device, "height_gradient", in, 2, album.table.words), constant(0), Bound::absolute(1e-3), angle);
}

} // namespace lightbench::kernels
