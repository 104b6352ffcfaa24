// Headless Chromium, driven over its DevTools protocol: a page is loaded, looked at and used with mouse and keys.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lightbench {

// Of PATH, or empty where there is none.
std::string find_chromium();

// Every wait ends after 30 s with std::runtime_error. All names of hosts resolve to nothing.
class Browser {
  public:
    Browser(const std::string& program, unsigned width, unsigned height);
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;
    ~Browser();

    void open(const std::filesystem::path& page); // until it is loaded
    nlohmann::json evaluate(const std::string& script);
    bool becomes_true(const std::string& script);                           // within 5 s
    void mouse(const char* type, double x, double y, bool pressed = false); // "mouseMoved", "mousePressed", "mouseReleased"
    void click(double x, double y);
    void key(const std::string& name);
    void resize(unsigned width, unsigned height);
    void prefer_dark();
    void screenshot(const std::filesystem::path& file);

    std::vector<std::string> requests;   // addresses other than data: that were asked for
    std::vector<std::string> complaints; // of the console, and uncaught errors

  private:
    nlohmann::json call(const std::string& method, const nlohmann::json& parameters);
    nlohmann::json next_message();
    void note(const nlohmann::json& event);

    std::filesystem::path profile;
    int child = -1, to = -1, from = -1, last_id = 0;
    std::string session, unread;
};

} // namespace lightbench
