// The parts below the import that files reach only by accident: the wire between the processes, and the child's limits.
#include "scene/import_child.h"
#include "scene/import_text.h"
#include "scene/import_wire.h"
#include "unit/import_support.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <new>

namespace lightbench {
namespace {

using namespace importer;
using testing::HasSubstr;

Imported everything() {
    Imported all;
    Scene& s = all.scene;
    s.name = "all", s.film = glm::uvec2(3, 4), s.remarks = {"one", "two"};
    s.cameras.resize(1), s.cameras[0].name = "eye", s.cameras[0].hither = 2;
    s.lights.resize(2), s.lights[1].type = LightType::spot, s.lights[1].softness = 0.75;
    s.materials.resize(2), s.materials[1].name = "m", s.materials[1].f0 = glm::vec3(0.25f), s.materials[1].two_sided = true;
    s.materials[1].texture = Texture{0u, Mapping::planar, {2, 3}, Wrap::clamp, Wrap::mirror}, s.materials[1].bump = Bump{};
    s.transforms.push_back(glm::dmat4(2));
    s.pictures = {{"a.png", {1, 2, 3}}};
    s.meshes = {{"mesh", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {}, {}, {0, 1, 2}, {0, 3}, {1}}};
    s.meshes[0].tangents.assign(3, {1, 0, 0, -1});
    s.objects = {{MeshUse{0}, 1, 1, 0.5f, 2}};
    all.report.problem_at(7, "text");
    return all;
}

std::string sent(Imported imported) {
    const ChildOutput output = run_in_child(allowance_for(0), [&](int out) { write_imported(out, imported); });
    return std::string(text_of(output.bytes()));
}

TEST(ImportWire, BringsEverythingOver) {
    const Imported before = everything();
    const auto after = read_imported(bytes_of(sent(before)));
    ASSERT_TRUE(after);
    const Scene &a = before.scene, &b = after->scene;
    EXPECT_EQ(b.name, "all");
    EXPECT_EQ(b.film, a.film);
    EXPECT_EQ(b.remarks, a.remarks);
    EXPECT_EQ(b.cameras.at(0).name, "eye");
    EXPECT_EQ(b.cameras.at(0).hither, 2);
    EXPECT_EQ(b.lights.at(1).type, LightType::spot);
    EXPECT_EQ(b.lights.at(1).softness, 0.75);
    EXPECT_EQ(b.materials, a.materials);
    EXPECT_EQ(b.transforms, a.transforms);
    EXPECT_EQ(b.pictures, a.pictures);
    EXPECT_EQ(b.meshes.at(0).positions, a.meshes[0].positions);
    EXPECT_EQ(b.meshes.at(0).normals, a.meshes[0].normals);
    EXPECT_EQ(b.meshes.at(0).tangents, a.meshes[0].tangents);
    EXPECT_EQ(b.meshes.at(0).corners, a.meshes[0].corners);
    EXPECT_EQ(b.meshes.at(0).face_materials, a.meshes[0].face_materials);
    EXPECT_EQ(std::get<MeshUse>(b.objects.at(0).shape).mesh, 0u);
    EXPECT_EQ(b.objects.at(0).subdivide, 2);
    EXPECT_EQ(after->report.log.kept.at(0).line, 7u);
}

TEST(ImportWire, TakesNothingElse) {
    const std::string whole = sent(everything());
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(read_imported(bytes_of(std::string_view(whole).substr(0, size)))) << size;
    EXPECT_FALSE(read_imported(bytes_of(whole + '\0')));
}

// Whatever a broken child sends, the parent neither crashes nor follows an index that leads outside.
TEST(ImportWire, SurvivesFlippedBytes) {
    const std::string whole = sent(everything());
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const int flip : {0x01, 0x80, 0xFF}) {
            std::string broken = whole;
            broken[at] = static_cast<char>(broken[at] ^ flip);
            const auto read = read_imported(bytes_of(broken));
            if (!read) continue;
            for (const Mesh& mesh : read->scene.meshes)
                for (const std::uint32_t corner : mesh.corners) ASSERT_LT(corner, mesh.positions.size());
            for (const Object& object : read->scene.objects) ASSERT_LT(object.material, read->scene.materials.size());
        }
}

TEST(ImportChild, TellsWhyItEnded) {
    volatile int zero = 0;
    volatile int* nowhere = nullptr;
    const Allowance tight{64 << 20, 0.2, 2};
    EXPECT_THAT(*run_in_child(tight, [&](int) { *nowhere = 1; }).failure(), HasSubstr("makes the reader fail"));
    EXPECT_THAT(*run_in_child(tight, [&](int) { std::abort(); }).failure(), HasSubstr("makes the reader fail"));
    EXPECT_THAT(*run_in_child(tight, [&](int) { throw std::bad_alloc(); }).failure(), HasSubstr("more memory"));
    EXPECT_THAT(*run_in_child(tight,
                              [&](int) {
                                  while (zero == 0) {
                                  }
                              })
                     .failure(),
                HasSubstr("processor time"));
    EXPECT_THAT(*run_in_child({64 << 20, 5, 0.2}, [&](int) { ::pause(); }).failure(), HasSubstr("time allowed"));
    EXPECT_FALSE(run_in_child(tight, [](int out) { EXPECT_EQ(::write(out, "x", 1), 1); }).failure());
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(ImportChild, HoldsTheMemoryLimit) {
    const auto result = run_in_child({64 << 20, 5, 5}, [](int) {
        std::vector<std::string> all;
        while (true) all.emplace_back(1 << 20, 'x');
    });
    EXPECT_THAT(*result.failure(), HasSubstr("more memory"));
}
#endif

TEST(ImportText, ReadsNumbersOfTextFilesOnly) {
    EXPECT_EQ(parse_number("1.5e1"), 15.0);
    EXPECT_EQ(parse_number("+2."), 2.0);
    EXPECT_EQ(parse_number("-1e-999"), 0.0);
    EXPECT_EQ(parse_number("-1e999"), -std::numeric_limits<double>::infinity());
    for (const char* bad : {"", "+", "+-1", "1,5", "0x10", "1e", "1f", "1 ", "--1"}) EXPECT_FALSE(parse_number(bad)) << bad;
}

TEST(ImportText, MakesNamesValid) {
    EXPECT_EQ(clean_name("a b\xC3\xA4"), "a b\xC3\xA4");
    EXPECT_EQ(clean_name("a\xFF\nb\xC3"), "a??b?");
}

} // namespace
} // namespace lightbench
