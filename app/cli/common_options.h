#pragma once
// Options that several commands share, and what they are built from.

#include <functional>

#include "app/cli/options.h"

namespace nacre::app {

/// An option with one value.
/// @param set throws std::invalid_argument or Error for what it does not take
OptionSpec& addValue(CommandSpec& command, const std::string& name, const std::string& type,
                     const std::string& fallback, const std::string& help, std::function<void(const std::string&)> set);
void addFlag(CommandSpec& command, const std::string& name, bool& target, const std::string& help);
void addOnOff(CommandSpec& command, const std::string& name, bool& target, const std::string& help);
/// A file's name as it is. @throws std::invalid_argument if it is empty
std::string fileName(const std::string& text);

/// INPUT, and how it is read. @param required  whether INPUT has to be there
void addInput(CommandSpec& command, InputOptions& input, bool required);
/// INPUT, as many as there are, and how they are read.
void addInputs(CommandSpec& command, std::vector<std::string>& paths, InputOptions& input);
/// Where the atoms of INPUT are.
void addTrajectory(CommandSpec& command, TrajectoryOptions& trajectory);
void addSize(CommandSpec& command, const std::string& fallback, Size& size);
OptionSpec& addDeviceName(CommandSpec& command, DeviceOptions& device);
void addVisibility(CommandSpec& command, DeviceOptions& device);
/// Degrees, zoom and lens. @param rotateHelp  what --rotate turns
void addCameraValues(CommandSpec& command, Camera& camera, const char* rotateHelp);
void addSupersample(CommandSpec& command, const std::string& fallback, std::uint32_t& supersample);
/// @param share  as RenderSettings::meshError
void addMeshError(CommandSpec& command, const std::string& fallback, double& share);
/// Which atoms are drawn, and how they look.
void addAppearance(CommandSpec& command, DrawnAtomsOptions& drawn, RepresentationOptions& look);
/// INPUT, what is drawn of it and how it looks: the same for every command that draws pictures.
void addContent(CommandSpec& command, InputOptions& input, bool required, DrawnAtomsOptions& drawn,
                RepresentationOptions& look);
void addOcclusion(CommandSpec& command, OcclusionOptions& occlusion);

}  // namespace nacre::app
