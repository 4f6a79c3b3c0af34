#include "tests/android_host/expected.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "app/download/molecule_sources.h"
#include "app/picture/option_values.h"
#include "engine/renderer.h"
#include "engine/srgb.h"

namespace nacre::test {
namespace {

Renderer& expectingRenderer() {
    static Renderer renderer = [] { return Renderer(DeviceOptions{.visibility = Visibility::fragdepth}); }();
    return renderer;
}

}  // namespace

WindowPicture expectedPicture(const app::PictureDescription& view, std::uint32_t width, std::uint32_t height,
                              std::uint32_t samples) {
    const app::Sources sources = app::phoneSources({});
    const Molecule molecule = sources.read(view);
    app::Drawing drawing(app::CameraBy::hand);
    drawing.build(molecule, view);
    RenderSettings settings = drawing.settingsFor(view, view.camera, {width, height});
    settings.supersample = samples;
    Renderer& renderer = expectingRenderer();
    renderer.setScene(drawing.joinedScene());
    const Picture picture = renderer.render(settings);
    WindowPicture result{width, height, {}};
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) result.rgb.push_back(toByte(linearToSrgb(picture.rgba[i])));
    return result;
}

Difference measureDifference(const WindowPicture& shown, const WindowPicture& expected, Covered covered) {
    if (shown.width != expected.width || shown.height != expected.height) return {1 << 30, 255, 0, 255};
    Difference d;
    for (std::uint32_t y = 0; y < shown.height; ++y)
        for (std::uint32_t x = 0; x < shown.width; ++x) {
            if (x < covered.width && y < covered.height) continue;
            const std::size_t at = std::size_t{3} * (std::size_t{y} * shown.width + x);
            int step = 0;
            bool coloured = false;
            for (std::size_t c = at; c < at + 3; ++c) {
                step = std::max(step, std::abs(shown.rgb[c] - expected.rgb[c]));
                coloured |= shown.rgb[c] < 250;
            }
            d.pixels += step > 1;
            d.largest = std::max(d.largest, step);
            d.coloured += coloured;
            d.mean += step;
        }
    d.mean /= std::max(d.coloured, 1);
    return d;
}

void writePpm(const WindowPicture& picture, const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << picture.width << ' ' << picture.height << "\n255\n";
    file.write(reinterpret_cast<const char*>(picture.rgb.data()), static_cast<std::streamsize>(picture.rgb.size()));
}

}  // namespace nacre::test
