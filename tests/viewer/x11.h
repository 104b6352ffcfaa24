// The X server past the viewer: what a window manager or a desktop's settings would do. Through Xlib by name, so that no test needs its headers.
#pragma once

#include <string>

namespace lightbench::viewer {

class XServer {
  public:
    explicit XServer(const std::string& display); // ":7"
    XServer(const XServer&) = delete;
    ~XServer();
    bool open() const { return display_ != nullptr; } // false: there is no Xlib
    // From now on windows are mapped by whoever manages them, which is this, and it never does. No other manager may run.
    void refuse_windows();
    // Of the desktop: "Xft.dpi: 192\n".
    void set_resources(const std::string& text);

  private:
    void* library_ = nullptr;
    void* display_ = nullptr;
};

} // namespace lightbench::viewer
