#include "x11.h"

#include <dlfcn.h>

namespace lightbench::viewer {
namespace {

using Window = unsigned long; // of Xlib

constexpr long kSubstructureRedirect = 1L << 20; // Xlib's SubstructureRedirectMask

template <class F> F* function(void* library, const char* name) {
    return reinterpret_cast<F*>(dlsym(library, name));
}

} // namespace

XServer::XServer(const std::string& display) : library_(dlopen("libX11.so.6", RTLD_NOW)) {
    if (library_ != nullptr) display_ = function<void*(const char*)>(library_, "XOpenDisplay")(display.c_str());
}

XServer::~XServer() {
    if (display_ != nullptr) function<int(void*)>(library_, "XCloseDisplay")(display_);
}

void XServer::refuse_windows() {
    const Window root = function<Window(void*)>(library_, "XDefaultRootWindow")(display_);
    function<int(void*, Window, long)>(library_, "XSelectInput")(display_, root, kSubstructureRedirect);
    function<int(void*, int)>(library_, "XSync")(display_, 0);
}

void XServer::set_resources(const std::string& text) {
    constexpr unsigned long resource_manager = 23, string = 31; // atoms that every server has (Xatom.h)
    const Window root = function<Window(void*)>(library_, "XDefaultRootWindow")(display_);
    function<int(void*, Window, unsigned long, unsigned long, int, int, const unsigned char*, int)>(library_, "XChangeProperty")(
        display_, root, resource_manager, string, 8, 0, reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    function<int(void*, int)>(library_, "XSync")(display_, 0);
}

} // namespace lightbench::viewer
