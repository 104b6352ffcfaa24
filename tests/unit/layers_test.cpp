// The six floors: main > app > measure > render > plan, accel, radiosity > scene; gpu and image stand on the ground and know nothing of the rest but
// shaders/shared, the layouts below them all. No #include runs up or sideways, and what is decided without a GPU (scene, plan, accel)
// never sees Vulkan, however far off.
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace lightbench {
namespace {

namespace fs = std::filesystem;

// Path below src/ ("plan/plan.h"), or "shared/..." for shaders/shared, to its text.
using Sources = std::map<std::string, std::string>;

const std::map<std::string, int> kFloors = {{"main", 6},      {"app", 5},   {"measure", 4}, {"render", 3}, {"plan", 2},   {"accel", 2},
                                            {"radiosity", 2}, {"scene", 1}, {"gpu", 0},     {"image", 0},  {"shared", -1}};
const std::set<std::string> kWithoutVulkan = {"scene", "plan", "accel", "radiosity", "image", "shared"};

std::string room_of(const std::string& path) {
    return path == "main.cpp" ? "main" : path.substr(0, path.find('/'));
}

std::vector<std::string> includes_of(const std::string& text) {
    static const std::regex include(R"((?:^|\n)[ \t]*#[ \t]*include[ \t]*["<]([^">\n]+)[">])");
    std::vector<std::string> names;
    for (std::sregex_iterator at(text.begin(), text.end(), include), end; at != end; ++at) names.push_back((*at)[1]);
    return names;
}

bool is_vulkan(const std::string& include) {
    return include.starts_with("vulkan/") || include.starts_with("vk_");
}

bool reaches_vulkan(const Sources& sources, const std::string& path, std::set<std::string>& seen) {
    const auto source = sources.find(path);
    if (source == sources.end() || !seen.insert(path).second) return false;
    for (const std::string& include : includes_of(source->second))
        if (is_vulkan(include) || reaches_vulkan(sources, include, seen)) return true;
    return false;
}

// One sentence for each arrow that must not be.
std::vector<std::string> violations(const Sources& sources) {
    std::vector<std::string> found;
    for (const auto& [path, text] : sources) {
        const std::string room = room_of(path);
        if (!kFloors.contains(room)) {
            found.push_back(path + ": a room without a floor");
            continue;
        }
        for (const std::string& include : includes_of(text)) {
            const std::string other = room_of(include);
            if (other == room || !kFloors.contains(other) || include.find('/') == std::string::npos) continue;
            if (kFloors.at(other) >= kFloors.at(room)) found.push_back(path + " includes " + include);
        }
        std::set<std::string> seen;
        if (kWithoutVulkan.contains(room) && reaches_vulkan(sources, path, seen)) found.push_back(path + " sees Vulkan");
    }
    return found;
}

void read_below(const fs::path& root, const std::string& prefix, Sources& sources) {
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string extension = entry.path().extension();
        if (extension != ".h" && extension != ".cpp" && extension != ".glsl") continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        sources[prefix + fs::relative(entry.path(), root).generic_string()] = text.str();
    }
}

TEST(Layers, NoArrowRunsUp) {
    Sources sources;
    read_below(fs::path(LIGHTBENCH_SOURCE) / "src", "", sources);
    read_below(fs::path(LIGHTBENCH_SOURCE) / "shaders/shared", "shared/", sources);
    ASSERT_TRUE(sources.contains("main.cpp") && sources.contains("plan/plan.h") && sources.contains("shared/layouts.h"));
    EXPECT_THAT(violations(sources), ::testing::IsEmpty());
}

// The checker itself: each wrong arrow is seen, each right one is let through.
TEST(Layers, WrongIncludesAreFound) {
    const auto verdict = [](const char* path, const char* text) { return violations({{path, text}}); };
    EXPECT_THAT(verdict("scene/a.cpp", "#include \"plan/plan.h\"\n"), ::testing::ElementsAre("scene/a.cpp includes plan/plan.h"));
    EXPECT_THAT(verdict("gpu/a.h", "#pragma once\n  #  include <scene/scene.h>\n"), ::testing::SizeIs(1));
    EXPECT_THAT(verdict("image/a.h", "#include \"gpu/device.h\"\n"), ::testing::SizeIs(1));
    EXPECT_THAT(verdict("image/a.h", "#include \"shared/layouts.h\"\n"), ::testing::IsEmpty());
    EXPECT_THAT(verdict("shared/a.h", "#include \"image/image.h\"\n"), ::testing::SizeIs(1));
    EXPECT_THAT(verdict("accel/a.h", "#include \"plan/plan.h\"\n"), ::testing::SizeIs(1));
    EXPECT_THAT(verdict("shared/a.h", "#include \"scene/scene.h\"\n"), ::testing::SizeIs(1));
    EXPECT_THAT(verdict("plan/a.h", "#include <vulkan/vulkan.hpp>\n"), ::testing::ElementsAre("plan/a.h sees Vulkan"));
    EXPECT_THAT(verdict("stray/a.h", ""), ::testing::ElementsAre("stray/a.h: a room without a floor"));
    EXPECT_THAT(verdict("render/a.h", "#include \"gpu/device.h\"\n#include \"plan/plan.h\"\n#include <vector>\n"), ::testing::IsEmpty());
    EXPECT_THAT(verdict("plan/a.h", "#include \"shared/effects.h\"\n// a note on #include \"app/x.h\"\n"), ::testing::IsEmpty());
}

TEST(Layers, VulkanIsSeenThroughOtherHeaders) {
    const Sources sources = {
        {"scene/a.cpp", "#include \"gpu/b.h\"\n"}, {"gpu/b.h", "#include \"gpu/c.h\"\n"}, {"gpu/c.h", "#include <vk_mem_alloc.h>\n"}};
    EXPECT_THAT(violations(sources), ::testing::ElementsAre("scene/a.cpp sees Vulkan"));
}

} // namespace
} // namespace lightbench
