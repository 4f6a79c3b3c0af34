#pragma once
// Statistics of a picture besides the renderer's.

#include <cstdint>
#include <string>
#include <vector>

#include "app/picture/stereo.h"
#include "engine/results.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/uncover.h"

namespace nacre::app {

struct RunStats {
    std::size_t atomsRead = 0, bondsKnown = 0;
    std::size_t atomsDrawn = 0, bondsDrawn = 0;
    std::size_t triangles = 0, vertices = 0;  ///< of cartoons and surfaces, stored once for all copies
    glm::dvec3 center{};                      ///< of the view, Å
    double zoom = 1;                          ///< of the view
    std::string clip;                         ///< in the format of --clip
    Stereo stereo;                            ///< with its distances, if enabled
    std::string uncovers;                     ///< the selection to uncover; empty: none
    Uncovered uncovered;
    std::vector<Legend> legends;
    std::vector<std::string> warnings;  ///< of the file and of the rules
    double loadMs = 0;                  ///< reading, inflating, bonds
    double sceneMs = 0;                 ///< selecting atoms, building the streams
    double firstPictureMs = 0;          ///< from the command's start to the first picture in memory
    DriverFeedback driver;              ///< after the picture
    std::vector<Decision> choice;       ///< how the picture's first frame was drawn, and why
    std::uint64_t parts = 1;            ///< number of parts that the picture was drawn in
    double totalMs = 0;                 ///< from the command's start until only this file is left to write
};

}  // namespace nacre::app
