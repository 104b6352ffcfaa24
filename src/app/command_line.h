// A request back as what one would type: the options that differ from the defaults, so that parse_scene_options() reads the same request.
#pragma once

#include "app/options.h"

#include <string>
#include <vector>

namespace lightbench {

// PX,PY,PZ:TX,TY,TZ:UX,UY,UZ:FOV[:HITHER]. Read back it is the same camera but for its name, and an fov that may differ in its last bit.
std::string text_of(const Camera& camera);

// Without the scene and without what belongs to one sub-command alone.
std::vector<std::string> options_of(const Request& request);

// As one line for a shell: words that need it are quoted.
std::string shell_line(const std::vector<std::string>& words);

} // namespace lightbench
