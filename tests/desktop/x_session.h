#pragma once
// `nacre view` on a display that the test's program has for itself (Xvfb with the window manager openbox), and a hand
// on mouse and keys.

#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace nacre::test {

/// What is in the window: row 0 on top, 3 bytes a pixel, red first.
struct WindowPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
    friend bool operator==(const WindowPicture&, const WindowPicture&) = default;
};

class XSession {
public:
    /// Starts everything and waits until the window has its final picture.
    /// @param arguments of `nacre view`, for the shell
    /// @param windowState  window.json of the last time; empty: there was none
    explicit XSession(const std::string& arguments, const std::string& windowState = {});
    ~XSession();
    XSession(const XSession&) = delete;

    /// In which nacre runs, and where its state and cache lie.
    const TemporaryFolder& folder() const { return folder_; }
    static std::string display();

    void moveTo(int x, int y);  ///< pixels of the window
    void button(int number, bool down);
    void click(int x, int y);                           ///< two in one place are a double click
    void drag(int fromX, int fromY, int toX, int toY);  ///< rests before it lets go
    void wheel(int x, int y, int steps);
    void type(const std::string& keysym, bool shift = false);
    /// Keys without hold times or pauses. @param keysyms  "BackSpace", "colon", "Control_L+o"
    void typeAtOnce(const std::vector<std::string>& keysyms);
    void resize(int width, int height);
    void iconify();
    void restore();
    /// Offers a file to the window as a file manager does (XDND version 5). @returns whether it was taken
    bool drop(const std::vector<std::string>& paths);

    std::string title() const;
    WindowPicture picture() const;
    /// Waits until picture and title no longer change.
    void settle();
    /// Waits until something is so: a minute, in case other programs are busy. @returns whether it came
    bool waitUntil(const std::function<bool()>& so) const;
    /// Waits until the title holds a text. @returns whether it came
    bool waitForTitle(const std::string& text) const;
    void sleep(double seconds) const;
    /// Types Ctrl Q and waits. @returns the exit status of nacre; its standard error is errors()
    int quit();
    /// Sends a signal and waits. @returns the one that nacre ended by, or the negative of its exit status
    int end(int signal);
    std::string errors() const { return readContents(folder_ / "log"); }
    nlohmann::json stats() const { return nlohmann::json::parse(readContents(folder_ / "stats.json")); }

    struct X;

private:
    void startNacre(const std::string& arguments);
    void findWindow();
    int awaitEnd();

    TemporaryFolder folder_;
    int nacre_ = -1;
    std::unique_ptr<X> x_;
};

}  // namespace nacre::test
