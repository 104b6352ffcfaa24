// The material of objects to which a file gives none.
#pragma once

#include "scene/scene.h"

namespace lightbench {

inline Material default_material() {
    Material m;
    m.name = "default";
    return m;
}

} // namespace lightbench
