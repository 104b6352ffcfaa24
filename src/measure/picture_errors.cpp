#include "measure/picture_errors.h"

#include "image/display.h"
#include "image/flip.h"
#include "image/metrics.h"

#include <cmath>
#include <limits>

namespace lightbench {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double root_mean_square(const ImageF& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c) sum += double(image.rgba[i + c]) * image.rgba[i + c];
    return std::sqrt(sum / (0.75 * double(image.rgba.size())));
}

} // namespace

Errors picture_errors(const ImageF& reference, const ImageF& picture, float exposure) {
    const Metrics m = metrics(reference, picture);
    if (m.non_finite_reference + m.non_finite_test > 0)
        return {{"rmse", kInfinite}, {"relative rmse", kInfinite}, {"maximum", kInfinite}, {"flip", kInfinite}};
    const double scale = root_mean_square(reference);
    return {{"rmse", m.rmse},
            {"relative rmse", m.rmse == 0 ? 0
                              : scale > 0 ? m.rmse / scale
                                          : kInfinite},
            {"maximum", m.max},
            {"flip", mean(flip(display(reference, exposure), display(picture, exposure)))}};
}

} // namespace lightbench
