#include "browser.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <poll.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace lightbench {

using nlohmann::json;

namespace {

constexpr int kWaitMs = 30000;

[[noreturn]] void be_chromium(const std::string& program, const std::string& profile, const std::string& size, int in, int out) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::setpgid(0, 0);
    // The pipe's ends are descriptors 3 and 4 by definition; taken aside first, since either may be one of these already.
    const int reads = ::fcntl(in, F_DUPFD, 10), writes = ::fcntl(out, F_DUPFD, 10), null = ::open("/dev/null", O_RDWR);
    ::dup2(reads, 3), ::dup2(writes, 4), ::dup2(null, 0), ::dup2(null, 1), ::dup2(null, 2);
    ::execl(program.c_str(), program.c_str(), "--headless=new", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", profile.c_str(),
            size.c_str(), "--host-resolver-rules=MAP * ~NOTFOUND", "--disable-background-networking", "--no-first-run", "--hide-scrollbars",
            "about:blank", static_cast<const char*>(nullptr));
    ::_exit(127);
}

std::string decoded(const std::string& base64) {
    std::string bytes;
    unsigned word = 0, bits = 0;
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (const char c : base64) {
        const std::size_t value = letters.find(c);
        if (value == std::string::npos) break;
        word = (word << 6 | static_cast<unsigned>(value)) & 0xffffff, bits += 6;
        if (bits >= 8) bits -= 8, bytes += static_cast<char>(word >> bits & 255);
    }
    return bytes;
}

} // namespace

std::string find_chromium() {
    const char* path = std::getenv("PATH");
    std::string rest = path ? path : "";
    for (std::size_t at = 0; at <= rest.size();) {
        const std::size_t end = std::min(rest.find(':', at), rest.size());
        for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
            if (const std::string file = rest.substr(at, end - at) + "/" + name; ::access(file.c_str(), X_OK) == 0) return file;
        at = end + 1;
    }
    return {};
}

Browser::Browser(const std::string& program, unsigned width, unsigned height) {
    std::string folder = (std::filesystem::temp_directory_path() / "lightbench-page-XXXXXX").string();
    if (!::mkdtemp(folder.data())) throw std::runtime_error("no temporary folder");
    profile = folder;
    const std::string profile_option = "--user-data-dir=" + folder, size = fmt::format("--window-size={},{}", width, height);
    int down[2], up[2];
    if (::pipe2(down, O_CLOEXEC) != 0 || ::pipe2(up, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    child = ::fork();
    if (child == 0) be_chromium(program, profile_option, size, down[0], up[1]);
    ::close(down[0]), ::close(up[1]);
    to = down[1], from = up[0];
    const json target = call("Target.createTarget", {{"url", "about:blank"}});
    session = call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}}).at("sessionId");
    for (const char* domain : {"Page", "Runtime", "Log", "Network"}) call(fmt::format("{}.enable", domain), json::object());
    resize(width, height);
}

Browser::~Browser() {
    ::close(to), ::close(from);
    ::kill(-child, SIGKILL);
    while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
    std::error_code ignored;
    std::filesystem::remove_all(profile, ignored);
}

// Messages end with a zero byte.
json Browser::next_message() {
    for (std::size_t end; (end = unread.find('\0')) == std::string::npos;) {
        pollfd waiting{from, POLLIN, 0};
        if (::poll(&waiting, 1, kWaitMs) <= 0) throw std::runtime_error("chromium does not answer");
        char buffer[65536];
        const ssize_t n = ::read(from, buffer, sizeof buffer);
        if (n <= 0) throw std::runtime_error("chromium has ended");
        unread.append(buffer, static_cast<std::size_t>(n));
    }
    const std::size_t end = unread.find('\0');
    const json message = json::parse(unread.substr(0, end));
    unread.erase(0, end + 1);
    return message;
}

void Browser::note(const json& event) {
    const std::string method = event.value("method", "");
    const json parameters = event.value("params", json::object());
    if (method == "Runtime.exceptionThrown" || method == "Log.entryAdded") complaints.push_back(parameters.dump());
    if (method == "Runtime.consoleAPICalled") complaints.push_back(parameters.dump());
    if (method != "Network.requestWillBeSent") return;
    const std::string address = parameters.at("request").at("url");
    if (!address.starts_with("data:")) requests.push_back(address);
}

json Browser::call(const std::string& method, const json& parameters) {
    json message = {{"id", ++last_id}, {"method", method}, {"params", parameters}};
    if (!session.empty()) message["sessionId"] = session;
    const std::string text = message.dump();
    if (::write(to, text.c_str(), text.size() + 1) < 0) throw std::runtime_error("chromium does not listen");
    for (;;) {
        const json answer = next_message();
        if (answer.value("id", 0) != last_id) {
            note(answer);
            continue;
        }
        if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
        return answer.at("result");
    }
}

void Browser::open(const std::filesystem::path& page) {
    call("Page.navigate", {{"url", "file://" + page.string()}});
    if (!becomes_true("document.readyState === 'complete' && location.protocol === 'file:'"))
        throw std::runtime_error("the page does not load");
}

json Browser::evaluate(const std::string& script) {
    const json result = call("Runtime.evaluate", {{"expression", script}, {"returnByValue", true}, {"awaitPromise", true}});
    if (result.contains("exceptionDetails")) throw std::runtime_error(script + ": " + result["exceptionDetails"].dump());
    return result.at("result").value("value", json());
}

bool Browser::becomes_true(const std::string& script) {
    for (int i = 0; i < 100; ++i) {
        if (evaluate(script) == true) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
}

void Browser::mouse(const char* type, double x, double y, bool pressed) {
    call("Input.dispatchMouseEvent", {{"type", type},
                                      {"x", x},
                                      {"y", y},
                                      {"button", pressed ? "left" : "none"},
                                      {"buttons", pressed ? 1 : 0},
                                      {"clickCount", pressed ? 1 : 0}});
}

void Browser::click(double x, double y) {
    mouse("mouseMoved", x, y), mouse("mousePressed", x, y, true), mouse("mouseReleased", x, y, true);
}

void Browser::key(const std::string& name) {
    const json codes = {{"Enter", 13}, {"Escape", 27}, {"Tab", 9}, {"ArrowRight", 39}, {"ArrowLeft", 37}};
    json event = {{"type", "keyDown"}, {"key", name}, {"code", name}, {"windowsVirtualKeyCode", codes.at(name)}};
    if (name == "Enter") event["text"] = "\r";
    call("Input.dispatchKeyEvent", event);
    event["type"] = "keyUp";
    event.erase("text");
    call("Input.dispatchKeyEvent", event);
}

void Browser::resize(unsigned width, unsigned height) {
    call("Emulation.setDeviceMetricsOverride", {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

void Browser::prefer_dark() {
    call("Emulation.setEmulatedMedia", {{"features", {{{"name", "prefers-color-scheme"}, {"value", "dark"}}}}});
}

void Browser::screenshot(const std::filesystem::path& file) {
    std::ofstream(file, std::ios::binary) << decoded(call("Page.captureScreenshot", {{"format", "png"}}).at("data"));
}

} // namespace lightbench
