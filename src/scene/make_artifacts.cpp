// Scenes in which interpolated shading is known to fail (S8): the corrugated sheet, the lost highlight, Mach bands, smoothed creases.
// Shapes are meshes wherever the count of their facets is the point.
#include "scene/make_kinds.h"

#include <cmath>

namespace lightbench {
namespace {

constexpr double kPi = std::numbers::pi;

// To whole nanometres: a cosine of a right angle, 6e-17, becomes the 0 that a reader of the file expects.
std::uint32_t add_vertex(Mesh& mesh, const glm::dvec3& p) {
    mesh.positions.emplace_back(glm::round(p * 1e9) / 1e9 + 0.0); // and no -0
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

// Quads between consecutive pairs of vertices (2i, 2i + 1) and (2i + 2, 2i + 3).
void add_strip(Mesh& mesh, std::uint32_t first, std::uint32_t quads) {
    for (std::uint32_t i = 0; i < quads; ++i) {
        const std::uint32_t v = first + 2 * i;
        add_face(mesh, {v, v + 1, v + 3, v + 2});
    }
}

// A prism about the vertical line through (x, z), from y0 to y1, `sides` corners at `radius`, with both ends.
Mesh prism(std::string name, double x, double z, double radius, double y0, double y1, std::uint32_t sides, double turn) {
    Mesh mesh;
    mesh.name = std::move(name);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double a = turn + 2 * kPi * i / sides;
        for (const double y : {y1, y0}) add_vertex(mesh, {x + radius * std::sin(a), y, z + radius * std::cos(a)});
    }
    mesh.face_starts.push_back(0);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
        add_face(mesh, {a, a + 1, b + 1, b});
    }
    for (std::uint32_t i = 0; i < sides; ++i) mesh.corners.push_back(2 * i);
    mesh.face_starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    for (std::uint32_t i = sides; i-- > 0;) mesh.corners.push_back(2 * i + 1);
    mesh.face_starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    return mesh;
}

} // namespace

// A zigzag of equal sides: at every ridge and valley the mean of the two face normals points straight up (only the sheet's first and last
// row, which have one face, differ; the picture is cropped there). With strips within a side the vertices inside it keep the side's normal.
Scene make_corrugated(const MakeValues& values) {
    Scene scene;
    const auto ridges = values.count("ridges"), strips = values.count("subdivide");
    const double width = 4, depth = 3, half = width / static_cast<double>(2 * ridges); // metres, of one side seen from above
    const double height = half * std::tan(radians_of(values["slope"]));
    Mesh sheet;
    sheet.name = "sheet";
    const std::size_t rows = 2 * ridges * strips;
    for (std::size_t i = 0; i <= rows; ++i) {
        const double along = static_cast<double>(i) / static_cast<double>(strips); // in sides
        const double rise = std::fabs(std::fmod(along + 1, 2.0) - 1);              // 0 in a valley, 1 on a ridge
        for (const double z : {-depth / 2, depth / 2}) add_vertex(sheet, {along * half - width / 2, rise * height, z});
    }
    add_strip(sheet, 0, static_cast<std::uint32_t>(rows));
    add_camera(scene, {0, 3.2, 3.2}, {0, 0, 0.1}, 36);
    add_directional_light(scene, {1, -0.8, -0.15}, {1, 0.95f, 0.85f});
    scene.environment.ambient = glm::vec3(0.08f);
    Object& object = add_mesh(scene, std::move(sheet), add_diffuse(scene, "tin", {0.55f, 0.65f, 0.75f}));
    object.crease = static_cast<float>(kPi); // smooth over every edge: that is the failure
    scene.materials[0].two_sided = true;
    return scene;
}

// The light stands so that its mirror direction meets the eye in the middle of the triangle, half a side away from every vertex.
Scene make_highlight(const MakeValues& values) {
    Scene scene;
    const double side = 4, inner = side / (2 * std::sqrt(3.0)); // metres; radius of the circle within
    const std::uint32_t paint = add_glossy(scene, "lacquer", {0.45f, 0.08f, 0.1f}, 0.7f, static_cast<float>(values["shininess"]));
    Object& triangle = add_polygon(scene, {{-side / 2, 0, inner}, {side / 2, 0, inner}, {0, 0, -2 * inner}}, paint);
    triangle.subdivide = static_cast<std::uint8_t>(values.count("subdivide"));
    add_camera(scene, {0, 2.4, 3.2}, {0, 0, 0}, 50);
    add_point_light(scene, {0, 1.5, -2}, glm::vec3(3.2f));
    scene.environment.ambient = glm::vec3(0.15f);
    return scene;
}

// Behind: half a cylinder of few facets, whose Gouraud intensity is piecewise linear and kinks at every edge. In front: dark plateau, linear
// ramp, bright plateau, the figure in which Mach (1865) saw a dark and a bright line that are not there; its normals are its own.
Scene make_mach_band(const MakeValues& values) {
    Scene scene;
    const auto facets = static_cast<std::uint32_t>(values.count("facets"));
    Mesh column;
    column.name = "column";
    for (std::uint32_t i = 0; i <= facets; ++i) {
        const double a = kPi * i / facets;
        for (const double y : {2.2, 0.9}) add_vertex(column, {-2 * std::cos(a), y, 0.8 * std::sin(a) - 0.8});
    }
    add_strip(column, 0, facets);
    Mesh ramp;
    ramp.name = "ramp";
    for (const double x : {-2.0, -0.7, 0.7, 2.0})
        for (const double y : {0.6, 0.0}) {
            const double tilt = radians_of(x < 0 ? -70 : -20); // against the light, which comes from the right
            add_vertex(ramp, {x, y, 0});
            ramp.normals.emplace_back(std::sin(tilt), 0, std::cos(tilt));
        }
    add_strip(ramp, 0, 3);
    const std::uint32_t plaster = add_diffuse(scene, "plaster", glm::vec3(0.8f));
    scene.materials[plaster].two_sided = true;
    add_mesh(scene, std::move(column), plaster).crease = static_cast<float>(kPi);
    add_mesh(scene, std::move(ramp), plaster);
    add_camera(scene, {0, 1.1, 5}, {0, 1.1, 0}, 32);
    add_directional_light(scene, {-0.3, 0, -1}, glm::vec3(1));
    return scene;
}

// The same two bodies twice: a cube and a fine prism, each with edges of 90 degrees, and the prism's sides 15 degrees from one another.
Scene make_crease(const MakeValues& values) {
    Scene scene;
    const std::uint32_t clay = add_glossy(scene, "clay", {0.75f, 0.5f, 0.35f}, 0.25f, 25),
                        floor = add_diffuse(scene, "floor", glm::vec3(0.35f));
    add_polygon(scene, {{-20, 0, 20}, {20, 0, 20}, {20, 0, -20}, {-20, 0, -20}}, floor);
    for (const bool right : {false, true}) {
        const double x = right ? 1.7 : -1.7;
        const auto crease = static_cast<float>(radians_of(values[right ? "crease" : "left"]));
        const std::string side = right ? "right" : "left";
        add_mesh(scene, prism("cube-" + side, x - 0.75, 0, 0.75, 0, 1.1, 4, radians_of(20)), clay).crease = crease;
        add_mesh(scene, prism("prism-" + side, x + 0.8, 0.1, 0.55, 0, 1.3, 24, 0), clay).crease = crease;
    }
    add_camera(scene, {0, 2.6, 6}, {0, 0.5, 0}, 35);
    add_point_light(scene, {-3, 5, 5}, glm::vec3(6, 5.8f, 5.2f));
    add_directional_light(scene, {-1, -0.6, -0.4}, {0.12f, 0.16f, 0.25f});
    scene.environment.ambient = glm::vec3(0.1f);
    scene.environment.background = {0.02f, 0.025f, 0.035f};
    return scene;
}

} // namespace lightbench
