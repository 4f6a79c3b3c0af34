#pragma once
// Runs helper programs of the desktop.

#include <optional>
#include <string>
#include <vector>

namespace nacre::app {

/// Whether PATH has a program.
bool hasProgram(const std::string& name);

/// The use of a program's standard output: read until the last process closes it, or dropped.
enum class ProgramOutput { taken, dropped };

/// Runs a program without a shell, and waits for its end. @param input  for its standard input
/// @returns its standard output, empty if dropped; nothing if it failed or does not exist
std::optional<std::string> runProgram(const std::vector<std::string>& arguments, const std::string& input = {},
                                      ProgramOutput output = ProgramOutput::taken);

/// Copies a PNG to the clipboard, by wl-copy or xclip. @returns whether one of them accepted it
bool copyPng(const std::string& path);
/// Advice to install xclip or wl-copy, as a sentence.
inline constexpr const char* kCopyNeeds = "install xclip, or on Wayland wl-clipboard, to copy pictures";

/// Whether the desktop uses dark windows: GTK_THEME, else GNOME's setting, else GTK's or KDE's file.
bool systemIsDark();

}  // namespace nacre::app
