#pragma once
// Options that several commands share, added to CLI11's commands, and what they are built from.

#include <CLI/CLI.hpp>
#include <functional>

#include "app/cli/options.h"

namespace nacre::app {

/// An option with one value. Always a single string, since a CLI11 option of many values swallows the INPUT.
/// @param set throws std::invalid_argument or Error for what it does not take
CLI::Option* addValue(CLI::App& app, const std::string& name, const std::string& type, const std::string& fallback,
                      const std::string& help, std::function<void(const std::string&)> set);
void addOnOff(CLI::App& app, const std::string& name, bool& target, const std::string& help);
/// A file's name as it is. @throws std::invalid_argument if it is empty
std::string fileName(const std::string& text);

CLI::Option* addInput(CLI::App& app, InputOptions& input);
void addSize(CLI::App& app, const std::string& fallback, Size& size);
void addDeviceName(CLI::App& app, DeviceOptions& device);
void addVisibility(CLI::App& app, DeviceOptions& device);
/// What is drawn and how it looks: the same for every command that draws.
CLI::Option* addContent(CLI::App& app, InputOptions& input, DrawnAtomsOptions& drawn, RepresentationOptions& look);
void addOcclusion(CLI::App& app, OcclusionSettings& occlusion);

}  // namespace nacre::app
