#include "app/view/window.h"

#include "gpu/errors.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <dlfcn.h>
#include <fmt/format.h>
#include <utility>

namespace lightbench::view {
namespace {

Input& input_of(GLFWwindow* window) {
    return *static_cast<Input*>(glfwGetWindowUserPointer(window));
}

void on_key(GLFWwindow* window, int key, int, int action, int modifiers) {
    if (action != GLFW_PRESS) return;
    if (const KeyRow* row = find_key(key, modifiers)) input_of(window).pressed.push_back(row);
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
    for (int i = 0; i < count; ++i) input_of(window).dropped.emplace_back(paths[i]);
}

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

// As large as wanted, if the screen is.
glm::ivec2 fitting(glm::ivec2 wanted) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return wanted;
    glm::ivec2 at, area;
    glfwGetMonitorWorkarea(monitor, &at.x, &at.y, &area.x, &area.y);
    return area.x > 0 && area.y > 0 ? glm::min(wanted, area) : wanted;
}

// GLFW 3.3 shows a window under X11 and waits until it is seen; while other events are queued that wait has no end, and a window that its
// manager does not map, or maps on another desktop, is never seen. So it is mapped past GLFW where there is X11. Both libraries are asked for by
// name: GLFW is also built without X11.
void show(GLFWwindow* window) {
    using Display = void* (*)();
    using Number = unsigned long (*)(GLFWwindow*);
    using Map = int (*)(void*, unsigned long);
    const auto find = [](const char* name) { return ::dlsym(RTLD_DEFAULT, name); };
    const auto display = reinterpret_cast<Display>(find("glfwGetX11Display"));
    const auto number = reinterpret_cast<Number>(find("glfwGetX11Window"));
    const auto map = reinterpret_cast<Map>(find("XMapWindow"));
    void* const x = display && number && map ? display() : nullptr; // null: on Wayland
    if (x == nullptr) return glfwShowWindow(window);
    map(x, number(window));
    glfwFocusWindow(window); // only where nobody manages windows; it asks the server, so that the window is mapped by now
}

} // namespace

Window::Window(const std::string& title, glm::uvec2 picture, unsigned panel) {
    if (!glfwInit()) throw gpu::EnvironmentError(fmt::format("no window can be opened: {}", last_error()));
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    const glm::ivec2 size = fitting(glm::ivec2(picture) + glm::ivec2(panel, 0));
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        const std::string reason = last_error();
        glfwTerminate();
        throw gpu::EnvironmentError(fmt::format("no window can be opened: {}", reason));
    }
    glfwSetWindowUserPointer(window_, &input_);
    glfwSetKeyCallback(window_, on_key);
    glfwSetDropCallback(window_, on_drop);
    show(window_);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

Input Window::wait(double seconds) {
    seconds > 0 ? glfwWaitEventsTimeout(seconds) : glfwPollEvents();
    return std::exchange(input_, {});
}

bool Window::held(Action action) const {
    const bool modified =
        glfwGetKey(window_, GLFW_KEY_LEFT_CONTROL) == GLFW_PRESS || glfwGetKey(window_, GLFW_KEY_RIGHT_CONTROL) == GLFW_PRESS;
    return !modified && glfwGetKey(window_, row_of(action).key) == GLFW_PRESS;
}

bool Window::closing() const {
    return glfwWindowShouldClose(window_);
}

glm::ivec2 Window::framebuffer() const {
    glm::ivec2 size;
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) ? glm::ivec2(0) : size;
}

float Window::scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(std::max(x, y), 1.0f, 4.0f);
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::hide() {
    glfwHideWindow(window_);
    glfwPollEvents();
}

void Window::wake() {
    glfwPostEmptyEvent();
}

} // namespace lightbench::view
