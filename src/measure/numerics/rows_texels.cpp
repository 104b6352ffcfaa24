// Filtered pictures against interpolation in double of what the table holds: TX-1, TX-2.
#include "measure/numerics/album.h"
#include "measure/numerics/rows.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace lightbench::kernels {

using gpu_layout::kWrapClamp, gpu_layout::kWrapMirror, gpu_layout::kWrapRepeat;
using gpu_layout::TexelInfo;

ImageF random_picture(unsigned width, unsigned height, unsigned seed) {
    ImageF image{.width = width, .height = height, .rgba = {}};
    Random random(seed);
    for (unsigned i = 0; i < width * height * 4; ++i)
        image.rgba.push_back(static_cast<float>(uniform(random, -kLargestTexel, kLargestTexel)));
    return image;
}

namespace {

unsigned wrapped(long i, unsigned size, std::uint32_t wrap) {
    const long n = size;
    if (wrap == kWrapClamp) return static_cast<unsigned>(std::clamp(i, 0L, n - 1));
    const long period = wrap == kWrapRepeat ? n : 2 * n, r = ((i % period) + period) % period;
    return static_cast<unsigned>(r < n ? r : 2 * n - 1 - r);
}

// uv in whole pictures less a multiple of two, or at a border.
double reduced(double x, std::uint32_t wrap) {
    if (!std::isfinite(x)) return 0;
    return wrap == kWrapClamp ? std::clamp(x, 0.0, 1.0) : std::fmod(x, 2.0);
}

double bilinear(const Album& album, const TexelInfo& t, double u, double v, unsigned level, std::size_t channel) {
    const std::uint32_t wrap_u = t.flags >> 8 & 3, wrap_v = t.flags >> 10 & 3;
    const unsigned width = std::max(1u, t.width >> level), height = std::max(1u, t.height >> level);
    const double x = reduced(u, wrap_u) * width - 0.5, y = (1 - reduced(v, wrap_v)) * height - 0.5;
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    double sum = 0;
    for (long i = 0; i < 2; ++i)
        for (long k = 0; k < 2; ++k)
            sum += (i ? fx : 1 - fx) * (k ? fy : 1 - fy) *
                   album.texel(t, level, wrapped(static_cast<long>(std::floor(x)) + i, width, wrap_u),
                               wrapped(static_cast<long>(std::floor(y)) + k, height, wrap_v), channel);
    return sum;
}

double trilinear(const Album& album, const TexelInfo& t, double u, double v, double lod, std::size_t channel) {
    const double most = (t.flags & 255) - 1.0, held = lod > 0 ? std::min(lod, most) : 0, f = held - std::floor(held);
    const auto low = static_cast<unsigned>(held);
    const double a = bilinear(album, t, u, v, low, channel);
    return f > 0 ? (1 - f) * a + f * bilinear(album, t, u, v, low + 1, channel) : a;
}

Album random_album() {
    Album album;
    unsigned seed = 0;
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 7u}, {6u, 1u}, {13u, 10u}, {64u, 32u}, {129u, 65u}})
        for (std::uint32_t wrap : {kWrapRepeat, kWrapClamp, kWrapMirror}) {
            if (album.infos.size() == Album::kMost) break;
            ++seed;
            album.keep(album.table.add(random_picture(width, height, seed), false, wrap, (wrap + seed / 3) % 3));
        }
    return album;
}

const TexelInfo& info_of(const Album& album, std::span<const float> in) {
    return album.infos.at(static_cast<std::size_t>(in[0]));
}

// (picture, u, v, level or lod): coordinates of every size, levels that there are.
Inputs samples(const Album& album, std::size_t count, unsigned seed, bool whole) {
    return generate(count / 4, 4, seed, [&](Random& random, std::span<float> in) {
        in[0] = static_cast<float>(random() % album.infos.size());
        const double range = log_uniform(random, 1e-3, 100);
        in[1] = static_cast<float>(uniform(random, -range, range));
        in[2] = static_cast<float>(uniform(random, -range, range));
        const double level = uniform(random, whole ? 0 : -2, (info_of(album, in).flags & 255) - (whole ? 1e-6 : -2));
        in[3] = static_cast<float>(whole ? std::floor(level) : level);
    });
}

// TX-1, TX-2.
Inputs odd_coordinates(const Album& album, const Inputs& levels) {
    Inputs pictures;
    for (std::size_t i = 0; i < album.infos.size(); ++i) pictures.values.push_back(static_cast<float>(i));
    const Inputs axis =
        special_values() + near(0, 2) + near(1, 2) + near(-1, 1) + near(2, 1) + only({1e-9f, -1e-9f, 1e9f, -3e9f, 1e7f, 16777215.0f});
    return pictures * axis * axis * levels;
}

// Rounding of the interpolation, and of uv times the size: half an ulp of each folds the coordinate, another places it.
Bound within(std::shared_ptr<const Album> album, double u_of_largest) {
    return Bound::function([=](std::span<const float> in, double) {
        const TexelInfo& t = info_of(*album, in);
        return (u_of_largest + 2.0 * 2 * (t.width + t.height)) * kLargestTexel * kU;
    });
}

using Sample = double (*)(const Album& album, std::span<const float> in, std::size_t channel);

double bilinear_sample(const Album& album, std::span<const float> x, std::size_t channel) {
    return bilinear(album, info_of(album, x), static_cast<double>(x[1]), static_cast<double>(x[2]), static_cast<unsigned>(x[3]), channel);
}
double trilinear_sample(const Album& album, std::span<const float> x, std::size_t channel) {
    return trilinear(album, info_of(album, x), static_cast<double>(x[1]), static_cast<double>(x[2]), static_cast<double>(x[3]), channel);
}

Row texel_row(std::shared_ptr<const Album> album, const char* function, bool whole, const Inputs& levels, double u_of_largest,
              Sample sample) {
    Row row{function, "lib/texels.glsl", "uv of any size, pictures of 1x1 to 129x65, levels", function, 4, {}, {}, album->table.words};
    row.inputs = [=](std::size_t count, unsigned seed) { return samples(*album, count, seed, whole) + odd_coordinates(*album, levels); };
    for (std::size_t c = 0; c < 4; ++c) {
        const auto f = [=](std::span<const float> x) { return sample(*album, x, c); };
        row.claims.push_back({fmt::format("channel {}", "rgba"[c]),
                              fmt::format("({} + 4 (w + h)) u of the largest texel", u_of_largest),
                              {f, f},
                              within(album, u_of_largest),
                              component(c)});
    }
    return row;
}

} // namespace

Rows texel_rows() {
    const auto album = std::make_shared<const Album>(random_album());
    const Inputs odd = only({-1, 0.5f, kNaN, std::numeric_limits<float>::infinity()});
    return {texel_row(album, "sample_bilinear", true, only({0}), 4, bilinear_sample),
            texel_row(album, "sample_trilinear", false, odd, 8, trilinear_sample)};
}

} // namespace lightbench::kernels
