// Scene files made to exhaust, to crash or to reach what is not theirs: each is refused with a reason, within a second and 256 MiB.
#include "hostile/scene_child.h"
#include "unit/load_fixtures.h"

#include <clocale>
#include <ctime>
#include <gmock/gmock.h>
#include <locale>
#include <sys/stat.h>

namespace lightbench::hostile {
namespace {

using testing_files::Folder;
namespace fs = std::filesystem;

std::string repeat(std::string_view part, std::size_t times) {
    std::string text;
    text.reserve(part.size() * times);
    while (times-- > 0) text += part;
    return text;
}

struct Text {
    const char* what;
    std::string text;
    const char* reason;
};

void expect_all_refused(const char* name, const std::vector<Text>& texts) {
    const Folder folder;
    for (const Text& t : texts) {
        SCOPED_TRACE(t.what);
        expect_refused(load_in_child(folder.write(name, t.text)), t.reason);
    }
}

// The bounds themselves are tested: a load that takes too long or too much is told from one that does not.
TEST(HostileScene, TheMeasureMeasures) {
    const auto spin = load_in_child([] {
        const std::clock_t end = std::clock() + CLOCKS_PER_SEC / 5;
        while (std::clock() < end) {
        }
        return Loaded{};
    });
    EXPECT_TRUE(spin.ended);
    EXPECT_GT(spin.cpu_seconds, 0.19);
    const auto fill = load_in_child([] {
        const std::string memory(std::size_t{100} << 20, 'x');
        return Loaded{std::nullopt, {{memory.substr(0, 3), 0, 0, "y"}}, 0};
    });
    EXPECT_GT(fill.megabytes, 99);
    EXPECT_EQ(fill.report, "xxx: y\n");
    EXPECT_FALSE(load_in_child([]() -> Loaded { std::abort(); }).ended);
}

TEST(HostileScene, NestingInToml) {
    expect_all_refused("a.toml",
                       {
                           {"arrays", "a = " + repeat("[", 1000000), "kMaxNesting"},
                           {"closed arrays", "a = " + repeat("[", 1000000) + repeat("]", 1000000), "kMaxNesting"},
                           {"tables", "a = " + repeat("{a=", 1000000), "kMaxNesting"},
                           {"a dotted key", repeat("a.", 1000000) + "a = 1", "kMaxNesting"},
                           {"a dotted header", "[" + repeat("a.", 1000000) + "a]", "kMaxNesting"},
                           {"a quoted dotted key", repeat("\"a\".", 1000000) + "a = 1", "kMaxNesting"},
                           {"a literal dotted key", repeat("'\"'.", 1000000) + "a = 1", "kMaxNesting"},
                           {"behind a string that ends in quotes", "b = \"\"\"x\"\"\"\"\"\na = " + repeat("[", 1000000), "kMaxNesting"},
                           {"behind an escaped quote", "b = \"\\\"\"\na = " + repeat("[", 1000000), "kMaxNesting"},
                           {"behind a comment with a quote", "# \" \n a = " + repeat("[", 1000000), "kMaxNesting"},
                           {"nested objects", repeat("[[object]]\nobject = ", 1000) + "1", "not valid TOML"},
                       });
}

TEST(HostileScene, FloodsInToml) {
    expect_all_refused("a.toml", {
                                     {"a text of 20 MB", "a = \"" + std::string(20u << 20, 'x') + "\"", "kMaxStringBytes"},
                                     {"a text without end", "a = '''" + std::string(20u << 20, 'x'), "kMaxStringBytes"},
                                     {"a file of 100 MB in one line", std::string(100u << 20, 'x'), "kMaxTomlBytes"},
                                     {"nine million values", "a = [" + repeat("1,", 9000000) + "]", "kMaxTomlValues"},
                                     {"a bare key of 1 MB", std::string(1u << 20, 'k') + " = 1", "unknown key"},
                                     {"20 000 unknown keys",
                                      [] {
                                          std::string text;
                                          for (int i = 0; i < 20000; ++i) text += fmt::format("key{} = 1\n", i);
                                          return text;
                                      }(),
                                      "and 19900 more problems"},
                                     {"a polygon of 70 000 points",
                                      "[[object]]\nshape = \"polygon\"\npoints = [" + repeat("[0,0,0],", 70000) + "]", "kMaxPolygonPoints"},
                                 });
}

TEST(HostileScene, BytesThatAreNotText) {
    expect_all_refused("a.toml", {
                                     {"NUL", std::string("a = 1\n\0b = 2", 12), "2:1: a NUL byte"},
                                     {"NUL in a text", std::string("a = \"\0\"", 7), "not valid TOML"},
                                     {"invalid UTF-8", "a = \"\xff\xfe\"", "not valid TOML"},
                                     {"UTF-16",
                                      std::string("\xff\xfe"
                                                  "a\0=\0001\0",
                                                  8),
                                      "a.toml:1:"},
                                     {"a program",
                                      std::string("\x7f"
                                                  "ELF\2\1\1\0",
                                                  8),
                                      "a.toml:1:"},
                                 });
    expect_all_refused("a.nff",
                       {
                           {"NUL", std::string("s 0 0 0 1\n\0\n", 12), "2:1: unknown statement \"\\x00\""},
                           {"a program",
                            std::string("\x7f"
                                        "ELF\2\1\1\0",
                                        8),
                            "unknown statement"},
                           {"a line of 100 MB", std::string(100u << 20, 'x'), "unknown statement"},
                           {"a comment of 100 MB, then nonsense", "#" + std::string(100u << 20, 'x') + "\nfoo", "2:1: unknown statement"},
                           {"a number of 50 MB", "s 0 0 0 " + std::string(50u << 20, '9'), "not a finite number"},
                           {"five million wrong lines", repeat("x\n", 5000000), "and 4999900 more problems"},
                       });
}

TEST(HostileScene, CountsAndNumbers) {
    std::vector<Text> toml, nff;
    for (const char* bad : {"nan", "inf", "-inf", "1e39", "1e400", "-1", "1e-46", "9223372036854775808", "0x1p3", "1,5", "\"1\"", "[1]",
                            "1_", "٣", "1e", "+-1", "--1"})
        toml.push_back({bad, fmt::format("[[material]]\nname = \"m\"\nroughness = {}\n", bad), ":3:"});
    for (const char* bad :
         {"nan", "inf", "-inf", "1e39", "1e400", "-1", "0x1p3", "1,5", "\"1\"", "1_", "1e", "+-1", "--1", "-", ".", "e5", "٣"})
        nff.push_back({bad, fmt::format("s 0 0 0\n{}\n", bad), ":2:1: s: "});
    for (const char* bad :
         {"2147483648", "9223372036854775808", "18446744073709551616", "-1", "0", "1e300", "nan", "65537", "-9223372036854775808"})
        nff.push_back({bad, fmt::format("p {}\n0 0 0\n", bad), "kMaxPolygonPoints"});
    expect_all_refused("a.toml", toml);
    expect_all_refused("a.nff", nff);
}

struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    std::string do_grouping() const override { return "\3"; }
    char do_thousands_sep() const override { return '.'; }
};

// A decimal comma of the user's locale changes nothing: "1.5" is one and a half, in and out. The locale of C++ streams is made here; that of
// the C library is set too where one with a comma is installed.
TEST(HostileScene, TheLocaleDoesNotMatter) {
    const Folder folder;
    const auto toml = folder.write("a.toml", "[[object]]\nshape = \"sphere\"\nradius = 1234.5\n"),
               nff = folder.write("a.nff", "s 0 0 0 1234.5\n");
    const auto wrong = folder.write("b.toml", "[[object]]\nshape = \"sphere\"\nradius = -1234.5\n");
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8", "ru_RU.UTF-8"})
        if (std::setlocale(LC_ALL, name)) break;
    const Loaded from_toml = load_scene(toml), from_nff = load_scene(nff), refused = load_scene(wrong);
    std::locale::global(before);
    std::setlocale(LC_ALL, "C");
    for (const Loaded* loaded : {&from_toml, &from_nff}) {
        ASSERT_TRUE(loaded->scene);
        EXPECT_EQ(std::get<Sphere>(loaded->scene->objects.at(0).shape).radius, 1234.5);
    }
    ASSERT_EQ(refused.problems.size(), 1u);
    EXPECT_THAT(refused.problems[0].text, testing::HasSubstr("radius is -1234.5;"));
}

TEST(HostileScene, ThingsThatAreNoFiles) {
    const Folder folder;
    for (const char* extension : {"toml", "nff"}) {
        const auto name = [&](const char* stem) { return folder.path() / fmt::format("{}.{}", stem, extension); };
        fs::create_directory(name("folder"));
        ASSERT_EQ(::mkfifo(name("pipe").c_str(), 0600), 0);
        fs::create_symlink("/dev/zero", name("zero"));
        fs::create_symlink("/dev/random", name("random"));
        fs::create_symlink("/dev/tty", name("tty"));
        fs::create_symlink(name("round"), name("round"));
        expect_refused(load_in_child(name("folder")), "it is a directory");
        expect_refused(load_in_child(name("pipe")), "it is a pipe");
        expect_refused(load_in_child(name("zero")), "it is a device");
        expect_refused(load_in_child(name("random")), "it is a device");
        expect_refused(load_in_child(name("tty")), name("tty").string() + ": ");
        expect_refused(load_in_child(name("round")), "symbolic links");
        expect_refused(load_in_child(name("none")), "there is no such file");
    }
}

// What a scene names is held to the same rule as the scene itself.
TEST(HostileScene, NamedFilesThatAreNoFilesOrLieOutside) {
    const Folder folder;
    folder.write("secret.png", "x");
    const fs::path inside = folder.path() / "scene";
    fs::create_directories(inside / "folder.png");
    ASSERT_EQ(::mkfifo((inside / "pipe.png").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", inside / "zero.png");
    fs::create_symlink("../secret.png", inside / "link.png");
    const struct {
        const char *name, *reason;
    } cases[] = {{"folder.png", "it is a directory"},
                 {"pipe.png", "it is a pipe"},
                 {"zero.png", "outside the scene's folder"},
                 {"link.png", "outside the scene's folder"},
                 {"../secret.png", "outside the scene's folder"},
                 {"/etc/passwd", "outside the scene's folder"},
                 {"a\\u0000b", "NUL"}};
    for (const auto& c : cases) {
        SCOPED_TRACE(c.name);
        for (const char* use :
             {"[environment]\nmap = \"{}\"\n", "[[object]]\nshape = \"mesh\"\nfile = \"{}\"\n",
              "[[material]]\nname = \"m\"\ntexture = {{file = \"{}\"}}\n", "[[material]]\nname = \"m\"\nbump = {{file = \"{}\"}}\n"})
            expect_refused(load_in_child(folder.write("scene/room.toml", fmt::format(fmt::runtime(use), c.name))), c.reason);
    }
}

// A scene that places itself, or a file that does, cannot go round: only formats without references of that kind can be placed.
TEST(HostileScene, SelfReference) {
    const Folder folder;
    expect_refused(load_in_child(folder.write("a.toml", "[[object]]\nshape = \"mesh\"\nfile = \"a.toml\"\n")), "cannot be placed");
}

} // namespace
} // namespace lightbench::hostile
