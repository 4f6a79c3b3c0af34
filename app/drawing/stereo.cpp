#include "app/drawing/stereo.h"

#include <algorithm>
#include <limits>

#include "app/drawing/scenes.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

using Mode = Stereo::Mode;

/// Copies one eye's pixels to their place in the whole.
template <typename T>
void place(const Stereo& stereo, const std::vector<T>& from, std::uint32_t width, std::uint32_t height, bool second,
           std::size_t channels, std::uint32_t wholeWidth, std::vector<T>& to) {
    const std::size_t left = stereo.beside() && second ? width : 0;
    const std::size_t top = stereo.mode == Mode::topBottom && second ? height : 0;
    for (std::size_t row = 0; row < height; ++row)
        std::copy_n(from.data() + channels * row * width, channels * width,
                    to.data() + channels * ((top + row) * wholeWidth + left));
}

/// Index, into left and right, of the picture on the left or on top.
std::size_t firstEye(const Stereo& stereo) { return stereo.mode == Mode::crossEyed ? 1 : 0; }

Picture anaglyph(const Picture& left, const Picture& right) {
    Picture both = left;
    for (std::size_t i = 0; i < both.rgba.size(); i += 4) {
        const float* l = &left.rgba[i];
        const float* r = &right.rgba[i];
        float* out = &both.rgba[i];
        const float alpha = std::max(l[3], r[3]);
        for (std::size_t c = 0; c < 3; ++c) {
            float sum = 0;
            for (std::size_t k = 0; k < 3; ++k) sum += kAnaglyphLeft[c][k] * l[k] + kAnaglyphRight[c][k] * r[k];
            out[c] = std::clamp(sum, 0.0f, alpha);
        }
        out[3] = alpha;
    }
    return both;
}

}  // namespace

Stereo placed(Stereo stereo, const View& view) {
    if (!stereo.screenDistance) stereo.screenDistance = view.eyeDistance;
    if (!stereo.eyeDistance) stereo.eyeDistance = Stereo::kUsualShare * *stereo.screenDistance;
    return stereo;
}

View eyeView(const View& view, const Stereo& stereo, Eye eye) {
    const Stereo there = placed(stereo, view);
    return fromAside(view, (eye == Eye::left ? -0.5 : 0.5) * *there.eyeDistance, *there.screenDistance);
}

View oneEyeView(const View& view, const Stereo& stereo) {
    if (!stereo.on() || stereo.both()) return view;
    return eyeView(view, stereo, stereo.mode == Stereo::Mode::left ? Eye::left : Eye::right);
}

View eyesView(const View& view, const Stereo& stereo) {
    return paired(eyeView(view, stereo, Eye::left), eyeView(view, stereo, Eye::right));
}

Camera cameraFor(const Stereo& stereo, Camera camera) {
    if (stereo.on()) camera.projection = Projection::perspective;
    return camera;
}

RenderSettings settingsOfEyes(const PictureDescription& picture, Camera camera, double radius) {
    const Stereo& stereo = picture.stereo;
    RenderSettings settings =
        makeSettings(picture, cameraFor(stereo, std::move(camera)), eyeSize(stereo, picture.size), radius);
    settings.view = stereo.both() ? eyesView(settings.view, stereo) : oneEyeView(settings.view, stereo);
    return settings;
}

Picture joinEyes(const Stereo& stereo, const Size& size, const std::array<Picture, 2>& eyes) {
    if (stereo.mode == Mode::anaglyph) return anaglyph(eyes[0], eyes[1]);
    Picture whole{size.width, size.height, std::vector<float>(std::size_t{4} * size.width * size.height)};
    for (const bool second : {false, true}) {
        const Picture& eye = eyes[firstEye(stereo) ^ (second ? 1 : 0)];
        place(stereo, eye.rgba, eye.width, eye.height, second, 4, size.width, whole.rgba);
    }
    return whole;
}

LayerPicture joinEyes(const Stereo& stereo, const Size& size, const std::array<LayerPicture, 2>& eyes) {
    if (stereo.mode == Mode::anaglyph)
        throw Error("cannot write layers", "--stereo anaglyph", "each pixel shows two atoms");
    const std::size_t pixels = std::size_t{size.width} * size.height;
    LayerPicture whole{size.width,
                       size.height,
                       std::vector<float>(4 * pixels),
                       std::vector<float>(pixels, std::numeric_limits<float>::infinity()),
                       std::vector<float>(3 * pixels),
                       std::vector<float>(pixels, 1),
                       std::vector<std::uint32_t>(pixels)};
    for (const bool second : {false, true}) {
        const LayerPicture& eye = eyes[firstEye(stereo) ^ (second ? 1 : 0)];
        const auto put = [&](const auto& from, std::size_t channels, auto& to) {
            place(stereo, from, eye.width, eye.height, second, channels, size.width, to);
        };
        put(eye.rgba, 4, whole.rgba);
        put(eye.z, 1, whole.z);
        put(eye.normal, 3, whole.normal);
        put(eye.occlusion, 1, whole.occlusion);
        put(eye.id, 1, whole.id);
    }
    return whole;
}

}  // namespace nacre::app
