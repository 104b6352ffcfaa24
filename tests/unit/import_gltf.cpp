// glTF 2.0: node transforms, shared meshes, materials, lights and cameras against values worked out by hand from the specification.
#include "unit/import_support.h"

#include <gmock/gmock.h>
#include <numbers>

namespace lightbench {
namespace {

using namespace importer_test;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kOneNode = R"("nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0)";

Material material_of(const std::string& json) {
    const Loaded loaded =
        import_text("a.gltf", triangle_gltf(std::string(kOneNode) + R"(,"materials":[)" + json + "]", R"(,"material":0)"));
    EXPECT_TRUE(loaded.scene) << all_problems(loaded);
    return loaded.scene ? loaded.scene->materials.at(loaded.scene->objects.at(0).material) : Material{};
}

std::string glb(std::string json, std::string binary) {
    while (json.size() % 4) json += ' ';
    while (binary.size() % 4) binary += '\0';
    std::string file = "glTF";
    append(file, std::uint32_t{2});
    append(file, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
    append(file, static_cast<std::uint32_t>(json.size()));
    file += "JSON" + json;
    append(file, static_cast<std::uint32_t>(binary.size()));
    return file + std::string("BIN\0", 4) + binary;
}

TEST(ImportGltf, ReadsATriangle) {
    const Loaded loaded = import_text("a.gltf", triangle_gltf(kOneNode));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->objects.size(), 1u);
    EXPECT_EQ(loaded.scene->objects[0].transform, 0u);
    EXPECT_EQ(loaded.scene->objects[0].crease, 0.0f) << "without normals: flat, says the specification";
    EXPECT_THAT(corners(loaded.scene->meshes.at(0), 0), ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_EQ(loaded.scene->materials.at(0), Material{});
    EXPECT_EQ(all_remarks(loaded), "");
}

TEST(ImportGltf, ReadsTheSameFromAFileAndFromGlb) {
    const Folder folder;
    folder.write("b in.bin", triangle_bytes());
    const std::string mesh = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)" + std::string(kOneNode) + "}";
    const auto file = folder.write("a.gltf", R"({"asset":{"version":"2.0"},)" + triangle_parts("b%20in.bin") + mesh);
    const auto binary = folder.write("a.glb", glb(R"({"asset":{"version":"2.0"},)" + triangle_parts("") + mesh, triangle_bytes()));
    for (const auto& path : {file, binary}) {
        const Loaded loaded = import_file(path);
        ASSERT_TRUE(loaded.scene) << all_problems(loaded);
        EXPECT_THAT(corners(loaded.scene->meshes.at(0), 0), ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    }
}

TEST(ImportGltf, ComposesTransformsInDoubleAndSharesMeshes) {
    // The child turns +x to +y (90 degrees about z) and the parent scales by 2 and lifts by 10^8 + 0.125, which float32 cannot hold.
    const Loaded loaded =
        import_text("a.gltf", triangle_gltf(R"("nodes":[{"children":[1,2],"translation":[0,100000000.125,0],"scale":[2,2,2]},
        {"mesh":0,"rotation":[0,0,0.70710678118654752,0.70710678118654752]},{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]}],"scenes":[{"nodes":[0]}])"));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->meshes.size(), 1u);
    ASSERT_EQ(loaded.scene->objects.size(), 2u);
    const glm::dvec4 turned = loaded.scene->transforms.at(loaded.scene->objects[0].transform) * glm::dvec4(1, 0, 0, 1);
    EXPECT_NEAR(turned.x, 0, 1e-15);
    EXPECT_NEAR(turned.y, 100000002.125, 1e-7);
    const glm::dvec4 moved = loaded.scene->transforms.at(loaded.scene->objects[1].transform) * glm::dvec4(0, 0, 0, 1);
    EXPECT_EQ(moved, glm::dvec4(10, 100000012.125, 14, 1));
}

TEST(ImportGltf, TurnsMetallicRoughnessIntoBothModels) {
    const Material m = material_of(
        R"({"name":"m","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"metallicFactor":0.5,"roughnessFactor":0.5},"doubleSided":true})");
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m.model, Model::cook_torrance);
    EXPECT_EQ(m.diffuse, glm::vec3(0.25f, 0.125f, 0.5f));
    ASSERT_TRUE(m.f0);
    EXPECT_NEAR(m.f0->x, 0.5 * 0.04 + 0.5 * 0.5, 1e-6);
    EXPECT_NEAR(m.f0->z, 0.5 * 0.04 + 0.5 * 1, 1e-6);
    EXPECT_FLOAT_EQ(m.roughness, 0.25f);
    EXPECT_FLOAT_EQ(m.shininess, 30);
    EXPECT_EQ(m.specular, glm::vec3(1)) << "the color of the highlight is f0";
    EXPECT_EQ(m.two_sided, true);
    EXPECT_EQ(m.opacity, glm::vec3(1));
}

TEST(ImportGltf, ReadsMaterialExtensions) {
    const Material m = material_of(
        R"({"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.5,0.25],"metallicFactor":0},"alphaMode":"BLEND","emissiveFactor":[1,0.5,0],
        "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8},"KHR_materials_ior":{"ior":2},"KHR_materials_transmission":{"transmissionFactor":0.5}}})");
    EXPECT_EQ(m.emission, glm::vec3(8, 4, 0));
    EXPECT_EQ(m.ior, glm::vec3(2));
    EXPECT_NEAR(m.f0->x, 1.0 / 9, 1e-6);
    EXPECT_EQ(m.transmission, glm::vec3(0.5f, 0.25f, 0.25f));
    EXPECT_EQ(m.diffuse, glm::vec3(0.5f, 0.25f, 0.25f));
    EXPECT_EQ(m.opacity, glm::vec3(0.25f));
    EXPECT_TRUE(m.fresnel);
    EXPECT_EQ(m.two_sided, false) << "doubleSided is false where it is absent";
    EXPECT_EQ(material_of(R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25]}})").opacity, glm::vec3(1))
        << "alphaMode is OPAQUE where it is absent";
}

TEST(ImportGltf, ReadsWrapsOfSamplers) {
    const auto wraps = [](const std::string& samplers, const std::string& texture) {
        return import_text("a.gltf",
                           triangle_gltf(std::string(kOneNode) + R"(,"images":[{"uri":"data:image/png;base64,aGVsbG8="}],"textures":[{)" +
                                             texture + R"("source":0}],"samplers":[)" + samplers +
                                             R"(],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])",
                                         R"(,"material":0)"));
    };
    const Loaded both = wraps(R"({"wrapS":33071,"wrapT":33648},{})", R"("sampler":0,)");
    ASSERT_TRUE(both.scene) << all_problems(both);
    EXPECT_EQ(both.scene->materials.at(0).texture->wrap_u, Wrap::clamp);
    EXPECT_EQ(both.scene->materials.at(0).texture->wrap_v, Wrap::mirror);
    for (const char* texture : {R"("sampler":1,)", ""}) {
        const Loaded none = wraps(R"({"wrapS":33071},{"wrapT":10497})", texture);
        ASSERT_TRUE(none.scene) << all_problems(none);
        EXPECT_EQ(none.scene->materials.at(0).texture->wrap_u, Wrap::repeat);
        EXPECT_EQ(none.scene->materials.at(0).texture->wrap_v, Wrap::repeat);
    }
    EXPECT_THAT(all_problems(wraps(R"({"wrapS":1})", R"("sampler":0,)")), HasSubstr("wrapS is 1; it must be 10497"));
    EXPECT_THAT(all_problems(wraps(R"({})", R"("sampler":7,)")), HasSubstr("sampler is 7"));
}

// Positions 0 0 0, 1 0 0, 0 1 0, normals +z, tangents +x with the w given, uv like the positions, of which v grows downwards in the file.
std::string tangent_gltf(float w0, float w1, float w2, const std::string& left_out = "") {
    const std::string bytes = packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + packed<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
                              packed<float>({2, 0, 0, w0, 1, 0, 0, w1, 1, 0, 0, w2}) + packed<float>({0, 0, 1, 0, 0, 1});
    std::string attributes = R"("POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_0":3)";
    if (!left_out.empty()) attributes.replace(attributes.find(left_out), left_out.size(), "_" + left_out);
    return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":144,"uri":"data:application/octet-stream;base64,)" + base64(bytes) +
           R"("}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},{"buffer":0,"byteOffset":72,"byteLength":48},
           {"buffer":0,"byteOffset":120,"byteLength":24}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
           {"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":2,"componentType":5126,"count":3,"type":"VEC4"},
           {"bufferView":3,"componentType":5126,"count":3,"type":"VEC2"}],"meshes":[{"primitives":[{"attributes":{)" +
           attributes + "}}]}]," + kOneNode + "}";
}

TEST(ImportGltf, ReadsTangents) {
    const Loaded loaded = import_text("a.gltf", tangent_gltf(1, -1, 0));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    const Mesh& mesh = loaded.scene->meshes.at(0);
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    EXPECT_EQ(mesh.tangents.at(mesh.corners.at(0)), glm::vec4(1, 0, 0, 1)) << "made unit";
    EXPECT_EQ(mesh.tangents.at(mesh.corners.at(1)), glm::vec4(1, 0, 0, -1));
    EXPECT_EQ(mesh.tangents.at(mesh.corners.at(2)), glm::vec4(0)) << "without handedness there is no way of v";
    EXPECT_EQ(mesh.uvs.at(mesh.corners.at(2)), glm::vec2(0, 0)) << "v is turned: it grows upwards";
    for (const char* left_out : {"TANGENT", "NORMAL", "TEXCOORD_0"}) {
        const Loaded without = import_text("a.gltf", tangent_gltf(1, 1, 1, left_out));
        ASSERT_TRUE(without.scene) << all_problems(without);
        EXPECT_TRUE(without.scene->meshes.at(0).tangents.empty()) << left_out;
    }
}

TEST(ImportGltf, KeepsEmbeddedPicturesEncoded) {
    const Loaded loaded = import_text(
        "a.gltf", triangle_gltf(std::string(kOneNode) + R"(,"images":[{"uri":"data:image/png;base64,aGVsbG8="},{"bufferView":1}],
        "textures":[{"source":0},{"source":1}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"normalTexture":{"index":1}}])",
                                R"(,"material":0)"));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->pictures.size(), 2u);
    EXPECT_EQ(std::string(loaded.scene->pictures[0].encoded.begin(), loaded.scene->pictures[0].encoded.end()), "hello");
    EXPECT_THAT(loaded.scene->pictures[1].encoded, ElementsAre(0, 0, 1, 0, 2, 0));
    const Material& m = loaded.scene->materials.at(0);
    EXPECT_EQ(m.texture->picture, 0u);
    EXPECT_EQ(m.bump->picture, 1u);
    EXPECT_TRUE(m.bump->normal_map);
}

TEST(ImportGltf, ReadsLights) {
    const Loaded loaded =
        import_text("a.gltf", triangle_gltf(R"("nodes":[{"mesh":0},{"translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}}},
        {"rotation":[-0.70710678118654752,0,0,0.70710678118654752],"extensions":{"KHR_lights_punctual":{"light":1}}},{"extensions":{"KHR_lights_punctual":{"light":2}}}],
        "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","color":[1,0.5,0],"intensity":100},{"type":"directional","intensity":3},
        {"type":"spot","spot":{"innerConeAngle":0.3,"outerConeAngle":0.4}}]}},"scenes":[{"nodes":[0,1,2,3]}])"));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->lights.size(), 3u);
    const Light &point = loaded.scene->lights[0], &sun = loaded.scene->lights[1], &spot = loaded.scene->lights[2];
    EXPECT_EQ(point.type, LightType::point);
    EXPECT_EQ(point.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(point.attenuation, Attenuation::inverse_square);
    EXPECT_EQ(point.intensity, glm::vec3(400, 200, 0)) << "at d metres: 4 * 100 / (4 pi d^2), 100 cd are 100 / d^2 lux, irradiance over pi";
    EXPECT_EQ(sun.type, LightType::directional);
    EXPECT_NEAR(sun.direction.y, -1, 1e-15) << "-z, turned by -90 degrees about x";
    EXPECT_NEAR(sun.intensity.x, 3 / std::numbers::pi, 1e-7);
    EXPECT_EQ(spot.type, LightType::spot);
    EXPECT_EQ(spot.direction, glm::dvec3(0, 0, -1));
    EXPECT_DOUBLE_EQ(spot.angle, 0.4);
    EXPECT_DOUBLE_EQ(spot.softness, 0.25);
}

TEST(ImportGltf, ReadsCameras) {
    const Loaded loaded = import_text(
        "a.gltf", triangle_gltf(R"("nodes":[{"mesh":0},{"name":"eye","camera":0,"translation":[0,0,9],"scale":[3,3,3]},{"camera":1}],
        "cameras":[{"type":"perspective","perspective":{"yfov":0.5,"aspectRatio":2,"znear":0.25}},{"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"zfar":2,"znear":1}}],
        "scenes":[{"nodes":[0,1,2]}])"));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->cameras.size(), 1u);
    const Camera& camera = loaded.scene->cameras[0];
    EXPECT_EQ(camera.name, "eye");
    EXPECT_EQ(camera.position, glm::dvec3(0, 0, 9));
    EXPECT_EQ(camera.target, glm::dvec3(0, 0, 8));
    EXPECT_EQ(camera.up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(camera.fov, 0.5);
    EXPECT_EQ(camera.hither, 0.25);
    EXPECT_THAT(all_remarks(loaded), HasSubstr("orthographic"));
}

TEST(ImportGltf, ReadsIntegerAttributesAsTheSpecificationSays) {
    // Normalized 16-bit coordinates 0 and 65535 are 0 and 1, v counted from the top; quantized positions are their integers.
    const std::string bytes =
        packed<std::int16_t>({0, 0, 0, 0, 10, 0, 0, 0, 0, -20, 0, 0}) + packed<std::uint16_t>({0, 0, 65535, 0, 0, 65535});
    const std::string json =
        R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":["KHR_mesh_quantization"],
        "buffers":[{"byteLength":36,"uri":"data:;base64,)" +
        base64(bytes) + R"("}],
        "bufferViews":[{"buffer":0,"byteLength":24,"byteStride":8},{"buffer":0,"byteOffset":24,"byteLength":12}],
        "accessors":[{"bufferView":0,"componentType":5122,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5123,"normalized":true,"count":3,"type":"VEC2"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}],)" +
        kOneNode + "}";
    const Loaded loaded = import_text("a.gltf", json);
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    const Mesh& mesh = loaded.scene->meshes.at(0);
    EXPECT_THAT(corners(mesh, 0), ElementsAre(glm::vec3(0, 0, 0), glm::vec3(10, 0, 0), glm::vec3(0, -20, 0)));
    EXPECT_EQ(mesh.uvs.at(mesh.corners[1]), glm::vec2(1, 1));
    EXPECT_EQ(mesh.uvs.at(mesh.corners[2]), glm::vec2(0, 0));
}

TEST(ImportGltf, MergesPrimitivesOfAMesh) {
    const std::string mesh =
        R"(,"meshes":[{"name":"two","primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0},{"attributes":{"POSITION":0},"indices":1,"material":1},
        {"attributes":{"POSITION":0},"mode":0}]}],"materials":[{"name":"a"},{"name":"b"}],)";
    const Loaded loaded = import_text("a.gltf", R"({"asset":{"version":"2.0"},)" + triangle_parts(triangle_uri()) + mesh + kOneNode + "}");
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->meshes.size(), 1u);
    EXPECT_EQ(loaded.scene->meshes[0].name, "two");
    EXPECT_EQ(loaded.scene->meshes[0].positions.size(), 3u);
    ASSERT_EQ(loaded.scene->meshes[0].face_materials.size(), 2u);
    EXPECT_EQ(loaded.scene->materials.at(loaded.scene->meshes[0].face_materials[1]).name, "b");
    EXPECT_THAT(all_remarks(loaded), HasSubstr("points and lines are not drawn"));
}

struct BadGltf {
    std::string content, problem;
};

class ImportGltfProblem : public testing::TestWithParam<BadGltf> {};

TEST_P(ImportGltfProblem, NamesThePlace) {
    const Loaded loaded = import_text("bad.gltf", GetParam().content);
    EXPECT_FALSE(loaded.scene);
    EXPECT_THAT(all_problems(loaded), HasSubstr(GetParam().problem));
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

INSTANTIATE_TEST_SUITE_P(
    All, ImportGltfProblem,
    testing::Values(
        BadGltf{"{\n\"asset\": {,\n}", "bad.gltf:2: is no valid JSON"}, BadGltf{"[]", "its top is no object"},
        BadGltf{"{}", "has no \"asset\""}, BadGltf{R"({"asset":{"version":"1.0"}})", "is glTF of version \"1.0\""},
        BadGltf{R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"]})",
                "needs the extension KHR_draco_mesh_compression"},
        BadGltf{with(triangle_gltf(kOneNode), "\"byteLength\":36", "\"byteLength\":99"), "bufferViews[0]: bytes 0 to 99 of a buffer of 42"},
        BadGltf{with(triangle_gltf(kOneNode), "\"count\":3", "\"count\":4"), "accessors[0]: its 4 elements end at byte 48 of a view of 36"},
        BadGltf{with(triangle_gltf(kOneNode), "\"count\":3", "\"count\":9007199254740992"), "accessors[0]: count is"},
        BadGltf{with(triangle_gltf(kOneNode), "\"count\":3", "\"count\":-1"), "accessors[0]: count must be a whole number"},
        BadGltf{with(triangle_gltf(kOneNode), "\"POSITION\":0", "\"POSITION\":7"),
                "meshes[0].primitives[0].attributes: POSITION is 7; there are 2"},
        BadGltf{with(triangle_gltf(kOneNode), "\"mesh\":0", "\"mesh\":3"), "nodes[0]: mesh is 3; there are 1"},
        BadGltf{with(triangle_gltf(kOneNode), "\"mesh\":0", "\"mesh\":0,\"children\":[0]"),
                "nodes[0]: is the child of two nodes, or of itself"},
        BadGltf{with(triangle_gltf(kOneNode), "\"mesh\":0", "\"mesh\":0,\"translation\":[0,1e16,0]"), "its transform passes"},
        BadGltf{with(triangle_gltf(kOneNode), "\"mesh\":0", "\"mesh\":0,\"translation\":[0,1,\"2\"]"),
                "nodes[0].translation: must be 3 finite numbers"},
        BadGltf{with(triangle_gltf(kOneNode), "data:application/octet-stream;base64,", "data:;base64,*"), "is no valid base64"},
        BadGltf{with(triangle_gltf(kOneNode), triangle_uri(), "gone.bin"), "the file \"gone.bin\" does not exist"},
        BadGltf{with(triangle_gltf(kOneNode), triangle_uri(), "../../x.bin"), "outside the scene's folder"}));

} // namespace
} // namespace lightbench
