// Counts a scene's facts: one walk over lights, one over objects (which also marks the materials in use), one over those materials.
#include "plan/facts.h"

#include "scene/distribution.h"
#include "scene/surfaces.h"
#include "scene/tessellate.h"

#include <algorithm>
#include <set>

namespace lightbench {
namespace {

bool any(const glm::vec3& c) {
    return c.x > 0 || c.y > 0 || c.z > 0;
}

void count_light(const Light& light, Facts& facts) {
    if (!any(light.intensity)) return;
    ++facts.lights;
    if (light.type == LightType::directional) {
        ++facts.directional_lights;
        return;
    }
    ++(light.type == LightType::point ? facts.point_lights : facts.spot_lights);
    switch (light.attenuation) {
    case Attenuation::none: ++facts.unattenuated_lights; break;
    case Attenuation::linear: ++facts.linear_lights; break;
    case Attenuation::inverse_square: ++facts.inverse_square_lights; break;
    }
}

void count_model(const Material& material, Facts& facts) {
    if (!any(material.specular)) return;
    if (material.model == Model::phong)
        ++facts.phong_materials;
    else
        ++(material.distribution == Distribution::gaussian ? facts.gaussian_materials : facts.beckmann_materials);
    facts.smooth_lobes += material.model == Model::cook_torrance && material.roughness < kLeastRoughness;
}

void count_detail(const Material& material, Facts& facts) {
    facts.alpha_materials += material.texture && material.texture->alpha;
    if (material.texture) ++(material.texture->picture ? facts.picture_materials : facts.checker_materials);
    if (!material.bump || material.bump->amplitude == 0) return;
    facts.wave_materials += material.bump->function == BumpFunction::waves;
    facts.noise_materials += material.bump->function == BumpFunction::noise;
    if (material.bump->picture) ++(material.bump->normal_map ? facts.normal_map_materials : facts.height_materials);
}

void count_material(const Material& material, Facts& facts) {
    ++facts.materials;
    facts.diffuse_materials += any(material.diffuse);
    facts.white_materials += glm::any(glm::greaterThan(material.diffuse, glm::vec3(kMostReflectance)));
    facts.specular_materials += any(material.specular);
    facts.emissive_materials += any(material.emission);
    count_model(material, facts);
    count_detail(material, facts);
    facts.environment_materials += material.environment > 0;
    facts.translucent_materials += is_translucent(material);
    facts.clear_materials += glm::any(glm::lessThan(material.opacity, glm::vec3(1))) || (material.texture && material.texture->alpha);
    facts.one_sided_materials += hides_backs(material);
    facts.tinted_materials += any(material.transmission) && (material.ior.x != material.ior.y || material.ior.x != material.ior.z);
    facts.transmissive_materials += any(material.transmission);
    facts.reflective_materials += any(material.reflection.value_or(material.specular));
    facts.mirror_materials += material.reflection && any(*material.reflection) && material.environment == 0;
    facts.fresnel_materials += material.fresnel;
    facts.scattering_materials += material.scatter > 0;
    facts.dispersive_materials += material.dispersion.y != 0;
}

// Counts the shape, and says whether it is open: whether its inside can be seen without entering it.
struct ShapeCounter {
    Facts& facts;
    const Scene& scene;
    bool operator()(const Sphere&) const { return ++facts.spheres, false; }
    bool operator()(const Polygon& polygon) const {
        ++facts.polygons;
        facts.own_normals = facts.own_normals || !polygon.normals.empty();
        return true;
    }
    bool operator()(const Box&) const { return ++facts.boxes, false; }
    bool operator()(const Cylinder& cylinder) const { return ++facts.cylinders, !cylinder.capped; }
    bool operator()(const Cone& cone) const { return ++facts.cones, !cone.capped; }
    bool operator()(const Torus&) const { return ++facts.tori, false; }
    // Whether a mesh is closed is known after tessellation only; until then it counts as open: the bit may cost, it cannot hurt.
    bool operator()(const MeshUse& use) const {
        ++facts.mesh_objects;
        facts.own_normals = facts.own_normals || !scene.meshes[use.mesh].normals.empty();
        facts.mesh_faces += scene.meshes[use.mesh].face_count();
        return true;
    }
};

// What the materials of a mesh's own faces say; walked once a mesh, however many objects place it.
struct MeshMaterials {
    bool walked = false, two_sided = false;
};

// The mesh of an object whose faces have materials of their own, else nothing.
std::optional<std::uint32_t> mesh_with_materials(const Scene& scene, const Object& object) {
    const auto* use = std::get_if<MeshUse>(&object.shape);
    if (use == nullptr || scene.meshes[use->mesh].face_materials.empty()) return std::nullopt;
    return use->mesh;
}

// One looks through a translucent front, and sees the back.
bool seen_from_behind(const Material& material, bool open) {
    return material.two_sided.value_or(open || is_translucent(material));
}

// Marks the materials of a surface, and says whether it may be seen from behind: whether one of them does not forbid it.
bool mark_materials(const Scene& scene, const Object& object, bool open, std::vector<MeshMaterials>& meshes, std::vector<bool>& used) {
    const auto mesh = mesh_with_materials(scene, object);
    if (!mesh) {
        used[object.material] = true;
        return seen_from_behind(scene.materials[object.material], open);
    }
    MeshMaterials& known = meshes[*mesh];
    if (known.walked) return known.two_sided;
    known.walked = true;
    for (std::uint32_t material : scene.meshes[*mesh].face_materials) {
        used[material] = true;
        known.two_sided = known.two_sided || seen_from_behind(scene.materials[material], open);
    }
    return known.two_sided;
}

// A texture, or a bump that is a picture, is laid on the object by a mapping.
void count_mapping(const Scene& scene, const Object& object, std::uint32_t index, Facts& facts) {
    const Material& material = scene.materials[index];
    if (material.texture || (material.bump && material.bump->picture))
        ++facts.mappings[static_cast<std::size_t>(mapping_of(scene, object, material))];
}

void count_mappings(const Scene& scene, Facts& facts) {
    for (const Object& object : scene.objects) {
        const auto mesh = mesh_with_materials(scene, object);
        if (!mesh) {
            count_mapping(scene, object, object.material, facts);
            continue;
        }
        std::set<std::uint32_t> own(scene.meshes[*mesh].face_materials.begin(), scene.meshes[*mesh].face_materials.end());
        for (const std::uint32_t material : own) count_mapping(scene, object, material, facts);
    }
}

void count_objects(const Scene& scene, std::vector<bool>& used, Facts& facts) {
    std::vector<MeshMaterials> meshes(scene.meshes.size());
    for (const Object& object : scene.objects) {
        ++facts.objects;
        const bool open = std::visit(ShapeCounter{facts, scene}, object.shape);
        facts.two_sided_objects += mark_materials(scene, object, open, meshes, used);
    }
}

} // namespace

Facts gather_facts(const Scene& scene) {
    Facts facts;
    for (const Light& light : scene.lights) count_light(light, facts);
    std::vector<bool> used(scene.materials.size(), false);
    count_objects(scene, used, facts);
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) count_material(scene.materials[i], facts);
    if (std::ranges::any_of(scene.materials, [](const Material& m) { return m.texture || m.bump; })) count_mappings(scene, facts);
    facts.pictures = scene.pictures.size();
    facts.materials_listed = scene.materials.size();
    facts.ambient = any(scene.environment.ambient);
    facts.background = any(scene.environment.background);
    facts.environment_map = !scene.environment.map.empty(), facts.six_faces = scene.environment.map.size() == 6;
    facts.camera = !scene.cameras.empty();
    facts.film = scene.film.has_value();
    return facts;
}

void add_view(Facts& facts, const Scene& scene, const View& view) {
    if (facts.environment_materials > 0 && !facts.environment_map) facts.cubes = choose_cubes(scene, view);
}

void add_geometry(Facts& facts, const RasterGeometry& geometry) {
    facts.geometry = GeometryFacts{geometry.vertices.positions.size(), geometry.indices.size() / 3, geometry.polygons.positions.size(),
                                   geometry.surfaces.size(),           geometry.faces_two_sided,    geometry.dropped_degenerate,
                                   geometry.normals_may_vanish};
}

} // namespace lightbench
