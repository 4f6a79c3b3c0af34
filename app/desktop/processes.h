#pragma once
// Programs of the desktop that are asked for what they do best.

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace nacre::app {

/// Whether PATH has a program.
bool hasProgram(const std::string& name);

/// Runs a program, no shell between. @param input  for its standard input
/// @returns its standard output, or nothing if it failed or is not there
std::optional<std::string> runProgram(const std::vector<std::string>& arguments, const std::string& input = {});

/// The desktop's dialog for a file, on a thread of its own: kdialog under KDE, else zenity, else kdialog.
class FileDialog {
public:
    ~FileDialog();
    static bool available();
    /// @param chosen  told the path, on the dialog's thread; not if the user cancels. Nothing happens while one is open
    void open(std::function<void(const std::string&)> chosen);

private:
    std::thread thread_;
    std::shared_ptr<std::atomic<bool>> busy_ = std::make_shared<std::atomic<bool>>(false);
};

/// Puts a PNG onto the clipboard, by wl-copy or xclip. @returns whether one of them took it
bool copyPng(const std::string& path);
/// What xclip or wl-copy have to be installed for, in a sentence.
inline constexpr const char* kCopyNeeds = "install xclip, or on Wayland wl-clipboard, to copy pictures";

/// Whether the desktop asks for dark windows: GTK_THEME, else GNOME's setting, else what GTK's or KDE's file says.
bool systemIsDark();

}  // namespace nacre::app
