#pragma once
// The command line as plain data.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_spec.h"
#include "app/desktop/view_options.h"
#include "app/export/export_scene.h"
#include "app/movie/camera_path.h"
#include "app/picture/description.h"
#include "app/picture/option_json.h"
#include "app/serve/serve_options.h"

namespace nacre::app {

/// What moves, how long, and how fast.
struct MovieOptions : CameraMotion {
    PictureDescription picture;
    bool models = false;  ///< one after the other
    std::vector<std::string> views;
    std::vector<OptionValue> given;  ///< of `picture`: they prevail over each of the views
    bool loop = false;               ///< the last view is followed by the first
    std::string report;              ///< path, "-" for standard output; empty: none
};

struct BatchOptions {
    std::string path;                 ///< of the jobs; "-": standard input
    int parallel = 1;                 ///< jobs in work at once
    bool resume = false;              ///< jobs whose files are there are done
    std::vector<OptionValue> common;  ///< of `render`, for every job
    PictureDescription tried;         ///< what those come to; `device` is the batch's
};

struct InfoOptions {
    std::vector<std::string> paths;  ///< one or more
    PictureDescription picture;      ///< how each of them is read
    bool residues = false;           ///< each of them, with its place in the fold
    bool together = false;           ///< the INPUTs are one scene
    bool frequencies = false;        ///< how often each interaction is there
    bool json = false, csv = false;  ///< csv: of the interactions alone
};

struct BenchOptions {
    std::vector<std::string> paths;  ///< one or more, each timed by itself
    PictureDescription picture;      ///< of each of them; the camera is that of the first frame
    std::optional<int> frames;       ///< per path; empty: 20, or fewer that take long
    bool json = false;
};

struct LooksOptions {
    PictureDescription picture;  ///< of a cell of the sheet; without an input there is none
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
    PictureDescription picture;  ///< what is written, and where; occlusion that vertices have
    ExportOptions scene;
    double scale = 1;  ///< units of the file per Å
};

struct PlanOptions {
    PictureDescription picture;  ///< that the frame is of; `input`: whose geometry is counted, without a path none is
    std::string caps;            ///< name of a capability set; empty: the real device
    bool edges = false;          ///< as a picture's are drawn
    bool merge = true;
    bool json = false;
};

enum class Command {
    help,
    version,
    notices,
    render,
    movie,
    batch,
    serve,
    looks,
    exporting,
    view,
    info,
    devices,
    bench,
    plan
};

struct CommandLine {
    Command command = Command::help;
    std::string help;  ///< what to print for Command::help
    PictureDescription render;
    MovieOptions movie;
    BatchOptions batch;
    ServeOptions serve;
    ViewOptions view;
    InfoOptions info;
    BenchOptions bench;
    PlanOptions plan;
    DevicesOptions devices;
    LooksOptions looks;
    ExportCommandOptions exported;
    std::string shell;   ///< whose completion is asked for
    bool quiet = false;  ///< nothing on standard error but errors
    bool verbose = false;
};

/// @throws UsageError
CommandLine parseCommandLine(int argc, const char* const* argv);

}  // namespace nacre::app
