// Haines' Neutral File Format (Haines 1987, "A Proposal for Standard Graphics Environments"): v b l f s c p pp and # comments.
// In: a file, or its text. Out: the Scene, or every problem with line and column.
#pragma once

#include "scene/load.h"

#include <string_view>

namespace lightbench {

Loaded load_nff(const std::filesystem::path& file, const LoadOptions& options);
Loaded load_nff_text(std::string_view text, const std::filesystem::path& file, const LoadOptions& options);

} // namespace lightbench
