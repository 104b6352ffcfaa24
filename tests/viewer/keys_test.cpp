// The one table of keys, and all that is made of it; and requests as the options that they are typed with. Neither window nor device.
#include "app/command_line.h"
#include "app/numbers.h"
#include "app/view/camera.h"
#include "app/view/keys.h"
#include "app/view/live.h"
#include "app/view/panel_rows.h"

#include <fstream>
#include <gmock/gmock.h>
#include <random>
#include <set>

namespace lightbench::view {
namespace {

using ::testing::HasSubstr;

TEST(Keys, NoneIsBoundTwiceAndEveryActionHasOne) {
    std::set<std::pair<int, int>> bound;
    std::set<Action> actions;
    for (const KeyRow& row : keys()) {
        EXPECT_TRUE(bound.insert({row.key, row.modifiers}).second) << row.shortcut;
        EXPECT_TRUE(actions.insert(row.action).second) << row.shortcut;
        EXPECT_EQ(find_key(row.key, row.modifiers), &row);
    }
    EXPECT_EQ(actions.size(), static_cast<std::size_t>(Action::down) + 1);
}

TEST(Keys, ReadmeAndOverlaySayWhatTheTableDoes) {
    std::ifstream file(LIGHTBENCH_SOURCE "/README.md");
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    EXPECT_THAT(readme, HasSubstr(keys_markdown())) << "lightbench view --list-keys prints what belongs there";
    const auto shown = help_lines();
    for (const KeyRow& row : keys())
        EXPECT_TRUE(std::ranges::any_of(shown, [&](const HelpLine& line) {
            return std::string(line.key) == row.shortcut && std::string(line.help) == row.help;
        })) << row.shortcut;
    EXPECT_EQ(shown.size(), keys().size() + gestures().size());
}

Opened opened_ball() {
    Scene scene;
    scene.materials.emplace_back(), scene.objects.push_back({Sphere{}});
    return open_scene("ball.toml", scene, {}, 1);
}

// Each action over and over: every setting that a button can show.
TEST(Panel, NoTextIsWiderThanItsButton) {
    const Opened opened = opened_ball();
    std::size_t actions = 0;
    for (const Method method : {Method::raster, Method::raytrace, Method::radiosity})
        for (const Rows part : {Rows::scene, Rows::surfaces, Rows::detail, Rows::compare})
            for (const Row& row : rows_of(part))
                for (const Action action : row) {
                    State state = start({}, opened);
                    state.side().method = method, state.side().radiosity.pick = glm::uvec2(0), state.split = true, ++actions;
                    for (int i = 0; i < 8; ++i, apply(action, state, opened, 1))
                        EXPECT_LE(static_cast<float>(button_text(action, state).size()) * kLetter + 2 * kFramePadding,
                                  button_width(row.size()))
                            << button_text(action, state);
                }
    EXPECT_GT(actions, 60u);
}

TEST(State, ResetBringsBackAllThatIsShown) {
    const Opened opened = opened_ball();
    State state = start({}, opened);
    state.sliders = state.first_sliders = {{"gain", 0.25f}};
    for (const Action action : {Action::wireframe, Action::normals, Action::split, Action::map, Action::flat, Action::raytrace})
        apply(action, state, opened, 1);
    state.sliders = {{"gain", 1.0f}, {"other", 2.0f}}, state.wipe = 0.9f;
    orbit(state.camera, {1, 0.2});
    apply(Action::reset, state, opened, 1);
    EXPECT_EQ(state.sliders, state.first_sliders);
    EXPECT_FALSE(state.split || state.wireframe || state.normals);
    EXPECT_EQ(state.wipe, 0.5f);
    EXPECT_EQ(state.map, Map::wipe);
    EXPECT_EQ(state.active, 0u);
    EXPECT_TRUE(state.sides[0] == state.first && state.camera == opened.camera);
}

// All that an action may change.
std::string fingerprint(State s) {
    std::string text = text_of(s.camera);
    for (unsigned side = 0; side < 2; ++side) text += shell_line(options_of(request_of(s, side, {64, 48})));
    for (const KeyRow& row : keys()) text += fmt::format("|{}", setting_of(row.action, s));
    return text + fmt::format("{}{}{}{}{}", s.panel, s.help, s.copy, s.screenshot, s.quit);
}

TEST(State, EveryActionChangesSomethingSomewhere) {
    Scene scene;
    Material m;
    m.specular = glm::vec3(0.5f), m.texture = Texture{}, m.bump = Bump{}, m.bump->function = BumpFunction::waves;
    m.opacity = glm::vec3(0.5f), m.transmission = glm::vec3(0.2f), m.environment = 0.3f, m.reflection = glm::vec3(0.4f);
    scene.materials = {m}, scene.objects.push_back({Sphere{}}), scene.lights.push_back(Light{});
    const Opened opened = open_scene("ball.toml", scene, {}, 1);
    for (const KeyRow& row : keys()) {
        if (row.group == Group::fly) continue; // while keys are held
        bool changes = false;
        for (const Method method : {Method::raster, Method::raytrace, Method::radiosity}) {
            State state = start({}, opened);
            if (row.action == Action::phong) state.side().shading = Shading::flat;
            state.side().method = method, state.side().subdivide = 2, state.side().spp = 4, state.wireframe = true;
            if (row.action == Action::side || row.action == Action::map) apply(Action::split, state, opened, 1);
            orbit(state.camera, {1, 0.2});
            const std::string before = fingerprint(state);
            apply(row.action, state, opened, 1);
            changes |= fingerprint(state) != before;
        }
        EXPECT_TRUE(changes) << row.help;
    }
}

TEST(State, AFrameOfTheTurntableIsWhereItStarts) {
    Scene scene;
    scene.materials.emplace_back(), scene.objects.push_back({Sphere{}});
    Request turned;
    turned.frame = 30;
    EXPECT_FALSE(open_scene("ball.toml", scene, turned, 1).camera == opened_ball().camera);
}

// Shaders of a method that was left do not hold up what is shown.
TEST(LiveShaders, AreAwaitedWhereThePictureUsesThem) {
    Trial trial;
    trial.requests = {{}};
    LiveNews news;
    news.pending = {"raster/surface.frag"};
    EXPECT_TRUE(is_awaited(news, {"raster/surface.frag"}, trial));
    EXPECT_FALSE(is_awaited(news, {"raytrace/eye.comp"}, trial));
    std::swap(news.pending, news.ready);
    EXPECT_TRUE(is_awaited(news, {"raster/surface.frag"}, trial)) << "compiled, not tried";
    news.tried = key_of(trial);
    EXPECT_FALSE(is_awaited(news, {"raster/surface.frag"}, trial)) << "tried, and not used by this picture";
    trial.requests[0].placed = Camera{};
    EXPECT_FALSE(is_awaited(news, {"raster/surface.frag"}, trial)) << "from elsewhere";
    trial.requests[0].shading = Shading::flat;
    EXPECT_TRUE(is_awaited(news, {"raster/surface.frag"}, trial)) << "other shaders may run";
    news.errors.push_back({});
    EXPECT_FALSE(is_awaited(news, {"raster/surface.frag"}, trial)) << "nothing is going to come";
}

// What parse_scene_options() makes of the words.
Request parsed(const std::vector<std::string>& words) {
    Given given{{"SCENE", "scene.toml"}};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool value = i + 1 < words.size() && !words[i + 1].starts_with("--");
        given[words[i]] = value ? words[i + 1] : "";
        i += value;
    }
    Problems problems;
    const SceneOptions options = parse_scene_options(given, problems);
    for (const Problem& problem : problems) ADD_FAILURE() << to_string(problem);
    return options.request;
}

// Degrees to radians may end one ulp beside; what the viewer renders is what it read back, so that twice is as good as for ever.
TEST(CommandLine, ReadsBackAsTheSameRequest) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(-1e3, 1e3);
    for (int i = 0; i < 2000; ++i) {
        Request r;
        r.method = static_cast<Method>(random() % 3), r.shading = static_cast<Shading>(random() % 3);
        r.size = glm::uvec2(random() % 4000 + 1, random() % 4000 + 1);
        r.spp = static_cast<unsigned>((random() % 5 + 1) * (random() % 5 + 1));
        r.spp = i % 2 ? 4 : 9;
        r.subdivide = random() % 9, r.depth = random() % 255 + 1, r.seed = static_cast<std::uint32_t>(random());
        r.exposure = static_cast<float>(number(random) / 1e2), r.cutoff = static_cast<float>(random() % 1000) / 1000;
        r.opaque_shadows = random() % 2, r.accel = static_cast<Structure>(random() % 5);
        r.edits.without = random() % 32;
        if (i % 3) r.model = static_cast<Model>(random() % 2), r.attenuation = static_cast<Attenuation>(random() % 3);
        if (r.method == Method::radiosity)
            r.radiosity.hemicube = 2 * (random() % 500 + 4), r.radiosity.until = 0.01, r.radiosity.ambient = i % 2;
        Camera camera;
        camera.position = {number(random), number(random), number(random)}, camera.target = {number(random), 0.1, 1e-300};
        camera.fov = (number(random) + 1001) / 1e3;
        r.placed = parse_camera(text_of(camera));
        ASSERT_TRUE(r.placed);
        EXPECT_EQ(r.placed->position, camera.position);
        EXPECT_EQ(r.placed->target, camera.target);
        EXPECT_TRUE(parsed(options_of(r)) == r) << shell_line(options_of(r));
    }
}

TEST(CommandLine, QuotesWhatAShellWouldTakeApart) {
    EXPECT_EQ(shell_line({"a", "b c", "it's", ""}), R"(a 'b c' 'it'\''s' '')");
}

TEST(Camera, OrbitsAtOneDistanceAndNeverOverThePole) {
    Camera camera;
    const double distance = glm::length(camera.position - camera.target);
    for (int i = 0; i < 100; ++i) orbit(camera, {0.3, -0.2});
    EXPECT_NEAR(glm::length(camera.position - camera.target), distance, 1e-12);
    EXPECT_GT(camera.position.y, 0.99 * distance);
    EXPECT_GT(basis_of(camera).up.y, 0); // upright still
}

TEST(Camera, FramesAllCornersOfTheBox) {
    const Bounds box{{-3, 1, 2}, {4, 9, 5}};
    for (const double aspect : {0.3, 1.0, 3.0}) {
        Camera camera;
        frame(camera, box, aspect);
        const Basis b = basis_of(camera);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p(corner & 1 ? 4 : -3, corner & 2 ? 9 : 1, corner & 4 ? 5 : 2);
            const glm::dvec3 v = p - camera.position;
            const double z = glm::dot(v, b.forward), high = std::tan(camera.fov / 2);
            EXPECT_LE(std::abs(glm::dot(v, b.up)), z * high);
            EXPECT_LE(std::abs(glm::dot(v, b.right)), z * high * aspect);
        }
    }
}

} // namespace
} // namespace lightbench::view
