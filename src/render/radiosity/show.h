// Radiosity made visible: patches in colors of their own, the form factors of one, what its hemi-cube sees. In: PatchMesh. Out: colors an
// element, pictures. Inside this room only.
#pragma once

#include "image/image.h"
#include "plan/complete.h"
#include "radiosity/patches.h"

#include <optional>
#include <span>

namespace lightbench {

// The element that is seen through a point of the image, (0, 0) its upper left corner; none where nothing is.
std::optional<std::uint32_t> element_at(const PatchMesh& mesh, const View& view, const glm::dvec2& pixel);

// Linear colors an element: every patch its own, its elements as a checkerboard of two shades; `picked`, a patch, in white.
std::vector<glm::vec3> patch_colors(const PatchMesh& mesh, std::optional<std::uint32_t> picked);

// Black through red and yellow to white, by the logarithm of F A_patch / A_element over four decades below the largest.
std::vector<glm::vec3> form_factor_colors(const PatchMesh& mesh, std::span<const std::uint32_t> row, std::uint32_t patch);

// The five faces laid out around the top, as large as fits into `size`; black where nothing is seen. `items` as shaders/shared/radiosity.h
// orders them.
ImageF unfold(std::span<const std::uint32_t> items, unsigned resolution, std::span<const glm::vec3> of_elements, glm::uvec2 size);

} // namespace lightbench
