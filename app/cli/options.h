#pragma once
// The command line as plain data.

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/cli/command_spec.h"
#include "app/cli/info_interactions.h"
#include "app/cli/set_options.h"
#include "app/desktop/view_options.h"
#include "app/export/export_scene.h"
#include "app/movie/camera_path.h"
#include "app/picture/aim.h"
#include "app/picture/input_options.h"
#include "app/picture/option_values.h"
#include "app/picture/words.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"
#include "engine/settings.h"

namespace nacre::app {

struct OcclusionOptions {
    int directions = 128;                   ///< 0 = off
    std::uint32_t detail = 32;              ///< texels across a sphere's patch, at most
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
    Aim aim;
    Words words;
    Size size;
    std::optional<Length> width, height;  ///< prevail over `size`, which says how they relate if only one is there
    std::optional<double> dpi;            ///< dots an inch
    std::optional<double> contourPoints, haloPoints, textPoints;  ///< 72 an inch; prevail over pixels
    int bits = 8;                                                 ///< of a channel of the file
    std::uint32_t supersample = RenderSettings::kEdges;
    double meshError = 0.25;                      ///< as RenderSettings::meshError
    std::array<float, 4> background{1, 1, 1, 1};  ///< sRGB-coded, straight alpha
    bool lighting = true;
    Effects effects;
    std::set<std::string> givenEffects;  ///< those that were named, not brought by a look or view
    OcclusionOptions occlusion;
    FrameTuning tuning;
    DebugView debug = DebugView::none;
    DeviceOptions device;
    std::string output, layers, stats, capture;  ///< paths; all but the first may be empty
    std::string view;                            ///< path of the saved view; empty: none
    InputOptions savedInput;  ///< of the saved view; `input` once the command line is read, if that has none
};

/// What moves, how long, and how fast.
struct MovieOptions {
    RenderOptions picture;
    std::optional<glm::dvec3> spin;  ///< axis of a turn
    std::optional<double> turns;     ///< of spin; empty: one
    std::optional<double> rock;      ///< degrees to either side
    std::optional<glm::dvec3> axis;  ///< of rock; empty: y
    bool models = false;             ///< one after the other
    std::vector<std::string> views;
    std::vector<OptionValue> given;  ///< of `picture`: they prevail over each of the views
    bool loop = false;               ///< the last view is followed by the first
    std::optional<double> seconds;   ///< empty: what the motion takes
    double framesPerSecond = 30;
    std::optional<Easing> easing;
    std::string report;  ///< path, "-" for standard output; empty: none
};

struct BatchOptions {
    std::string path;                 ///< of the jobs; "-": standard input
    int parallel = 1;                 ///< jobs in work at once
    bool resume = false;              ///< jobs whose files are there are done
    std::vector<OptionValue> common;  ///< of `render`, for every job
    RenderOptions tried;              ///< what those come to; `device` is the batch's
};

struct InfoOptions {
    std::vector<std::string> paths;  ///< one or more
    InputOptions input;              ///< how each of them is read
    bool residues = false;           ///< each of them, with its place in the fold
    std::optional<InteractionRequest> interactions;
    InteractionRules interactionRules = InteractionRules::molstar;
    bool json = false, csv = false;  ///< csv: of the interactions alone
};

struct BenchOptions {
    std::vector<std::string> paths;  ///< one or more, each timed by itself
    InputOptions input;              ///< how each of them is read
    DrawnAtomsOptions drawn;
    RepresentationOptions look;
    Size size{640, 960};
    Camera camera;                  ///< of the first frame
    std::uint32_t supersample = 1;  ///< as RenderSettings::supersample
    double meshError = 0.5;         ///< as RenderSettings::meshError
    std::optional<int> frames;      ///< of a path; empty: 20, or fewer that take long
    OcclusionOptions occlusion;
    DeviceOptions device;
    bool json = false;
};

struct LooksOptions {
    RenderOptions picture;  ///< of a cell of the sheet; without an input there is none
    int columns = 4;
    bool json = false;
};

struct DevicesOptions {
    std::optional<std::string> cache;  ///< where self-tests are kept
    bool selfTest = false;             ///< is done anew
    bool json = false;
};

/// `nacre export`.
struct ExportCommandOptions {
    InputOptions input;
    DrawnAtomsOptions drawn;
    RepresentationOptions look;
    ExportOptions scene;
    double scale = 1;      ///< units of the file to the Å
    int directions = 0;    ///< of occlusion; 0: none
    DeviceOptions device;  ///< that bakes it
    std::string output, stats;
};

struct PlanOptions {
    RenderOptions picture;  ///< that the frame is of; `input`: whose geometry is counted, without a path none is
    std::string caps;       ///< name of a capability set; empty: the real device
    bool edges = false;     ///< as a picture's are drawn
    bool merge = true;
    bool json = false;
};

enum class Command { help, version, notices, render, movie, batch, looks, exporting, view, info, devices, bench, plan };

struct CommandLine {
    Command command = Command::help;
    std::string help;  ///< what to print for Command::help
    RenderOptions render;
    MovieOptions movie;
    BatchOptions batch;
    ViewOptions view;
    InfoOptions info;
    BenchOptions bench;
    PlanOptions plan;
    DevicesOptions devices;
    LooksOptions looks;
    ExportCommandOptions exported;
    std::string shell;   ///< whose completion is asked for
    bool quiet = false;  ///< nothing on standard error but errors
};

/// @throws UsageError
CommandLine parseCommandLine(int argc, const char* const* argv);

}  // namespace nacre::app
