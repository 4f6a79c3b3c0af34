#pragma once
// The window, driven from within by the names of its controls, and the screens and states that it is driven to.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "app/desktop/window_session.h"

namespace nacre::app {

inline double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Driver {
public:
    explicit Driver(const ViewOptions& options) : session_(options), events_(session_.events()) { settle(); }

    Viewer& viewer() { return session_.viewer(); }
    Panel& panel() { return session_.panel(); }

    /// Until nothing is due any more.
    void settle(double most = 20) {
        const double end = seconds() + most;
        int downloading = 0;
        for (int quiet = 0; quiet < 4 && seconds() < end && downloading < 40;
             downloading += viewer().reading().loader().progress() >= 0)
            quiet = session_.step(0.05) > 0.2 && !viewer().reading().loader().busy() ? quiet + 1 : 0;
    }
    void pause(double time) {
        const double end = seconds() + time;
        while (seconds() < end) session_.step(0.02);
    }
    /// The first control that is seen of a name, or of one with what a file calls it behind: "Chain A, Hemoglobin".
    const Control* find(const std::string& name) {
        for (const Control& c : panel().controls())
            if ((c.name == name || c.name.starts_with(name + ", ")) && c.seen() && c.role != "text") return &c;
        return nullptr;
    }
    /// Whether a text that begins so is there.
    bool tells(const std::string& beginning) {
        const std::vector<Control>& all = panel().controls();
        return std::any_of(all.begin(), all.end(), [&](const Control& c) { return c.name.starts_with(beginning); });
    }
    /// Scrolls to a control, if need be, and clicks it.
    void click(const std::string& name) {
        const Control* c = find(name);
        for (int i = 0; i < 40 && (!c || c->seenBottom - c->seenTop < 0.9f * (c->bottom - c->top)); ++i) {
            for (const Control& any : panel().controls())
                if (any.seen() && any.window == "Nacre")
                    events_.pointer({(any.seenLeft + any.seenRight) / 2, (any.seenTop + any.seenBottom) / 2});
            events_.wheel(-1, {});
            for (int k = 0; k < 3; ++k) session_.step(0.02);
            c = find(name);
        }
        if (!c) {
            std::cerr << "there is no \"" << name << "\"\n";
            std::exit(1);
        }
        clickAt({(c->seenLeft + c->seenRight) / 2, (c->seenTop + c->seenBottom) / 2});
    }
    void clickAt(glm::dvec2 at) {
        events_.pointer(at);
        session_.step(0.02);
        events_.button(MouseButton::left, true, {});
        session_.step(0.02);
        events_.button(MouseButton::left, false, {});
        for (int i = 0; i < 4; ++i) session_.step(0.02);
    }
    void rightClick(glm::dvec2 at) {
        events_.pointer(at);
        session_.step(0.02);
        for (const bool down : {true, false}) events_.button(MouseButton::right, down, {});
        for (int i = 0; i < 6; ++i) session_.step(0.02);
    }
    void moveTo(glm::dvec2 at) { events_.pointer(at); }
    void type(const std::string& text) {
        for (const char c : text) {
            events_.character(static_cast<char32_t>(c));
            for (int i = 0; i < 2; ++i) session_.step(0.02);
        }
    }
    void press(SpecialKey key) {
        events_.special(key, true, false, {});
        session_.step(0.02);
        events_.special(key, false, false, {});
        session_.step(0.02);
    }
    void offer(const std::string& path) {
        events_.dropped({path});
        pause(0.3);
    }
    void drop(const std::string& path) {
        offer(path);
        settle();
        if (find("Replace")) click("Replace"), settle();
    }
    bool rests = true;  ///< the picture is taken once nothing moves
    void run(ViewerCommand command) { viewer().run(command, seconds()); }
    void quit() { events_.closing(); }

private:
    WindowSession session_;
    WindowEvents events_;
};

struct State {
    const char* name;
    Size size;
    const char* input;
    std::function<void(Driver&)> act;
};

/// @param models  a file of several; empty: there is none
std::vector<State> states(const std::string& protein, const std::string& models);

}  // namespace nacre::app
