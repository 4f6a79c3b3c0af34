#pragma once
// Programs of the desktop that are asked for what they do best.

#include <optional>
#include <string>
#include <vector>

namespace nacre::app {

/// Whether PATH has a program.
bool hasProgram(const std::string& name);

/// What becomes of a program's standard output. One that is taken is waited for until nobody can write to it any more.
enum class ProgramOutput { taken, dropped };

/// Runs a program, no shell between, and waits until it ends. @param input  for its standard input
/// @returns its standard output, empty if that is dropped, or nothing if it failed or is not there
std::optional<std::string> runProgram(const std::vector<std::string>& arguments, const std::string& input = {},
                                      ProgramOutput output = ProgramOutput::taken);

/// Puts a PNG onto the clipboard, by wl-copy or xclip. @returns whether one of them took it
bool copyPng(const std::string& path);
/// What xclip or wl-copy have to be installed for, in a sentence.
inline constexpr const char* kCopyNeeds = "install xclip, or on Wayland wl-clipboard, to copy pictures";

/// Whether the desktop asks for dark windows: GTK_THEME, else GNOME's setting, else what GTK's or KDE's file says.
bool systemIsDark();

}  // namespace nacre::app
