#pragma once
// Completes and checks a description before drawing: rules that involve several options. Finds options without visible
// effect.

#include <string>
#include <vector>

#include "app/files/output_file.h"
#include "app/picture/description.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {

/// All functions below, for one picture in a file. @throws UsageError
void completePicture(PictureDescription& picture);
/// As above, for a picture without a file: `output` has only its format.
void completeUnwritten(PictureDescription& picture);

/// Finds the trajectory of a saved view, and decides how INPUT is read. @returns whether there is an INPUT
bool takeInput(PictureDescription& picture);
/// Draws an INPUT that is a density map as if --map named it; the first one without a molecule. Not an input that is
/// already open: its name may refer to another file by now.
void takeMap(PictureDescription& picture);
/// Several INPUTs: resolves their names in selections, and gives the carbons of each their own colour, unless a saved
/// view sets them. @throws UsageError
void takeSeveral(PictureDescription& picture);
/// @param throughModels  a movie shows the models in sequence @throws UsageError
void checkFrames(const PictureDescription& picture, bool throughModels = false);
/// @throws UsageError
void checkDebug(const PictureDescription& picture);
/// @param most  maximum number of samples per picture @throws UsageError
void checkSize(const PictureDescription& picture, std::uint64_t most = kMostSamples);
/// Checks that no file is written over another. @param further  files of some commands only @throws UsageError
void checkFiles(const PictureDescription& picture, std::vector<NamedFile> further = {});

/// Converts print sizes to pixels. @throws UsageError if the result is zero or too large
void takePaper(PictureDescription& picture);

/// The description with paths valid from any folder, for a window that outlives its command line.
PictureDescription withWholePaths(PictureDescription picture);

/// Warnings, one sentence each, for options that change nothing in the picture, and for clipping that leaves nothing.
/// @param effects  of the picture: zooming to a part also clips
/// @param reach  of the scene from its centre, Å
std::vector<std::string> idleOptions(const PictureDescription& options, const Representation& scene,
                                     const Effects& effects, double reach);

}  // namespace nacre::app
