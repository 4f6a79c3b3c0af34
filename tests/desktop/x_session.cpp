#include "tests/desktop/x_session.h"

#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace nacre::test {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Starts a program by the shell, in a process group of its own.
int start(const std::string& command) {
    const int pid = fork();
    if (pid != 0) return pid;
    setpgid(0, 0);
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
}

void stop(int& pid) {
    if (pid <= 0) return;
    kill(-pid, SIGTERM);
    kill(pid, SIGTERM);
    waitpid(pid, nullptr, 0);
    pid = -1;
}

}  // namespace

/// Xvfb and a window manager, from the first session until the test's program ends: each of them has one window.
struct Desktop {
    int xvfb = -1, manager = -1;
    std::string name;
    Display* display = nullptr;

    Desktop();
    ~Desktop() {
        if (display) XCloseDisplay(display);
        stop(manager);
        stop(xvfb);
    }
    static Desktop& get() {
        static Desktop desktop;
        return desktop;
    }
};

struct XSession::X {
    Display* display = nullptr;
    Window window = 0;

    Atom atom(const char* name) const { return XInternAtom(display, name, False); }

    std::vector<Window> listWindows(const char* property) const {
        Atom type = 0;
        int format = 0;
        unsigned long count = 0, left = 0;
        unsigned char* data = nullptr;
        std::vector<Window> windows;
        if (XGetWindowProperty(display, DefaultRootWindow(display), atom(property), 0, 100, False, XA_WINDOW, &type,
                               &format, &count, &left, &data) == Success &&
            data) {
            windows.assign(reinterpret_cast<Window*>(data), reinterpret_cast<Window*>(data) + count);
            XFree(data);
        }
        return windows;
    }

    void send(Window to, const char* type, std::array<long, 5> data, long mask = 0) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.display = display;
        event.xclient.window = window;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[static_cast<std::size_t>(i)];
        XSendEvent(display, to, False, mask, &event);
        XFlush(display);
    }

    /// The window's corner on the display.
    void origin(int& x, int& y) const {
        Window child = 0;
        XTranslateCoordinates(display, window, DefaultRootWindow(display), 0, 0, &x, &y, &child);
    }
};

Desktop::Desktop() {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    xvfb = start("exec Xvfb -displayfd " + std::to_string(ends[1]) + " -screen 0 1280x1000x24 >/dev/null 2>&1");
    close(ends[1]);
    char number[16] = {};
    const ssize_t length = read(ends[0], number, sizeof number - 1);
    close(ends[0]);
    if (length <= 0) throw std::runtime_error("Xvfb did not start");
    name = ":" + std::to_string(std::atoi(number));
    display = XOpenDisplay(name.c_str());
    if (!display) throw std::runtime_error("no display " + name);
    // A window that went is no reason to end the test's program.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    manager = start("exec env DISPLAY=" + name + " openbox >/dev/null 2>&1");
    XSession::X x{display};
    const double end = now() + 60;
    while (x.listWindows("_NET_SUPPORTING_WM_CHECK").empty() && now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

std::string XSession::display() { return Desktop::get().name; }

XSession::XSession(const std::string& arguments, const std::string& windowState) : x_(std::make_unique<X>()) {
    if (!windowState.empty()) {
        std::filesystem::create_directories(folder_ / "state/nacre");
        std::ofstream(folder_ / "state/nacre/window.json") << windowState;
    }
    x_->display = Desktop::get().display;
    // Where no window lies under the pointer.
    XTestFakeMotionEvent(x_->display, -1, 1279, 999, CurrentTime);
    startNacre(arguments);
    findWindow();
    settle();
}

XSession::~XSession() { stop(nacre_); }

void XSession::startNacre(const std::string& arguments) {
    nacre_ =
        start("cd '" + folder_.path() + "' && exec env -u WAYLAND_DISPLAY DISPLAY=" + display() + " HOME='" +
              folder_.path() + "' XDG_STATE_HOME='" + (folder_ / "state") + "' XDG_CACHE_HOME='" + (folder_ / "cache") +
              "' '" NACRE_PROGRAM "' view " + arguments + " --validate --stats stats.json >log 2>&1");
}

void XSession::findWindow() {
    const double end = now() + 60;
    while (now() < end) {
        for (const Window window : x_->listWindows("_NET_CLIENT_LIST")) {
            XClassHint hint{};
            if (!XGetClassHint(x_->display, window, &hint)) continue;
            const bool ours = std::string(hint.res_name) == "nacre";
            XFree(hint.res_name);
            XFree(hint.res_class);
            if (ours) {
                x_->window = window;
                return;
            }
        }
        if (waitpid(nacre_, nullptr, WNOHANG) == nacre_) {
            nacre_ = -1;
            throw std::runtime_error("nacre ended: " + errors());
        }
        sleep(0.02);
    }
    throw std::runtime_error("no window came: " + errors());
}

void XSession::sleep(double seconds) const { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

void XSession::moveTo(int x, int y) {
    int left = 0, top = 0;
    x_->origin(left, top);
    XTestFakeMotionEvent(x_->display, -1, left + x, top + y, CurrentTime);
    XFlush(x_->display);
}

void XSession::button(int number, bool down) {
    XTestFakeButtonEvent(x_->display, static_cast<unsigned>(number), down, CurrentTime);
    XFlush(x_->display);
}

void XSession::click(int x, int y) {
    moveTo(x, y);
    sleep(0.05);
    button(1, true);
    sleep(0.02);
    button(1, false);
    sleep(0.05);
}

void XSession::drag(int fromX, int fromY, int toX, int toY) {
    moveTo(fromX, fromY);
    sleep(0.1);
    button(1, true);
    for (int i = 1; i <= 10; ++i) {
        sleep(0.03);
        moveTo(fromX + (toX - fromX) * i / 10, fromY + (toY - fromY) * i / 10);
    }
    sleep(0.3);
    button(1, false);
}

void XSession::wheel(int x, int y, int steps) {
    moveTo(x, y);
    sleep(0.1);
    for (int i = 0; i < std::abs(steps); ++i) {
        button(steps > 0 ? 4 : 5, true);
        button(steps > 0 ? 4 : 5, false);
        sleep(0.03);
    }
}

void XSession::type(const std::string& keysym, bool shift) {
    const KeyCode code = XKeysymToKeycode(x_->display, XStringToKeysym(keysym.c_str()));
    const KeyCode shiftCode = XKeysymToKeycode(x_->display, XStringToKeysym("Shift_L"));
    if (shift) XTestFakeKeyEvent(x_->display, shiftCode, True, CurrentTime);
    XTestFakeKeyEvent(x_->display, code, True, CurrentTime);
    XTestFakeKeyEvent(x_->display, code, False, CurrentTime);
    if (shift) XTestFakeKeyEvent(x_->display, shiftCode, False, CurrentTime);
    XFlush(x_->display);
    sleep(0.1);
}

void XSession::typeAtOnce(const std::vector<std::string>& keysyms) {
    const auto press = [this](KeyCode code, bool down) { XTestFakeKeyEvent(x_->display, code, down, CurrentTime); };
    for (const std::string& keysym : keysyms) {
        const std::size_t plus = keysym.find('+');
        const KeySym symbol = XStringToKeysym(keysym.substr(plus == std::string::npos ? 0 : plus + 1).c_str());
        const KeyCode code = XKeysymToKeycode(x_->display, symbol);
        std::vector<std::string> with;
        if (plus != std::string::npos) with.push_back(keysym.substr(0, plus));
        if (XkbKeycodeToKeysym(x_->display, code, 0, 0) != symbol) with.push_back("Shift_L");
        const auto hold = [&](bool down) {
            for (const std::string& key : with)
                press(XKeysymToKeycode(x_->display, XStringToKeysym(key.c_str())), down);
        };
        hold(true);
        press(code, true), press(code, false);
        hold(false);
    }
    XFlush(x_->display);
}

void XSession::resize(int width, int height) {
    XResizeWindow(x_->display, x_->window, static_cast<unsigned>(width), static_cast<unsigned>(height));
    XFlush(x_->display);
}

void XSession::iconify() {
    XIconifyWindow(x_->display, x_->window, DefaultScreen(x_->display));
    XFlush(x_->display);
}

void XSession::restore() {
    x_->send(DefaultRootWindow(x_->display), "_NET_ACTIVE_WINDOW", {2, 0, 0, 0, 0},
             SubstructureRedirectMask | SubstructureNotifyMask);
    XMapWindow(x_->display, x_->window);
    XFlush(x_->display);
}

bool XSession::drop(const std::vector<std::string>& paths) {
    Display* d = x_->display;
    const Window source = XCreateSimpleWindow(d, DefaultRootWindow(d), 0, 0, 1, 1, 0, 0, 0);
    const Atom selection = x_->atom("XdndSelection"), list = x_->atom("text/uri-list");
    XSetSelectionOwner(d, selection, source, CurrentTime);
    int left = 0, top = 0;
    x_->origin(left, top);
    const auto from = static_cast<long>(source);
    x_->send(x_->window, "XdndEnter", {from, 5l << 24, static_cast<long>(list), 0, 0});
    x_->send(x_->window, "XdndPosition",
             {from, 0, static_cast<long>(left + 200) << 16 | (top + 200), CurrentTime,
              static_cast<long>(x_->atom("XdndActionCopy"))});
    bool finished = false, accepted = false;
    const double end = now() + 10;
    while (!finished && now() < end) {
        if (!XPending(d)) {
            sleep(0.01);
            continue;
        }
        XEvent event;
        XNextEvent(d, &event);
        if (event.type == ClientMessage && event.xclient.message_type == x_->atom("XdndStatus") && !accepted) {
            accepted = event.xclient.data.l[1] & 1;
            if (!accepted) break;
            x_->send(x_->window, "XdndDrop", {from, 0, CurrentTime, 0, 0});
        } else if (event.type == ClientMessage && event.xclient.message_type == x_->atom("XdndFinished")) {
            finished = true;
        } else if (event.type == SelectionRequest) {
            const XSelectionRequestEvent& request = event.xselectionrequest;
            std::string uri;
            for (const std::string& path : paths) uri += "file://" + path + "\r\n";
            XChangeProperty(d, request.requestor, request.property, request.target, 8, PropModeReplace,
                            reinterpret_cast<const unsigned char*>(uri.data()), static_cast<int>(uri.size()));
            XEvent answer{};
            answer.xselection.type = SelectionNotify;
            answer.xselection.requestor = request.requestor;
            answer.xselection.selection = request.selection;
            answer.xselection.target = request.target;
            answer.xselection.property = request.property;
            answer.xselection.time = request.time;
            XSendEvent(d, request.requestor, False, 0, &answer);
            XFlush(d);
        }
    }
    XDestroyWindow(d, source);
    return finished;
}

std::string XSession::title() const {
    Atom type = 0;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* data = nullptr;
    std::string text;
    if (XGetWindowProperty(x_->display, x_->window, x_->atom("_NET_WM_NAME"), 0, 1000, False, x_->atom("UTF8_STRING"),
                           &type, &format, &count, &left, &data) == Success &&
        data) {
        text.assign(reinterpret_cast<char*>(data), count);
        XFree(data);
    }
    return text;
}

WindowPicture XSession::picture() const {
    XWindowAttributes attributes{};
    WindowPicture picture;
    if (!XGetWindowAttributes(x_->display, x_->window, &attributes) || attributes.map_state != IsViewable)
        return picture;
    XImage* image = XGetImage(x_->display, x_->window, 0, 0, static_cast<unsigned>(attributes.width),
                              static_cast<unsigned>(attributes.height), AllPlanes, ZPixmap);
    if (!image) return picture;
    picture.width = attributes.width;
    picture.height = attributes.height;
    picture.rgb.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 3);
    std::uint8_t* to = picture.rgb.data();
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x, to += 3) {
            const unsigned long p = XGetPixel(image, x, y);
            to[0] = static_cast<std::uint8_t>(p >> 16);
            to[1] = static_cast<std::uint8_t>(p >> 8);
            to[2] = static_cast<std::uint8_t>(p);
        }
    XDestroyImage(image);
    return picture;
}

void XSession::settle() {
    WindowPicture last;
    std::string lastTitle;
    int same = 0;
    const double end = now() + 60;
    while (same < 4 && now() < end) {
        sleep(0.12);
        WindowPicture next = picture();
        const std::string nextTitle = title();
        same = next == last && nextTitle == lastTitle && nextTitle.find("occlusion") == std::string::npos &&
                       nextTitle.find("reading") == std::string::npos && nextTitle != "Nacre"
                   ? same + 1
                   : 0;
        last = std::move(next);
        lastTitle = nextTitle;
    }
}

bool XSession::waitUntil(const std::function<bool()>& so) const {
    const double end = now() + 60;
    while (now() < end) {
        if (so()) return true;
        sleep(0.05);
    }
    return so();
}

bool XSession::waitForTitle(const std::string& text) const {
    return waitUntil([&] { return title().find(text) != std::string::npos; });
}

int XSession::quit() {
    typeAtOnce({"Control_L+q"});
    const int status = awaitEnd();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int XSession::end(int signal) {
    kill(nacre_, signal);
    const int status = awaitEnd();
    return WIFSIGNALED(status) ? WTERMSIG(status) : -WEXITSTATUS(status);
}

/// @returns as waitpid() tells it; after a minute it is stopped by force
int XSession::awaitEnd() {
    const double end = now() + 60;
    int status = 0;
    while (waitpid(nacre_, &status, WNOHANG) != nacre_) {
        if (now() > end) kill(nacre_, SIGKILL);
        sleep(0.05);
    }
    nacre_ = -1;
    return status;
}

}  // namespace nacre::test
