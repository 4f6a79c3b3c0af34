#pragma once
// The command line as plain data.

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/shared/option_values.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/renderer.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre::app {

struct InputOptions {
    std::string path;  ///< a file, "-", "sample:NAME", or "pdb:", "pubchem:", "afdb:" and an identifier
    std::optional<Format> format;
    int model = 1;                     ///< 1-based, or kAllModels
    std::optional<std::string> cache;  ///< folder, or "off"; empty: the usual one (app/shared/cache_folder.h)
    bool offline = false;              ///< downloads from the cache alone
    std::optional<std::int64_t> memoryMegabytes;  ///< for the molecule, of 2^20 bytes; empty: half of the machine's
};

struct OcclusionSettings {
    int directions = 128;                   ///< 0 = off
    std::optional<std::int64_t> megabytes;  ///< of 2^20 bytes; RenderSettings has the default

    std::uint64_t bytes() const {
        return megabytes ? static_cast<std::uint64_t>(*megabytes) << 20 : RenderSettings{}.occlusion.bytes;
    }
};

struct RenderOptions {
    InputOptions input;
    DrawnAtomsOptions drawn;
    RepresentationOptions look;
    Camera camera;
    Size size;
    std::uint32_t supersample = 1;
    std::array<float, 4> background{1, 1, 1, 1};  ///< sRGB-coded, straight alpha
    bool lighting = true;
    OcclusionSettings occlusion;
    bool prepass = true, merge = true, transient = true;
    DebugView debug = DebugView::none;
    DeviceOptions device;
    std::string output, layers, stats, capture;  ///< paths; all but the first may be empty
    InputOptions savedInput;  ///< of the saved view; `input` once the command line is read, if that has none
};

struct InfoOptions {
    InputOptions input;
    bool json = false;
};

struct BenchOptions {
    InputOptions input;
    DrawnAtomsOptions drawn;
    RepresentationOptions look;
    Size size{640, 960};
    int frames = 20;
    OcclusionSettings occlusion;
    DeviceOptions device;
    bool json = false;
};

/// A window: what it shows at first is said as for `render`; `size` is the window's.
struct ViewOptions {
    RenderOptions first;
    bool restore = false;  ///< no INPUT and no saved view: go on where the last window was left
};

enum class PlanFormat { text, json, dot };

struct PlanOptions {
    std::string caps;  ///< name of a capability set; empty: the real device
    DeviceOptions device;
    Size size;
    bool merge = true;
    PlanFormat format = PlanFormat::text;
};

enum class Command { help, version, notices, render, view, info, devices, bench, plan };

struct CommandLine {
    Command command = Command::help;
    std::string help;  ///< what to print for Command::help
    RenderOptions render;
    ViewOptions view;
    InfoOptions info;
    BenchOptions bench;
    PlanOptions plan;
    bool json = false;  ///< devices
};

/// The command line was used wrongly; what() says how, in one line.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// @throws UsageError
CommandLine parseCommandLine(int argc, const char* const* argv);

}  // namespace nacre::app
