#pragma once
// The options of commands that draw pictures: rows of app/picture/options.h, and additional ones of some commands, of
// job lines in `nacre batch`, and of `nacre serve`.

#include <string>
#include <vector>

#include "app/cli/command_spec.h"
#include "app/cli/options.h"
#include "app/serve/serve_options.h"

namespace nacre::app {

/// The options of a picture for some topics, in table order.
/// @param given  receives the options given; may be null
void addPicture(CommandSpec& command, PictureDescription& picture, Topics topics,
                std::vector<OptionValue>* given = nullptr);
/// One or more INPUTs, and how each is read.
void addInputs(CommandSpec& command, std::vector<std::string>& paths, PictureDescription& picture);

void addRender(CommandSpec& command, PictureDescription& picture);
void addMovie(CommandSpec& command, MovieOptions& options);
/// Initial contents of a window, with the options of `render`; `size` is the window's.
void addWindow(CommandSpec& command, PictureDescription& first);
/// Contents of a headset's room.
void addHeadset(CommandSpec& command, PictureDescription& first);
void addLooks(CommandSpec& command, LooksOptions& options);

/// @throws UsageError
void checkLooks(const LooksOptions& options);
/// Checks that need more than one option. Without INPUT, uses that of the first key view. @throws UsageError, Error
void checkMovie(MovieOptions& options);
/// As above for a window. @returns whether there is an INPUT
bool checkWindow(PictureDescription& first);

/// @param options  receives values; outlives the command
void addBatch(CommandSpec& command, BatchOptions& options);

/// The picture of a job's line, after the options common to all. @throws UsageError
PictureDescription parseJob(const std::string& json, const BatchOptions& batch);

/// @param options  receives values; outlives the command
void addFigure(CommandSpec& command, FigureOptions& options);
/// Like parseJob(), for a panel. @param line  receives the line's own settings, beyond the common options @throws
/// UsageError
PictureDescription parsePanel(const std::string& json, const FigureOptions& options, PanelLine& line);

/// Options of `nacre serve`.
void addServe(CommandSpec& command, ServeOptions& options);

}  // namespace nacre::app
