// The viewer driven as a person drives it: a screen, a window manager, keys and mouse through the X server. Validation is on for both devices.
#include "screen.h"

#include "app/view/keys.h"

#include <fstream>
#include <gmock/gmock.h>
#include <random>

namespace lightbench::viewer {
namespace {

namespace fs = std::filesystem;

const std::string kBallAndBox = ball_scene(160, 120, R"([environment]
ambient = [0.1, 0.1, 0.1]
[[object]]
shape = "box"
material = "red"
translate = [1.4, 0, 0]
)",
                                           "texture = { checker = true }\n");

using ::testing::HasSubstr;

class Driven : public Viewer {
  protected:
    std::string scene(const std::string& text = kBallAndBox) const {
        write_text(folder / "scene.toml", text);
        return (folder / "scene.toml").string();
    }
    // The command that `line` of the log ends with, run; the bytes of its picture.
    std::string rendered(std::string line) const {
        line = line.substr(line.find("lightbench render") + std::string("lightbench ").size());
        line = line.substr(0, line.rfind(" -o ")); // the last option
        const fs::path picture = folder / "rendered.png";
        const std::string said = output_of(std::string(LIGHTBENCH_PROGRAM) + " " + line + " -o " + picture.string() + " 2>&1");
        EXPECT_TRUE(fs::exists(picture)) << said;
        return read_text(picture);
    }
    // A screenshot is what the copied command renders; its bytes.
    std::string expect_saved_as_rendered() {
        key("F12");
        const std::string saved = read_text(expect("screenshot "));
        key("ctrl+c");
        EXPECT_TRUE(rendered(expect("copied ")) == saved);
        return saved;
    }
    void expect_clean_end() {
        EXPECT_EQ(quit(), 0);
        EXPECT_EQ(errors().find("validation"), std::string::npos) << errors();
    }
};

TEST_F(Driven, StartsShowsAndSavesWhatRenderRenders) {
    start({}, scene());
    expect("settled");
    const std::string first = expect_saved_as_rendered();
    key("2"), key("l"), key("period"), key("period"); // Gouraud, another law, nine samples
    expect("settled");
    tool("mousemove --window " + window + " 416 60 mousedown 1 sleep 0.3 mousemove_relative 37 21 sleep 0.3 mouseup 1"); // orbit
    expect("settled");
    EXPECT_FALSE(expect_saved_as_rendered() == first);
    expect_clean_end();
}

TEST_F(Driven, RaysFromAnywhereAreTheBytesOfRender) {
    start({"--method", "raytrace"}, scene());
    expect("settled");
    tool("mousemove --window " + window + " 436 60 click 4 click 4"); // nearer
    expect("settled");
    key("w"), key("a");
    expect("settled");
    expect_saved_as_rendered();
    expect_clean_end();
}

TEST_F(Driven, EveryKeyDoesSomethingAndNothingBreaks) {
    start({}, scene());
    expect("settled");
    for (const view::KeyRow& row : view::keys()) {
        if (row.action == view::Action::quit) continue;
        std::string name = row.shortcut;
        for (const auto& [text, tool_name] : std::initializer_list<std::pair<const char*, const char*>>{
                 {"=", "equal"}, {"-", "minus"}, {".", "period"}, {",", "comma"}, {"]", "bracketright"}, {"[", "bracketleft"}})
            if (name == text) name = tool_name;
        if (name == "Ctrl+C") name = "ctrl+c";
        if (name.size() == 1) name[0] = static_cast<char>(std::tolower(name[0]));
        key(name);
        EXPECT_EQ(expect("action ").rfind(std::string(row.help) + ":", 0), 0u) << row.shortcut;
    }
    key("4");
    expect("settled", 50);
    expect_clean_end();
}

TEST_F(Driven, SidesAreWipedAndComparedAndAPixelExplained) {
    start({}, scene());
    expect("settled");
    key("c");
    key("1"); // side B flat
    expect("settled");
    tool("mousemove --window " + window +
         " 446 60 mousedown 1 sleep 0.3 mousemove_relative -- -30 0 sleep 0.3 mouseup 1"); // the line of the wipe
    EXPECT_NEAR(std::stod(expect("wiped ")), 0.5 - 30.0 / 160, 0.05);
    for (const char* map : {"difference", "FLIP", "wipe"}) {
        key("z");
        EXPECT_THAT(expect("action "), HasSubstr(fmt::format(": {}", map)));
    }
    key("c");
    expect("settled");
    tool("mousemove --window " + window + " 441 60 click 1");
    expect("click ");
    EXPECT_GE(std::stoi(expect("answered ")), 1) << "rays";
    key("6");
    expect("settled", 50);
    key("ctrl+c");
    const std::string light = expect("copied ");
    forget();
    tool("mousemove --window " + window + " 441 60 click 1");
    expect("click ");
    expect("settled", 50);
    key("ctrl+c");
    EXPECT_THAT(expect("copied "), HasSubstr("--show form-factors")) << light;
    EXPECT_EQ(log().find("answered", log().rfind("click ")), std::string::npos) << "no ray is traced for a patch";
    expect_clean_end();
}

TEST_F(Driven, AnySizeOfWindowWillDo) {
    start({}, scene());
    expect("settled");
    key("p");
    forget();
    tool("windowsize " + window + " 1 1");
    expect("size 1x1");
    tool("windowsize --sync " + window + " 500 400");
    expect("settled");
    tool("windowminimize --sync " + window);
    expect("minimized");
    tool("windowmap --sync " + window);
    tool("windowactivate --sync " + window);
    expect("restored");
    key("r");
    expect("action ");
    expect_clean_end();
}

TEST_F(Driven, AChangedFileIsReadAgainAndABrokenOneLeavesWhatThereIs) {
    const std::string file = scene();
    start({}, file);
    expect("settled");
    scene("[film]\nwidth = 0\n");
    expect("problem ");
    std::string green = kBallAndBox;
    green.replace(green.find("[0.7, 0.1, 0.1]"), 15, "[0.1, 0.7, 0.1]");
    scene(green);
    expect("opened ");
    expect("settled");
    expect_saved_as_rendered();
    expect_clean_end();
}

TEST_F(Driven, TwoHundredInputsAtRandomEndWithCodeZero) {
    start({}, scene());
    expect("settled");
    std::mt19937 random(7);
    const std::vector<std::string> names = {"1",           "2", "3",     "4",      "5", "m", "l",
                                            "t",           "b", "v",     "o",      "x", "n", "equal",
                                            "minus",       "c", "comma", "period", "z", "g", "bracketright",
                                            "bracketleft", "i", "f",     "r",      "h", "p", "Tab",
                                            "w",           "s"};
    std::string words;
    for (int i = 0; i < 200; ++i) {
        const unsigned kind = random() % 4;
        const std::string at = fmt::format("{} {}", random() % 520, random() % 120);
        if (kind < 2) words += " key " + names[random() % names.size()];
        if (kind == 2) words += " mousemove --window " + window + " " + at + " click " + std::to_string(1 + random() % 5);
        if (kind == 3) words += " mousemove --window " + window + " " + at + " mousedown 1 mousemove_relative 9 5 mouseup 1";
        if (i % 20 == 19) tool(words), words.clear();
    }
    expect_clean_end();
}

} // namespace
} // namespace lightbench::viewer
