// glTF 2.0: the node tree of the file's scene with its meshes, lights and cameras. Transforms are composed in double; meshes are shared.
#include "scene/gltf_document.h"
#include "scene/gltf_mesh.h"
#include "scene/import_text.h"
#include "scene/limits.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace lightbench::importer {

namespace {

struct Placed {
    GltfValue node;
    std::size_t index = 0, depth = 0;
    glm::dmat4 world_from_node{1};
};

struct Sixteen {
    using value_type = double;
    static constexpr int length() { return 16; }
    double values[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    double& operator[](int i) { return values[i]; }
};

// Section 3.5.3: a matrix, column by column, or T * R * S.
glm::dmat4 local_transform(const GltfValue& node) {
    if (node.has("matrix")) {
        Sixteen m = node.numbers("matrix", Sixteen{});
        glm::dmat4 matrix;
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[i];
        return matrix;
    }
    const glm::dvec4 r = node.numbers("rotation", glm::dvec4(0, 0, 0, 1));
    const double length = glm::length(r);
    const glm::dquat rotation = length > 0 ? glm::dquat(r.w / length, r.x / length, r.y / length, r.z / length) : glm::dquat(1, 0, 0, 0);
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), node.numbers("translation", glm::dvec3(0)));
    return glm::scale(moved * glm::mat4_cast(rotation), node.numbers("scale", glm::dvec3(1)));
}

// The nodes of the file's scene; without one, those that are no node's child.
std::vector<std::size_t> root_nodes(const GltfValue& root, std::size_t nodes) {
    std::vector<std::size_t> roots;
    const auto add = [&](const GltfValue& list, auto&& use) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Json& value = (*list.json)[i];
            if (value.is_number_unsigned() && value.get<std::uint64_t>() < nodes)
                use(value.get<std::size_t>());
            else
                list.problem(fmt::format("must hold numbers of nodes; there are {}", nodes));
        }
    };
    const GltfValue scenes = root.array("scenes");
    if (scenes.size() > 0) {
        const auto chosen = root.has("scene") ? root.index("scene", scenes.size()) : std::optional<std::size_t>(0);
        if (chosen) add(scenes.item(*chosen).array("nodes"), [&](std::size_t node) { roots.push_back(node); });
        return roots;
    }
    std::vector<bool> is_child(nodes, false);
    for (std::size_t i = 0; i < nodes; ++i)
        add(root.array("nodes").item(i).array("children"), [&](std::size_t node) { is_child[node] = true; });
    for (std::size_t i = 0; i < nodes; ++i)
        if (!is_child[i]) roots.push_back(i);
    return roots;
}

// Depth first in the file's order; a node that is reached twice would be drawn twice, or for ever.
std::vector<Placed> place_nodes(const GltfValue& root) {
    const GltfValue nodes = root.array("nodes");
    std::vector<bool> seen(nodes.size(), false);
    std::vector<Placed> placed, open;
    const auto add = [&](std::size_t index, std::size_t depth, const glm::dmat4& parent) {
        const GltfValue node = nodes.item(index);
        if (!node) return;
        if (seen[index]) return node.problem("is the child of two nodes, or of itself");
        if (depth > limits::kMaxNesting) return node.problem(fmt::format("lies deeper than {} nodes", limits::kMaxNesting));
        seen[index] = true;
        open.push_back({node, index, depth, parent * local_transform(node)});
    };
    const std::vector<std::size_t> roots = root_nodes(root, nodes.size());
    for (auto i = roots.rbegin(); i != roots.rend(); ++i) add(*i, 1, glm::dmat4(1));
    while (!open.empty() && root.report->ok()) {
        placed.push_back(open.back());
        open.pop_back();
        const Placed parent = placed.back();
        const GltfValue children = parent.node.array("children");
        for (std::size_t i = children.size(); i-- > 0;) {
            const Json& child = (*children.json)[i];
            if (child.is_number_unsigned() && child.get<std::uint64_t>() < nodes.size())
                add(child.get<std::size_t>(), parent.depth + 1, parent.world_from_node);
            else
                children.problem(fmt::format("must hold numbers of nodes; there are {}", nodes.size()));
        }
    }
    return placed;
}

bool stays_in_range(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(m[column][row]) <= limits::kMaxCoordinate)) return false;
    return true;
}

glm::dvec3 point(const Placed& at, const glm::dvec3& p) {
    return glm::dvec3(at.world_from_node * glm::dvec4(p, 1));
}
glm::dvec3 direction(const Placed& at, const glm::dvec3& d) {
    const glm::dvec3 turned(at.world_from_node * glm::dvec4(d, 0));
    const double length = glm::length(turned);
    return length > 0 ? turned / length : d;
}

// KHR_lights_punctual: candela and lux. Ip is irradiance over pi: S4's inverse-square law divides by 4 pi d^2, so Ip = 4 cd, and lux/pi.
void add_light(ImportJob& job, const GltfValue& light, const Placed& at) {
    Light l;
    const std::string type = light.text("type");
    if (type != "point" && type != "directional" && type != "spot") return light.problem("type must be point, directional or spot");
    l.type = type == "point" ? LightType::point : type == "spot" ? LightType::spot : LightType::directional;
    l.position = point(at, glm::dvec3(0)), l.direction = direction(at, {0, 0, -1});
    l.attenuation = l.type == LightType::directional ? Attenuation::none : Attenuation::inverse_square;
    const double to_ip = l.type == LightType::directional ? std::numbers::inv_pi : 4;
    l.intensity = glm::max(glm::vec3(glm::dvec3(light.numbers("color", glm::vec3(1))) * (light.number("intensity", 1) * to_ip)), 0.0f);
    const GltfValue spot = light.object("spot");
    const double outer = spot.number("outerConeAngle", std::numbers::pi / 4), inner = spot.number("innerConeAngle", 0);
    if (l.type == LightType::spot && !(outer > 0 && outer <= std::numbers::pi / 2 && inner >= 0 && inner <= outer))
        return spot.problem("its angles must satisfy 0 <= innerConeAngle <= outerConeAngle <= pi/2, outerConeAngle > 0");
    l.angle = outer, l.softness = 1 - inner / outer;
    if (light.has("range")) job.report.remark("the range of lights is not used");
    job.scene.lights.push_back(l);
}

void add_camera(ImportJob& job, const GltfValue& camera, const Placed& at) {
    const GltfValue perspective = camera.object("perspective");
    if (!perspective) return job.report.remark("orthographic cameras are not used");
    Camera c;
    const std::string name = camera.text("name");
    c.name = clean_name(name.empty() ? at.node.text("name") : name);
    c.position = point(at, glm::dvec3(0));
    c.target = c.position + direction(at, {0, 0, -1}), c.up = direction(at, {0, 1, 0});
    c.fov = perspective.number("yfov", c.fov), c.hither = perspective.number("znear", 0);
    if (!(c.fov > 0 && c.fov < std::numbers::pi))
        return perspective.problem(fmt::format("yfov is {:g}; it must lie between 0 and pi", c.fov));
    job.scene.cameras.push_back(c);
}

// A skin places its mesh by its joints, whose rest pose leaves the vertices where they are; the node's own transform does not count (3.7.3.3).
void add_objects(ImportJob& job, const Placed& at, const std::vector<GltfMeshUse>& uses) {
    const bool skinned = at.node.has("skin");
    if (skinned) job.report.remark("skins are not used: the bind pose is drawn");
    const std::uint32_t transform = uses.empty() || skinned ? 0 : add_transform(job.scene, at.world_from_node);
    for (const GltfMeshUse& use : uses) {
        Object object;
        object.shape = MeshUse{use.mesh};
        object.material = use.material, object.transform = transform;
        if (job.scene.meshes[use.mesh].normals.empty()) object.crease = 0; // section 3.7.2.1: without normals, flat
        job.scene.objects.push_back(object);
    }
}

void add_nodes(ImportJob& job, const GltfDocument& document, const std::vector<Placed>& placed) {
    const GltfValue meshes = document.root().array("meshes"), cameras = document.root().array("cameras");
    const GltfValue lights = document.root().extension("KHR_lights_punctual").array("lights");
    std::set<std::size_t> used;
    for (const Placed& at : placed)
        if (const auto mesh = at.node.index("mesh", meshes.size())) used.insert(*mesh);
    const auto uses = add_gltf_meshes(job, document, used);
    for (const Placed& at : placed) {
        if (!stays_in_range(at.world_from_node)) at.node.problem(fmt::format("its transform passes {:g}", limits::kMaxCoordinate));
        if (const auto mesh = at.node.index("mesh", meshes.size()); mesh && uses.contains(*mesh)) add_objects(job, at, uses.at(*mesh));
        if (const auto camera = at.node.index("camera", cameras.size())) add_camera(job, cameras.item(*camera), at);
        if (const auto light = at.node.extension("KHR_lights_punctual").index("light", lights.size()))
            add_light(job, lights.item(*light), at);
    }
    if (document.root().array("animations").size() > 0) job.report.remark("animations are not used");
}

} // namespace

void import_gltf(ImportJob& job) {
    const auto document = open_gltf(job);
    if (!document) return;
    const std::vector<Placed> placed = place_nodes(document->root());
    if (job.report.ok()) add_nodes(job, *document, placed);
}

} // namespace lightbench::importer
