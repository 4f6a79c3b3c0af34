#pragma once
// The complete description of a picture, as one plain value. Every frontend fills it: command line, batch jobs, Python,
// saved views, looks, the window's panel. options.h lists its options, one row each.

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/picture/aim.h"
#include "app/picture/geometry_options.h"
#include "app/picture/input_options.h"
#include "app/picture/map_options.h"
#include "app/picture/option_values.h"
#include "app/picture/stereo.h"
#include "app/picture/words.h"
#include "engine/debug_view.h"
#include "engine/device_options.h"
#include "engine/effects.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"
#include "engine/settings.h"

namespace nacre::app {

struct OcclusionOptions {
    int directions = 128;                   ///< 0 = off
    std::uint32_t detail = 32;              ///< maximum width of a sphere's patch, texels
    bool bounce = false;                    ///< surfaces send light in their colours to their surroundings
    std::optional<std::int64_t> megabytes;  ///< of 2^20 bytes; default in RenderSettings

    std::uint64_t bytes() const {
        return megabytes ? static_cast<std::uint64_t>(*megabytes) << 20 : RenderSettings{}.occlusion.bytes;
    }
};

struct PictureDescription {
    InputOptions input;
    DrawnAtomsOptions drawn;
    RepresentationOptions look;
    MapOptions maps;
    std::vector<PrimitiveSource> primitives;
    bool cell = false;  ///< the unit cell or periodic box as lines

    /// Whether anything may be drawn in addition to atoms.
    bool drawsBeside() const { return !maps.files.empty() || !primitives.empty() || cell; }
    /// Call after adding or removing maps: density lies inside spheres.
    void mapsChanged() { look.usual = maps.files.empty() ? Style::spacefill : Style::licorice; }

    Camera camera;
    Stereo stereo;
    Aim aim = Aim::standard();
    Words words;
    std::array<float, 4> background{1, 1, 1, 1};  ///< sRGB-coded, straight alpha
    bool lighting = true;
    Effects effects;
    OcclusionOptions occlusion;

    Size size;
    std::optional<Length> width, height;                  ///< override `size`; with one of them, `size` gives the shape
    std::optional<double> dpi;                            ///< dots per inch
    std::optional<ScreenLength> contourWidth, haloWidth;  ///< override pixels
    std::optional<double> textPoints;                     ///< 72 per inch; overrides pixels
    /// As above for lines; and widths of sticks, bonds and tubes, which override radii.
    std::optional<double> linePoints, stickPoints, bondPoints, tubePoints;
    int bits = 8;  ///< per channel of the file
    std::uint32_t supersample = RenderSettings::kEdges;
    double meshError = 0.25;  ///< as RenderSettings::meshError

    FrameTuning tuning;
    DebugView debug = DebugView::none;
    DeviceOptions device;
    std::string output, layers, stats, capture;  ///< paths, or empty
    std::string saveView;                        ///< path of the saved view to write, or empty
    std::string view;                            ///< path of the saved view that it began with, or empty
    std::set<std::string> given;                 ///< keys of options given explicitly, not by a look or view
};

}  // namespace nacre::app
