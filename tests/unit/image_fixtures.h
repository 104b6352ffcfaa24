// Pictures and files that the tests of image/ share: a folder that goes away, a noise picture, and a shaded ball under two lights.
#pragma once

#include "image/display.h"
#include "image/image.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <random>
#include <string>
#include <unistd.h>

namespace lightbench::image_test {

class TemporaryFolder {
  public:
    TemporaryFolder() {
        static int count = 0;
        path_ = std::filesystem::temp_directory_path() / fmt::format("lightbench-image-{}-{}", ::getpid(), count++);
        std::filesystem::create_directories(path_);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

inline Image8 noise(unsigned width, unsigned height, unsigned seed, bool opaque = true) {
    std::mt19937 random(seed);
    Image8 image{.width = width, .height = height, .rgba = std::vector<std::uint8_t>(std::size_t{width} * height * 4)};
    for (auto& v : image.rgba) v = static_cast<std::uint8_t>(random());
    for (std::size_t i = 3; opaque && i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    return image;
}

struct Ball {
    unsigned width = 320, height = 240;
    float shift = 0;                   // pixels to the right
    float gain = 1;                    // on linear light
    bool second_light_flipped = false; // from the left instead of from the right
};

// A Lambert ball on a checkered wall, a strong light from above and a weaker reddish one from the side, 2x2 samples a pixel.
inline ImageF ball_radiance(const Ball& ball) {
    ImageF image{.width = ball.width, .height = ball.height, .rgba = {}};
    float radius = 0.4f * static_cast<float>(ball.height), side = ball.second_light_flipped ? -0.8f : 0.8f;
    auto sample = [&](float px, float py, float* sum) {
        float x = (px - ball.shift - 0.5f * static_cast<float>(ball.width)) / radius,
              y = (0.5f * static_cast<float>(ball.height) - py) / radius;
        float q = 1 - x * x - y * y;
        if (q <= 0) {
            bool dark = (static_cast<int>(std::floor(x * 4)) + static_cast<int>(std::floor(y * 4))) & 1;
            for (int c = 0; c < 3; ++c) sum[c] += dark ? 0.05f : 0.2f;
            return;
        }
        float z = std::sqrt(q);
        float above = 0.7f * std::max(0.0f, 0.8f * y + 0.6f * z), beside = std::max(0.0f, side * x + 0.6f * z);
        sum[0] += above + 0.25f * beside, sum[1] += above + 0.1f * beside, sum[2] += above + 0.1f * beside;
    };
    for (unsigned y = 0; y < ball.height; ++y) {
        for (unsigned x = 0; x < ball.width; ++x) {
            float sum[3] = {};
            for (float dy : {0.25f, 0.75f}) {
                for (float dx : {0.25f, 0.75f}) sample(static_cast<float>(x) + dx, static_cast<float>(y) + dy, sum);
            }
            for (float c : sum) image.rgba.push_back(ball.gain * c / 4);
            image.rgba.push_back(1);
        }
    }
    return image;
}

inline Image8 ball_picture(const Ball& ball = {}) {
    return display(ball_radiance(ball));
}

} // namespace lightbench::image_test
