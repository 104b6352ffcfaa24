// Files that mean harm: cut at every byte, bytes changed, claims far beyond their size. Each is refused or read, never a crash of this
// process, and a refusal is quick and small.
#include "unit/import_support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <random>
#include <sys/resource.h>
#include <sys/stat.h>

namespace lightbench {
namespace {

using namespace importer_test;
using testing::HasSubstr;

const std::string kObj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl a\nf 1/1/1 2/1/1 3/1/1\n";
const std::string kPly =
    "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n" +
    packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + "\3" + packed<std::int32_t>({0, 1, 2});
const std::string kStl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
const std::string kGltf = triangle_gltf(
    R"("nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"materials":[{"pbrMetallicRoughness":{"metallicFactor":1}}])", R"(,"material":0)");

struct Seed {
    std::string name;
    const std::string* content;
};

class ImportSeed : public testing::TestWithParam<Seed> {};

void expect_an_answer(const Loaded& loaded) {
    EXPECT_NE(loaded.scene.has_value(), !loaded.problems.empty()) << all_problems(loaded);
}

TEST_P(ImportSeed, CutAnywhere) {
    const Folder folder;
    const std::string& whole = *GetParam().content;
    EXPECT_TRUE(import_file(folder.write(GetParam().name, whole)).scene);
    const std::size_t step = std::max<std::size_t>(1, whole.size() / 150);
    for (std::size_t size = 0; size < whole.size(); size += step)
        expect_an_answer(import_file(folder.write(GetParam().name, whole.substr(0, size))));
}

TEST_P(ImportSeed, ChangedAnywhere) {
    const Folder folder;
    std::mt19937 random(7);
    for (int round = 0; round < 100; ++round) {
        std::string broken = *GetParam().content;
        for (int change = 0; change < 3; ++change)
            broken[random() % broken.size()] = round % 2 ? static_cast<char>(random()) : "0-9e/,{}[]\" \n"[random() % 13];
        expect_an_answer(import_file(folder.write(GetParam().name, broken)));
    }
}

INSTANTIATE_TEST_SUITE_P(All, ImportSeed,
                         testing::Values(Seed{"a.obj", &kObj}, Seed{"a.ply", &kPly}, Seed{"a.stl", &kStl}, Seed{"a.gltf", &kGltf}),
                         [](const auto& tested) { return tested.param.name.substr(2); });

struct Claim {
    std::string name, content;
};

class ImportClaim : public testing::TestWithParam<Claim> {};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// The child's processor time and memory: this process is shared with other work, so that the wall clock would measure that.
TEST_P(ImportClaim, IsRefusedQuicklyAndSmall) {
    const Folder folder;
    const auto file = folder.write(GetParam().name, GetParam().content);
    rusage before{}, after{};
    getrusage(RUSAGE_CHILDREN, &before);
    const Loaded loaded = import_file(file);
    getrusage(RUSAGE_CHILDREN, &after);
    EXPECT_FALSE(loaded.scene);
    EXPECT_THAT(all_problems(loaded), HasSubstr(file.string()));
    const double spent = static_cast<double>(after.ru_utime.tv_sec - before.ru_utime.tv_sec) +
                         1e-6 * static_cast<double>(after.ru_utime.tv_usec - before.ru_utime.tv_usec);
#if !defined(__SANITIZE_ADDRESS__)
    EXPECT_LT(spent, 1.0);
    EXPECT_LT(after.ru_maxrss, 256 * 1024) << "KiB";
#else
    EXPECT_LT(spent, 10.0);
#endif
}

std::string nested(int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += '[';
    return text;
}

INSTANTIATE_TEST_SUITE_P(All, ImportClaim,
                         testing::Values(Claim{"a.ply", replaced(kPly, "vertex 3", "vertex 2147483648")},
                                         Claim{"a.ply", replaced(kPly, "vertex 3", "vertex 9223372036854775808")},
                                         Claim{"a.ply", replaced(kPly, "face 1", "face 4294967295")},
                                         Claim{"a.ply", "ply\nformat ascii 1.0\nelement vertex 4294967295\nend_header\n"},
                                         Claim{"a.stl", std::string(80, 'x') + packed<std::uint32_t>({0xFFFFFFFF})},
                                         Claim{"a.gltf", replaced(kGltf, "\"count\":3", "\"count\":1000000000")},
                                         Claim{"a.gltf", replaced(kGltf, "\"bufferView\":0,\"componentType\":5126,\"count\":3",
                                                                  "\"componentType\":5126,\"count\":1000000000")},
                                         Claim{"a.gltf", nested(500000)},
                                         Claim{"a.gltf", replaced(kGltf, "\"mesh\":0", "\"mesh\":0,\"children\":" + nested(100000))},
                                         Claim{"a.obj", "v 0 0 0\nf 1 1 9223372036854775807\n"},
                                         Claim{"a.obj", std::string("v 0 0 0\0\n", 9)},
                                         Claim{"a.obj", "\x7F"
                                                        "ELF\2\1\1"},
                                         Claim{"a.glb", "glTF" + packed<std::uint32_t>({2, 20, 0xFFFFFFF0, 0x4E4F534A})}));

TEST(ImportHostile, OpensRegularFilesOnly) {
    const Folder folder;
    ASSERT_EQ(mkfifo((folder.path / "pipe.obj").c_str(), 0600), 0);
    std::filesystem::create_directory(folder.path / "folder.ply");
    std::filesystem::create_symlink("/dev/zero", folder.path / "zero.stl");
    std::filesystem::create_symlink("loop.glb", folder.path / "loop.glb");
    for (const char* name : {"pipe.obj", "folder.ply", "zero.stl", "loop.glb", "gone.gltf"})
        EXPECT_THAT(all_problems(import_file(folder.path / name)), HasSubstr(name)) << name;
    ASSERT_EQ(mkfifo((folder.path / "m.mtl").c_str(), 0600), 0);
    expect_an_answer(import_file(folder.write("a.obj", kObj)));
}

TEST(ImportHostile, LinesWithoutEndAndNamesWithoutEnd) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    expect_an_answer(import_text("a.obj", triangle + "usemtl " + std::string(5000, 'x') + "\nf 1 2 3\n"));
    expect_an_answer(import_text("a.obj", triangle + "f 1 2 3" + std::string(4 << 20, ' ')));
    expect_an_answer(import_text("a.obj", triangle + "f" + std::string(1 << 20, '1') + "\nf 1 2 3\n"));
    std::string wide = triangle + "f";
    for (int i = 0; i < 70000; ++i) wide += " 1";
    EXPECT_THAT(all_problems(import_text("a.obj", wide + "\n")), HasSubstr("f has 70000 corners; the limit is 65536"));
    expect_an_answer(import_text("a.obj", triangle + "f 1 2 3 \\"));
}

// A deep chain of nodes is refused by its depth; a long one that shares a mesh is read.
TEST(ImportHostile, ManyNodes) {
    std::string chain = "\"nodes\":[", wide = "\"nodes\":[";
    for (int i = 0; i < 1000; ++i) {
        chain += fmt::format(R"({}{{"mesh":0,"children":[{}]}})", i ? "," : "", i + 1);
        wide += std::string(i ? "," : "") + R"({"mesh":0})";
    }
    EXPECT_THAT(all_problems(import_text("a.gltf", triangle_gltf(chain + R"(,{"mesh":0}],"scenes":[{"nodes":[0]}])"))),
                HasSubstr("lies deeper than 64 nodes"));
    const Loaded loaded = import_text("a.gltf", triangle_gltf(wide + "]"));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    EXPECT_EQ(loaded.scene->objects.size(), 1000u);
    EXPECT_EQ(loaded.scene->meshes.size(), 1u);
}

// A grid of a million triangles: a file as users have them, within 2 GiB for the child and this process together.
TEST(ImportHostile, AMillionTriangles) {
    constexpr std::uint32_t kSide = 708; // 707 * 707 * 2 = 999 698
    std::string file = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n",
        kSide * kSide, 2 * (kSide - 1) * (kSide - 1));
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x) file += packed<float>({static_cast<float>(x), static_cast<float>(y), 0});
    for (std::uint32_t y = 0; y + 1 < kSide; ++y)
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const std::uint32_t i = y * kSide + x;
            file += "\3" + packed<std::uint32_t>({i, i + 1, i + kSide}) + "\3" + packed<std::uint32_t>({i + 1, i + kSide + 1, i + kSide});
        }
    const Loaded loaded = import_text("a.ply", file);
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    EXPECT_EQ(loaded.scene->meshes.at(0).face_count(), 999698u);
    EXPECT_EQ(loaded.scene->meshes.at(0).positions.size(), kSide * kSide);
    rusage child{};
    getrusage(RUSAGE_CHILDREN, &child);
    EXPECT_LT(child.ru_maxrss, 1 << 20) << "KiB";
}

} // namespace
} // namespace lightbench
