#pragma once
// Survives a driver that ends the program while a window starts. Each start is noted in a file before the first device
// is made, and the note is removed after the first frames. If the note of a dead start is found, the next start takes
// fewer risks. After a number of good starts it tries the riskier modes again.

#include <string>

namespace nacre {

/// Ways to start, each with fewer risks than the one before.
enum class StartMode {
    usual,
    withoutCache,  ///< no pipeline cache
    plainPath,     ///< also by the path with the lowest demands on a driver
};
constexpr int kStartModes = 3;

/// One start. If destroyed before done(), the start was cancelled, but the program lives.
class StartGuard {
public:
    /// @param folder  DeviceOptions::selfTests; empty: guards nothing @throws Error if every mode ended the program
    explicit StartGuard(std::string folder);
    StartGuard(const StartGuard&) = delete;
    ~StartGuard() { end(false, {}); }

    StartMode mode() const { return mode_; }
    /// Call once frames were shown. @param driverKey  if it differs from earlier starts, their findings are cleared
    void done(const std::string& driverKey) { end(true, driverKey); }

private:
    void end(bool well, const std::string& driverKey);

    std::string folder_;
    StartMode mode_ = StartMode::usual;
    bool open_ = false;
};

}  // namespace nacre
