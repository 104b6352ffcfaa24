#include "app/view/panel_rows.h"

#include <fmt/format.h>

namespace lightbench::view {

using A = Action;

std::span<const Row> rows_of(Rows part) {
    static const std::vector<Row> scene = {{A::copy}, {A::screenshot}, {A::frame, A::reset, A::vsync}, {A::help, A::panel}},
                                  surfaces = {{A::raster, A::raytrace, A::radiosity},
                                              {A::flat, A::gouraud, A::phong},
                                              {A::model},
                                              {A::attenuation},
                                              {A::texture, A::bump},
                                              {A::environment, A::reflection},
                                              {A::transparency},
                                              {A::wireframe, A::normals}},
                                  detail = {{A::structure}, {A::show}}, compare = {{A::split, A::side}, {A::map}};
    switch (part) {
    case Rows::scene: return scene;
    case Rows::surfaces: return surfaces;
    case Rows::detail: return detail;
    case Rows::compare: break;
    }
    return compare;
}

// What is on is colored.
std::string button_text(Action action, const State& state) {
    const KeyRow& row = row_of(action);
    const std::string setting = setting_of(action, state);
    const bool plain = setting.empty() || setting == "on" || setting == "off";
    return fmt::format("{}  [{}]{}{}", row.label, row.shortcut, plain ? "" : "  ", plain ? "" : setting);
}

} // namespace lightbench::view
