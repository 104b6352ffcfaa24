// Where pictures go: checked before anything is rendered, written whole or not at all.
#pragma once

#include "image/image.h"
#include "plan/request.h"
#include "scene/problem.h"

#include <optional>
#include <string>
#include <vector>

namespace lightbench {

// By the extension, whatever its case: .png pixels, .exr radiance; nothing for others.
std::optional<Output> output_of(const std::string& path);

// The folder must exist, the extension must be known, and %04d (or %d) must stand in the name once if there are several frames.
void check_output(const std::string& path, bool several_frames, Problems& problems);

// `path` with its %04d replaced by the number; unchanged if it has none.
std::string frame_path(const std::string& path, int frame);

struct NamedImage {
    std::string name; // of the layer: a term of the plan
    const ImageF* image;
};

void write_pixels(const std::string& path, const Image8& pixels);
void write_radiance(const std::string& path, const ImageF& radiance, const std::vector<NamedImage>& layers = {});

} // namespace lightbench
