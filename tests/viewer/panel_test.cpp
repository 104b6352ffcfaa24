// The panel's parts under hands that are made up: the interface without window and device.
#include "app/view/interface.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace lightbench::view {
namespace {

// One slider from 0 to 2 in a window of its own.
class Sliders : public testing::Test {
  protected:
    void SetUp() override {
        ImGui::CreateContext();
        style_interface(1);
        ImGui::GetIO().DisplaySize = ImVec2(400, 200);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        ShaderSet set;
        set.sliders = {{"mine.glsl", "a_name_that_is_rather_long_for_a_constant", 0, 2, 0.5f, 1000}};
        live.good = std::make_shared<const ShaderSet>(set);
    }
    void TearDown() override { ImGui::DestroyContext(); }

    void frame(ImVec2 mouse, bool down) {
        ImGuiIO& io = ImGui::GetIO();
        io.DeltaTime = 0.02f, io.MousePos = mouse, io.MouseDown[0] = down;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos(ImVec2(0, 0)), ImGui::SetNextWindowSize(ImVec2(400, 200));
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
        draw_sliders(state, {opened, news, none, none, message, false, "", live, nullptr});
        ImGui::End();
        ImGui::Render();
    }
    // Along the slider, which stands below its name.
    void drag(float from, float to) {
        constexpr float y = 8 + 13 + 4 + 8; // padding, a line of text, spacing, half of it
        for (int i = 0; i < 2; ++i) frame(ImVec2(from, y), false);
        frame(ImVec2(from, y), true);
        for (int i = 0; i < 5; ++i) frame(ImVec2(to, y), true);
        frame(ImVec2(to, y), false);
    }
    State state;
    Opened opened;
    News news;
    LiveNews live;
    Message message;
    std::vector<std::string> none;
};

TEST_F(Sliders, FollowAHand) {
    live.sliders = SliderState::free;
    drag(110, 380);
    ASSERT_TRUE(state.sliders.contains("a_name_that_is_rather_long_for_a_constant"));
    EXPECT_GT(state.sliders.begin()->second, 1.8f);
    drag(380, 12);
    EXPECT_LT(state.sliders.begin()->second, 0.1f);
}

TEST_F(Sliders, StayUntilTheirEndsHaveBeenTried) {
    for (const SliderState held : {SliderState::trying, SliderState::locked}) {
        live.sliders = held;
        drag(110, 380);
        EXPECT_TRUE(state.sliders.empty());
    }
}

} // namespace
} // namespace lightbench::view
