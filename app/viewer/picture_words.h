#pragma once
// Labels, measurements, legend and the like: where they stand in the document, and pictures that have them.

#include "app/annotation/placed_words.h"
#include "app/viewer/frames.h"

namespace nacre::app {

/// Points of the words in a window, and of an em of the panel's font of 15 points.
constexpr double kWordPoints = 15 / 1.164;

class PictureWords {
public:
    PictureWords(Stage& stage, const Frames& frames) : stage_(stage), frames_(frames) {}

    const PlacedWords& placed() const { return placed_; }
    /// Finds the places of the view's words. @returns whether all of them have one; what has none is said
    bool place(double now);
    /// The same where atoms have moved.
    void follow(double now) {
        const Words& words = stage_.view().words;
        if (!words.labels.empty() || !words.measures.empty()) place(now);
    }
    /// Pixels of an em of them in the window.
    double size() const;
    /// What a picture that they are painted on is drawn with: the molecule stands beside them, as `nacre render --view`
    /// has it, where it is seen whole. @param textSize  pixels of an em
    RenderSettings settingsBeside(PixelSize size, double textSize) const;
    /// Onto a picture that was drawn so. Only if Stage::shown().
    /// @param saved  whose words  @param size  pixels of an em  @param transparent  the picture has no background
    void paint(const PictureDescription& saved, const View& view, double size, bool transparent,
               Picture& picture) const;

private:
    Stage& stage_;
    const Frames& frames_;
    PlacedWords placed_;
};

}  // namespace nacre::app
