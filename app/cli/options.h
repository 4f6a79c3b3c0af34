#pragma once
// The command line as plain data.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_spec.h"
#include "app/desktop/view_command.h"
#include "app/export/export_scene.h"
#include "app/movie/camera_path.h"
#include "app/picture/description.h"
#include "app/picture/option_json.h"
#include "app/serve/serve_options.h"

namespace nacre::app {

/// Every `step`-th frame from `first` to `last`, counted from 1.
struct FrameRange {
    std::int64_t first = 1, last = 0;  ///< last 0: to the end
    std::int64_t step = 1;
};

/// Motion, duration and frame rate.
struct MovieOptions : CameraMotion {
    PictureDescription picture;
    FrameRange range;  ///< of the models or frames
    std::vector<std::string> views;
    std::vector<OptionValue> given;  ///< options of `picture` that were given: they override each view's
    std::string report;              ///< path, "-" for standard output; empty: none
};

struct BatchOptions {
    std::string path;                 ///< of the jobs; "-": standard input
    int parallel = 1;                 ///< jobs at a time
    bool resume = false;              ///< skip jobs whose files exist
    std::vector<OptionValue> common;  ///< options of `render`, for every job
    PictureDescription tried;         ///< their result; `device` is the batch's
};

struct InfoOptions {
    enum class Output { text, json, jsonLines, csv };  ///< csv: interactions only
    std::vector<std::string> paths;                    ///< one or more
    PictureDescription picture;                        ///< how each input is read
    bool residues = false;                             ///< list residues, with secondary structure
    bool together = false;                             ///< the INPUTs are one scene
    bool frequencies = false;                          ///< frequency of each interaction
    Output output = Output::text;
    std::function<void()> onStep;  ///< called while an input is read; may throw to end the command
};

struct BenchOptions {
    std::vector<std::string> paths;  ///< one or more, timed separately
    PictureDescription picture;      ///< of each; the camera is that of the first frame
    std::optional<int> frames;       ///< per path; empty: 20, or fewer slow ones
    bool json = false;
};

struct LooksOptions {
    PictureDescription picture;  ///< of a cell of the sheet; there may be no input
    int columns = 4;
    bool json = false;
};

struct DevicesOptions {
    std::optional<std::string> cache;  ///< folder for self-tests
    bool selfTest = false;             ///< run it again
    bool json = false;
};

/// `nacre export`.
struct ExportCommandOptions {
    PictureDescription picture;  ///< content and destination of the file; ambient occlusion per vertex
    ExportOptions scene;
    double scale = 1;  ///< file units per Å
};

struct PlanOptions {
    PictureDescription picture;  ///< of the frame; `input`: counts its geometry, empty: none
    std::string caps;            ///< name of a capability set; empty: the real device
    bool edges = false;          ///< draw edges as pictures do
    bool headset = false;        ///< draw both eyes of a headset
    bool merge = true;
    bool explain = false;  ///< print each decision on the frame, with its reason
    bool json = false;
};

enum class PanelLetters { small, capital, off };

/// The parts of the camera that a panel's line sets. The first panel decides the others.
struct PanelLine {
    bool aims = false;     ///< any of these, or the point in the picture's middle
    bool turns = false;    ///< the side that faces the viewer
    bool rotates = false;  ///< relative to the first panel's side
    bool scales = false;
    bool clips = false;
    bool scaleBar = false;
};

/// `nacre figure`.
struct FigureOptions {
    BatchOptions batch;  ///< the panels as jobs without outputs, and their common options
    std::string output;
    int columns = 2;
    double gapPoints = 6;  ///< between panels, 72 per inch
    PanelLetters letters = PanelLetters::small;
};

enum class Command {
    help,
    version,
    notices,
    render,
    movie,
    batch,
    figure,
    serve,
    looks,
    exporting,
    view,
    info,
    devices,
    bench,
    plan,
    xr
};

struct CommandLine {
    Command command = Command::help;
    std::string help;  ///< text to print for Command::help
    PictureDescription render;
    MovieOptions movie;
    BatchOptions batch;
    FigureOptions figure;
    ServeOptions serve;
    ViewOptions view;
    InfoOptions info;
    BenchOptions bench;
    PlanOptions plan;
    DevicesOptions devices;
    LooksOptions looks;
    ExportCommandOptions exported;
    std::string shell;   ///< shell of the requested completion
    bool quiet = false;  ///< only errors on standard error
    bool verbose = false;
};

/// @throws UsageError
CommandLine parseCommandLine(int argc, const char* const* argv);

}  // namespace nacre::app
