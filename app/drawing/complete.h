#pragma once
// Completes and checks a description before anything is drawn by it: rules that concern several options at once.

#include <vector>

#include "app/files/output_file.h"
#include "app/picture/description.h"

namespace nacre::app {

/// All of what follows, for one picture in a file. @throws UsageError
void completePicture(PictureDescription& picture);

/// Finds the trajectory that a saved view names, and sets how INPUT is read. @returns whether there is an INPUT
bool takeInput(PictureDescription& picture);
/// Several INPUTs: their names in selections become what they mean, and the carbons of each get a colour of its own,
/// unless a saved view has them. @throws UsageError
void takeSeveral(PictureDescription& picture);
/// @param throughModels  a movie shows one model after the other @throws UsageError
void checkFrames(const PictureDescription& picture, bool throughModels = false);
/// @throws UsageError
void checkDebug(const PictureDescription& picture);
/// @param most  samples of a picture @throws UsageError
void checkSize(const PictureDescription& picture, std::uint64_t most = kMostSamples);
/// No file is written over another. @param further  files that not every command has @throws UsageError
void checkFiles(const PictureDescription& picture, std::vector<NamedFile> further = {});

/// Lengths on paper become pixels. @throws UsageError if there are none or too many
void takePaper(PictureDescription& picture);
/// Whether the file's format holds what is asked for. @throws UsageError
void checkFormat(const PictureDescription& picture);

/// The same with paths that hold from any folder, for a window that outlives its command line.
PictureDescription withWholePaths(PictureDescription picture);

}  // namespace nacre::app
