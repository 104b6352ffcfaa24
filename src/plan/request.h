// What the user asked for: the options of the command line, checked for range but not yet held against the scene.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace lightbench {

enum class Method { raster, raytrace, radiosity };
enum class Shading { flat, gouraud, phong };
enum class Sampling { none, uniform, jittered, adaptive };
enum class Output { pixels, radiance }; // display-referred 8 bit (PNG), or linear radiance (EXR)

struct Rect {
    glm::uvec2 offset{0}, size{0};
}; // pixels, origin at the upper left

struct Request {
    Method method = Method::raster;
    Shading shading = Shading::phong;
    std::optional<glm::uvec2> size; // absent: the scene's [film], else 1280x720
    std::optional<Rect> crop;       // inside the image
    std::string camera;             // name; empty: the first
    std::optional<int> frame;       // of the turntable
    unsigned subdivide = 0;         // 0 to 8
    Sampling sampling = Sampling::none;
    unsigned spp = 1; // samples a pixel, a square, 1 to 1024
    std::uint32_t seed = 0;
    float exposure = 0; // stops
    Output output = Output::pixels;
    bool terms = false; // one layer a term (EXR only)
};

} // namespace lightbench
