#pragma once
// The options of commands that draw pictures: rows of app/picture/options.h, and what some commands have beside them.

#include <functional>

#include "app/cli/options.h"

namespace nacre::app {

/// The options of a picture that are about some topics, in the order of the table.
/// @param given  notes what is given; null: nobody does
void addPicture(CommandSpec& command, PictureDescription& picture, Topics topics,
                std::vector<OptionValue>* given = nullptr);
/// INPUT, as many as there are, and how each is read.
void addInputs(CommandSpec& command, std::vector<std::string>& paths, PictureDescription& picture);

void addRender(CommandSpec& command, PictureDescription& picture);
void addMovie(CommandSpec& command, MovieOptions& options);
/// What a window shows at first is said as for `render`; `size` is the window's.
void addWindow(CommandSpec& command, PictureDescription& first);
void addLooks(CommandSpec& command, LooksOptions& options);

/// @throws UsageError
void checkLooks(const LooksOptions& options);
/// What no option alone can tell; INPUT is that of its first key view if there is no other. @throws UsageError, Error
void checkMovie(MovieOptions& options);
/// The same for a window. @returns whether there is an INPUT
bool checkWindow(PictureDescription& first);

}  // namespace nacre::app
