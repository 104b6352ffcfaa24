// What is greyed changes no pixel, and what is not changes some: every toggle in every method, drawn.
#include "support/files.h"

#include "app/prepare.h"
#include "app/view/state.h"
#include "plan/explain.h"
#include "render/render.h"

#include <gtest/gtest.h>

namespace lightbench::view {
namespace {

// Something of everything: a checkered floor, a bumpy ball, a mirror, a pane, a lamp.
const char* const kEverything = R"([camera]
position = [0, 2, 6]
target = [0, 0.6, 0]
[[light]]
type = "point"
position = [3, 4, 5]
intensity = 6
attenuation = "linear"
[[material]]
name = "floor"
diffuse = [0.6, 0.6, 0.7]
texture = { checker = true }
[[material]]
name = "bumpy"
diffuse = [0.7, 0.1, 0.1]
specular = 0.5
shininess = 20
bump = { function = "waves", amplitude = 0.05, frequency = 12 }
[[material]]
name = "mirror"
diffuse = 0.1
specular = 0.3
reflection = 0.5
[[material]]
name = "shiny"
diffuse = 0.2
environment = 0.5
[[material]]
name = "pane"
diffuse = [0.1, 0.4, 0.2]
opacity = 0.4
[[material]]
name = "lamp"
diffuse = 0.2
emission = 2
[[object]]
shape = "polygon"
points = [[-4, 0, 4], [4, 0, 4], [4, 0, -4], [-4, 0, -4]]
material = "floor"
[[object]]
shape = "sphere"
center = [-1.2, 0.8, 0]
radius = 0.8
material = "bumpy"
[[object]]
shape = "sphere"
center = [1.2, 0.8, -0.5]
radius = 0.8
material = "mirror"
[[object]]
shape = "sphere"
center = [0, 0.5, 1]
radius = 0.4
material = "shiny"
[[object]]
shape = "box"
min = [-0.4, 0, 1.9]
max = [0.2, 1, 2]
material = "pane"
[[object]]
shape = "sphere"
center = [0, 2.2, -1]
radius = 0.3
material = "lamp"
)";

// As apply() does it where nothing is unavailable.
Request toggled(Action action, Request r) {
    switch (action) {
    case Action::flat: r.shading = Shading::flat; break;
    case Action::gouraud: r.shading = Shading::gouraud; break;
    case Action::model: r.model = Model::cook_torrance; break;
    case Action::attenuation: r.attenuation = Attenuation::none; break;
    case Action::texture: r.edits.without = kWithoutTexture; break;
    case Action::bump: r.edits.without = kWithoutBump; break;
    case Action::environment: r.edits.without = kWithoutEnvironment; break;
    case Action::transparency: r.edits.without = kWithoutTransparency; break;
    case Action::reflection: r.edits.without = kWithoutReflection; break;
    case Action::subdivide_more: r.subdivide = 1; break;
    case Action::samples_more: r.spp = 4; break;
    case Action::depth_less: r.depth = 1; break;
    case Action::hemicube_less: r.radiosity.hemicube = 8; break;
    case Action::show: r.radiosity.show = Show::patches; break;
    default: ADD_FAILURE(); break;
    }
    return r;
}

class Toggles : public testing::TestWithParam<Method> {
  protected:
    std::vector<std::uint8_t> picture(const Opened& opened, State state) {
        Scene scene = *opened.scene;
        const Prepared prepared = prepare(scene, request_of(state, 0, {64, 48}));
        Renderer renderer(device, scene, prepared.geometry, prepared.plan);
        return renderer.render(prepared.view).pixels->rgba;
    }
    gpu::Device device = gpu::Device::open({.validation = true});
};

TEST_P(Toggles, AreGreyedWhereTheyChangeNothing) {
    const auto file = std::filesystem::path(testing::TempDir()) / "lightbench-toggles.toml";
    write_text(file, kEverything);
    const Opened opened = open_scene(file, load_or_throw(file), {}, 1);
    std::filesystem::remove(file);
    State state = start({}, opened);
    state.side().method = GetParam(), state.side().radiosity.shots = 80, state.side().radiosity.hemicube = 32;
    const auto before = picture(opened, state);
    for (const Action action : {Action::flat, Action::gouraud, Action::model, Action::attenuation, Action::texture, Action::bump,
                                Action::environment, Action::transparency, Action::reflection, Action::subdivide_more, Action::samples_more,
                                Action::depth_less, Action::hemicube_less, Action::show}) {
        const auto reason = unavailable(action, state, opened);
        State other = state;
        other.side() = toggled(action, other.side());
        EXPECT_EQ(picture(opened, other) == before, reason.has_value()) << row_of(action).help << ": " << reason.value_or("not greyed");
    }
    EXPECT_TRUE(device.validation_messages().empty());
}

INSTANTIATE_TEST_SUITE_P(EachMethod, Toggles, testing::Values(Method::raster, Method::raytrace, Method::radiosity),
                         [](const auto& method) { return std::string(name_of(method.param)); });

} // namespace
} // namespace lightbench::view
