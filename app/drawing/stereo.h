#pragma once
// Combines the pictures of two eyes.

#include <array>

#include "app/picture/description.h"
#include "engine/results.h"
#include "engine/scene/view/camera.h"

namespace nacre::app {

enum class Eye { left, right };
constexpr std::array<Eye, 2> kEyes{Eye::left, Eye::right};

/// Fills in distances of a view that are not given.
Stereo placed(Stereo stereo, const View& view);
/// The view of one eye. @param view  in perspective, of a point midway between the eyes
View eyeView(const View& view, const Stereo& stereo, Eye eye);
/// The view of a picture of one eye; for any other picture, the view itself.
View oneEyeView(const View& view, const Stereo& stereo);

/// The left eye's view, with the right one's in View::other. @param view  midway between the eyes
View eyesView(const View& view, const Stereo& stereo);

/// The camera of a picture. Stereo needs perspective; the scale at the picture's centre stays.
Camera cameraFor(const Stereo& stereo, Camera camera);
/// Settings of a picture without a scene, for one eye or both.
RenderSettings settingsOfEyes(const PictureDescription& picture, Camera camera, double radius);

/// Shares of the linear channels of the left and the right picture in the channels of an anaglyph for red and cyan
/// glasses: rows of red, green and blue. E. Dubois, A projection method to generate anaglyph stereo images, Proc. IEEE
/// ICASSP 2001, vol. 3, 1661.
using AnaglyphMatrix = std::array<std::array<float, 3>, 3>;
inline constexpr AnaglyphMatrix kAnaglyphLeft{{{0.456100f, 0.500484f, 0.176381f},
                                               {-0.0400822f, -0.0378246f, -0.0157589f},
                                               {-0.0152161f, -0.0205971f, -0.00546856f}}};
inline constexpr AnaglyphMatrix kAnaglyphRight{
    {{-0.0434706f, -0.0879388f, -0.00155529f}, {0.378476f, 0.73364f, -0.0184503f}, {-0.0721527f, -0.112961f, 1.2264f}}};

/// One picture of both eyes. @param size  of the whole; each has eyeSize() @param eyes  left, right
Picture joinEyes(const Stereo& stereo, const Size& size, const std::array<Picture, 2>& eyes);
/// As above. @throws Error for an anaglyph: its pixels show two atoms
LayerPicture joinEyes(const Stereo& stereo, const Size& size, const std::array<LayerPicture, 2>& eyes);

}  // namespace nacre::app
