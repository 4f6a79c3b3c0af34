#include "app/desktop/window.h"

#define GLFW_INCLUDE_NONE
#include <vulkan/vulkan_core.h>
// After Vulkan's header, so that GLFW declares its surface functions.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/error.h"
#ifdef __APPLE__
#include "app/apple/mac/opened_files.h"
#endif

namespace nacre::app {
namespace {

std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "GLFW gives no reason";
}

WindowEvents& windowEvents(GLFWwindow* window) { return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window)); }

glm::dvec2 inPixels(GLFWwindow* window, double x, double y) {
    int width = 1, height = 1, pixelWidth = 1, pixelHeight = 1;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixelWidth, &pixelHeight);
    return {x * pixelWidth / std::max(width, 1), y * pixelHeight / std::max(height, 1)};
}

std::optional<SpecialKey> specialKey(int key) {
    switch (key) {
        case GLFW_KEY_LEFT:
            return SpecialKey::left;
        case GLFW_KEY_RIGHT:
            return SpecialKey::right;
        case GLFW_KEY_UP:
            return SpecialKey::up;
        case GLFW_KEY_DOWN:
            return SpecialKey::down;
        case GLFW_KEY_HOME:
            return SpecialKey::home;
        case GLFW_KEY_ESCAPE:
            return SpecialKey::escape;
        case GLFW_KEY_BACKSPACE:
            return SpecialKey::backspace;
        case GLFW_KEY_ENTER:
            return SpecialKey::enter;
        case GLFW_KEY_KP_ENTER:
            return SpecialKey::enter;
        case GLFW_KEY_TAB:
            return SpecialKey::tab;
        case GLFW_KEY_DELETE:
            return SpecialKey::remove;
        case GLFW_KEY_END:
            return SpecialKey::end;
        case GLFW_KEY_PAGE_UP:
            return SpecialKey::pageUp;
        case GLFW_KEY_PAGE_DOWN:
            return SpecialKey::pageDown;
        case GLFW_KEY_F1:
            return SpecialKey::f1;
        case GLFW_KEY_F11:
            return SpecialKey::f11;
        case GLFW_KEY_F12:
            return SpecialKey::f12;
        default:
            return std::nullopt;
    }
}

}  // namespace

Window::Window(PixelSize size, WindowEvents events) : events_(std::move(events)) {
#ifdef __APPLE__
    listenForOpenedFiles(wake);
    glfwInitHint(GLFW_COCOA_CHDIR_RESOURCES, GLFW_FALSE);
#endif
    if (!glfwInit()) throw Error("cannot open a window", "", lastError());
    if (!glfwVulkanSupported()) {
        glfwTerminate();
        throw Error("cannot open a window", "", "there is no Vulkan for this window system");
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "nacre");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "nacre");
    window_ = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height), "Nacre", nullptr, nullptr);
    if (!window_) {
        const std::string why = lastError();
        glfwTerminate();
        throw Error("cannot open a window", "", why);
    }
    connect();
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::connect() {
    glfwSetWindowUserPointer(window_, &events_);
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { windowEvents(w).resized(); });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { windowEvents(w).resized(); });
    glfwSetWindowIconifyCallback(window_,
                                 [](GLFWwindow* w, int iconified) { windowEvents(w).iconified(iconified != 0); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { windowEvents(w).damaged(); });
    glfwSetCursorPosCallback(window_,
                             [](GLFWwindow* w, double x, double y) { windowEvents(w).pointer(inPixels(w, x, y)); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
        // The position of the last event: the current one may already differ.
        if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
        const MouseButton which = button == GLFW_MOUSE_BUTTON_LEFT    ? MouseButton::left
                                  : button == GLFW_MOUSE_BUTTON_RIGHT ? MouseButton::right
                                                                      : MouseButton::middle;
        windowEvents(w).button(which, action == GLFW_PRESS,
                               {(mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) {
        const auto held = [w](int key) { return glfwGetKey(w, key) == GLFW_PRESS; };
        windowEvents(w).wheel(y, {held(GLFW_KEY_LEFT_SHIFT) || held(GLFW_KEY_RIGHT_SHIFT),
                                  held(GLFW_KEY_LEFT_CONTROL) || held(GLFW_KEY_RIGHT_CONTROL)});
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        const Modifiers with{(mods & GLFW_MOD_SHIFT) != 0, (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0};
        const std::optional<SpecialKey> special = specialKey(key);
        if (!special) {
            // With Ctrl there is no character: takes the layout's letter.
            const char* name = with.control && action != GLFW_RELEASE ? glfwGetKeyName(key, scancode) : nullptr;
            if (name && name[0] != '\0' && name[1] == '\0')
                windowEvents(w).shortcut(
                    {static_cast<char32_t>(std::tolower(static_cast<unsigned char>(name[0]))), with});
            return;
        }
        windowEvents(w).special(*special, action != GLFW_RELEASE, action == GLFW_REPEAT, with);
    });
    // Characters as typed: '+' and '?' are on different keys in every layout.
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned int c) { windowEvents(w).character(c); });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
        glfwSetWindowShouldClose(w, GLFW_FALSE);
        windowEvents(w).closing();
    });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        if (count > 0) windowEvents(w).dropped({paths, paths + count});
    });
}

SurfaceSource Window::surface() const {
    SurfaceSource source;
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    source.instanceExtensions.assign(names, names + count);
    source.create = [window = window_](VkInstance instance) {
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        if (glfwCreateWindowSurface(instance, window, nullptr, &surface) != VK_SUCCESS)
            throw Error("cannot draw into the window", "", lastError());
        return surface;
    };
    return source;
}

PixelSize Window::size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

double Window::pixelsPerPoint() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(static_cast<double>(x), 0.5, 8.0);
}

double Window::refreshRate() const {
    GLFWmonitor* monitor = glfwGetWindowMonitor(window_);
    if (!monitor) monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    return mode && mode->refreshRate > 0 ? mode->refreshRate : 60.0;
}

void Window::show() { glfwShowWindow(window_); }
void Window::toggleFullScreen() {
    if (glfwGetWindowMonitor(window_)) {
        const auto& [x, y, width, height] = restored_;
        return glfwSetWindowMonitor(window_, nullptr, x, y, width, height, GLFW_DONT_CARE);
    }
    auto& [x, y, width, height] = restored_;
    glfwGetWindowPos(window_, &x, &y);
    glfwGetWindowSize(window_, &width, &height);
    // The monitor that has the window's middle.
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    for (int i = 0; i < count; ++i) {
        int left = 0, top = 0, wide = 0, high = 0;
        glfwGetMonitorWorkarea(monitors[i], &left, &top, &wide, &high);
        const int midX = x + width / 2 - left, midY = y + height / 2 - top;
        if (midX >= 0 && midX < wide && midY >= 0 && midY < high) monitor = monitors[i];
    }
    if (!monitor) return;
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool Window::isFullScreen() const { return glfwGetWindowMonitor(window_) != nullptr; }

void Window::hide() { glfwHideWindow(window_); }

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(window_);
    return text ? text : "";
}

void Window::setClipboard(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

void Window::setTitle(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
}

bool Window::closing() const { return glfwWindowShouldClose(window_) != 0; }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

void Window::handleEvents(double seconds) {
    if (seconds <= 0 || closing())
        glfwPollEvents();
    else if (std::isinf(seconds))
        glfwWaitEvents();
    else
        glfwWaitEventsTimeout(seconds);
#ifdef __APPLE__
    if (const std::vector<std::string> paths = takeOpenedFiles(); !paths.empty()) events_.dropped(paths);
#endif
}

void Window::wake() { glfwPostEmptyEvent(); }

}  // namespace nacre::app
