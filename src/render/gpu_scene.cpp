// Converts lights to the shared layout, in the frame's units, and fills the buffers.
#include "render/gpu_scene.h"

#include "gpu/check.h"
#include "render/materials.h"
#include "shared/effects.h"
#include "shared/layouts.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lightbench {
namespace {

using vk::BufferUsageFlagBits;

// With d' = s d: Ip / (d + d0) = s Ip / (d' + s d0) and Ip / (4 pi d^2) = s^2 Ip / (4 pi d'^2), so the frame's laws give the world's values.
double frame_gain(const Light& light, double s) {
    if (light.attenuation == Attenuation::linear) return s;
    return light.attenuation == Attenuation::inverse_square ? s * s : 1;
}

// A light that is farther away than 2^40 frame radii is brought there with all its lengths, by a power of two: its direction and what
// arrives change by less than 2^-38, and squares stay finite however small the scene is.
double light_scale(const Light& light, const Frame& frame) {
    const glm::dvec3 way = glm::abs(light.position - frame.origin);
    const double distance = std::max({way.x, way.y, way.z});
    return distance > 0 ? std::min(frame.scale, std::ldexp(1.0, 40 - std::ilogb(distance))) : frame.scale;
}

gpu_layout::Light to_gpu(const Light& light, const Frame& frame) {
    gpu_layout::Light out{};
    const bool directional = light.type == LightType::directional;
    const double scale = light_scale(light, frame);
    // Beside a d0 of 2^70 no distance up to 2^41 shows in a float: a larger one only makes both terms of the quotient overflow.
    const double d0 = std::min(light.d0, 0x1p70 / scale);
    const double gain = light.attenuation == Attenuation::linear && d0 < light.d0 ? 0x1p70 / light.d0 : frame_gain(light, scale);
    out.position = glm::vec3(directional ? -light.direction : scale * (light.position - frame.origin));
    out.type = static_cast<std::uint32_t>(light.type);
    out.intensity = glm::vec3(glm::dvec3(light.intensity) * (directional ? 1.0 : gain));
    out.attenuation = static_cast<std::uint32_t>(directional ? Attenuation::none : light.attenuation);
    out.axis = glm::vec3(light.direction);
    out.d0 = static_cast<float>(d0 * scale);
    out.cos_outer = static_cast<float>(std::cos(light.angle));
    out.cos_inner = static_cast<float>(std::cos(light.angle * (1 - light.softness)));
    return out;
}

bool shines(const Light& light) {
    return light.intensity.x > 0 || light.intensity.y > 0 || light.intensity.z > 0;
}

std::vector<gpu_layout::Light> lights_of(const Scene& scene, const Frame& frame) {
    std::vector<gpu_layout::Light> lights;
    for (const Light& light : scene.lights)
        if (shines(light)) lights.push_back(to_gpu(light, frame));
    return lights;
}

struct Uploader {
    gpu::Device& device;
    GpuScene& out;

    template <class T>
    gpu::Buffer table(std::string name, const std::vector<T>& values, std::uint32_t bit, vk::BufferUsageFlags more = {}) {
        static_assert(sizeof(T) % 16 == 0);
        if (values.empty()) return {};
        gpu::Buffer buffer = gpu::make_texel_buffer(device, std::move(name), values.size() * sizeof(T), more);
        gpu::upload(device, buffer, std::as_bytes(std::span(values)));
        if (!buffer.as_texel()) out.fetch_storage |= bit;
        return buffer;
    }
};

// What is written by shade-points and read as a table by the vertex stage or as vertex attributes.
gpu::Buffer color_buffer(Uploader& up, const char* name, std::size_t points, const Plan& plan, vk::BufferUsageFlags more) {
    gpu::Buffer buffer = gpu::make_texel_buffer(up.device, name, std::max<std::size_t>(points, 1) * plan.colors_of_point() * 16, more);
    if (!buffer.as_texel()) up.out.fetch_storage |= FETCH_COLORS;
    return buffer;
}

// Four object numbers a texel.
std::vector<glm::uvec4> pack_objects(const std::vector<std::uint32_t>& objects) {
    std::vector<glm::uvec4> packed((objects.size() + 3) / 4, glm::uvec4(0));
    for (std::size_t i = 0; i < objects.size(); ++i) packed[i / 4][static_cast<int>(i % 4)] = objects[i];
    return packed;
}

void upload_points(Uploader& up, const RasterGeometry& geometry, const Plan& plan) {
    GpuScene& out = up.out;
    const auto vertex = BufferUsageFlagBits::eVertexBuffer;
    if (plan.has("vertices")) out.positions = up.table("positions", geometry.vertices.positions, FETCH_POINTS, vertex);
    if (plan.has("indices") && !geometry.indices.empty())
        out.indices = gpu::make_filled_buffer(up.device, "indices", std::span(geometry.indices), BufferUsageFlagBits::eIndexBuffer);
    if (plan.has("normals")) out.normals = up.table("normals", geometry.vertices.normals, FETCH_POINTS, vertex);
    if (plan.has("detail")) {
        out.detail = up.table("detail", geometry.vertices.detail, FETCH_DETAIL, vertex);
        out.polygon_detail = up.table("polygon-detail", geometry.polygons.detail, FETCH_DETAIL);
    }
    if (plan.has("vertex-colors")) out.vertex_colors = color_buffer(up, "vertex-colors", out.vertex_count, plan, vertex);
    if (plan.has("polygon-colors")) {
        out.polygon_positions = up.table("polygon-positions", geometry.polygons.positions, FETCH_POINTS);
        out.polygon_normals = up.table("polygon-normals", geometry.polygons.normals, FETCH_POINTS);
        out.polygon_colors = color_buffer(up, "polygon-colors", out.polygon_count, plan, {});
    }
    if (std::ranges::find(plan.terms, "object") != plan.terms.end())
        out.polygon_objects = up.table("polygon-objects", pack_objects(geometry.polygon_objects), FETCH_OBJECTS);
}

} // namespace

GpuScene upload_scene(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan) {
    GpuScene out;
    Uploader up{device, out};
    const auto lights = lights_of(scene, geometry.frame);
    out.light_count = static_cast<std::uint32_t>(lights.size());
    out.vertex_count = static_cast<std::uint32_t>(geometry.vertices.positions.size());
    out.polygon_count = static_cast<std::uint32_t>(geometry.polygons.positions.size());
    if (plan.has("lights")) out.lights = up.table("lights", lights, FETCH_LIGHTS);
    const EnvironmentViews views = render_environment_cubes(device, scene, plan);
    out.cube_milliseconds = views.milliseconds;
    const bool has_tables = plan.has("materials") || plan.has("texels");
    MaterialTables tables = has_tables ? material_tables(scene, geometry, plan, views.cubes) : MaterialTables{};
    if (plan.method == Method::raytrace && tables.materials.empty())
        tables.materials.emplace_back(); // no object: passes bind it all the same
    if (plan.has("materials")) out.materials = up.table("materials", tables.materials, FETCH_MATERIALS);
    if (plan.has("texels")) out.texels = up.table("texels", tables.texels.words, FETCH_TEXELS);
    out.environment = tables.environment;
    // Lists of layers grow from image to image: they are read as texels only where every list can be.
    if (device.info().max_texel_elements * 16 < device.info().max_storage_range) out.fetch_storage |= FETCH_LAYERS;
    upload_points(up, geometry, plan);
    return out;
}

void offer_table(gpu::Bindings& bindings, std::string_view name, gpu::Buffer& buffer) {
    static const std::map<std::string_view, std::string_view> kStorageNames = {{"lights", "lights_storage"},
                                                                               {"materials", "materials_storage"},
                                                                               {"texels", "texels_storage"},
                                                                               {"positions", "positions_storage"},
                                                                               {"normals", "normals_storage"},
                                                                               {"detail", "detail_storage"},
                                                                               {"polygon_colors", "polygon_colors_storage"},
                                                                               {"polygon_objects", "polygon_objects_storage"},
                                                                               {"boxes", "boxes_storage"},
                                                                               {"shape_boxes", "shape_boxes_storage"},
                                                                               {"order", "order_storage"},
                                                                               {"pyramid", "pyramid_storage"},
                                                                               {"numbers", "numbers_storage"},
                                                                               {"ranges", "ranges_storage"},
                                                                               {"types", "types_storage"},
                                                                               {"ranks", "ranks_storage"},
                                                                               {"parents", "parents_storage"},
                                                                               {"table", "table_storage"},
                                                                               {"keys", "keys_storage"},
                                                                               {"values", "values_storage"},
                                                                               {"offsets", "offsets_storage"},
                                                                               {"counts", "counts_storage"},
                                                                               {"blocks", "blocks_storage"},
                                                                               {"layers", "layers_storage"},
                                                                               {"layer_surfaces", "layer_surfaces_storage"},
                                                                               {"layer_opacities", "layer_opacities_storage"},
                                                                               {"deep_pixels", "deep_pixels_storage"},
                                                                               {"keys_in", "keys_in_storage"},
                                                                               {"nodes", "nodes_storage"},
                                                                               {"narrow", "narrow_storage"},
                                                                               {"triangles", "triangles_storage"},
                                                                               {"spheres", "spheres_storage"},
                                                                               {"shapes", "shapes_storage"},
                                                                               {"corners", "corners_storage"},
                                                                               {"rays", "rays_storage"},
                                                                               {"hits", "hits_storage"},
                                                                               {"hit_rays", "hit_rays_storage"},
                                                                               {"points", "points_storage"},
                                                                               {"lit", "lit_storage"},
                                                                               {"tree", "tree_storage"},
                                                                               {"media", "media_storage"},
                                                                               {"eye_points", "eye_points_storage"}};
    if (!buffer) return;
    bindings.emplace_back(name, buffer);
    bindings.emplace_back(kStorageNames.at(name), buffer);
}

} // namespace lightbench
