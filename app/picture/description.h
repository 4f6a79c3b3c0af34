#pragma once
// The description of a picture: one plain value that says everything about it. Every frontend is a way to write it:
// the command line, jobs of a batch, Python, saved views, looks, the window's panel. options.h lists what it consists
// of, one row an option.

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "app/picture/aim.h"
#include "app/picture/input_options.h"
#include "app/picture/option_values.h"
#include "app/picture/words.h"
#include "engine/debug_view.h"
#include "engine/device_options.h"
#include "engine/effects.h"
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

struct PictureDescription {
    InputOptions input;
    DrawnAtomsOptions drawn;
    RepresentationOptions look;
    Camera camera;
    Aim aim;
    Words words;
    std::array<float, 4> background{1, 1, 1, 1};  ///< sRGB-coded, straight alpha
    bool lighting = true;
    Effects effects;
    OcclusionOptions occlusion;

    Size size;
    std::optional<Length> width, height;  ///< prevail over `size`, which says how they relate if only one is there
    std::optional<double> dpi;            ///< dots per inch
    std::optional<double> contourPoints, haloPoints, textPoints;  ///< 72 per inch; prevail over pixels
    int bits = 8;                                                 ///< per channel of the file
    std::uint32_t supersample = RenderSettings::kEdges;
    double meshError = 0.25;  ///< as RenderSettings::meshError

    FrameTuning tuning;
    DebugView debug = DebugView::none;
    DeviceOptions device;
    std::string output, layers, stats, capture;  ///< paths; each may be empty
    std::string view;                            ///< path of the saved view that it began with; empty: none
    std::set<std::string> given;                 ///< keys of the options that were named, not brought by look or view
};

}  // namespace nacre::app
