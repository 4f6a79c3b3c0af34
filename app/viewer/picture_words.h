#pragma once
// Labels, measurements, legend and so on in a window. Also an explanation of a picture in words: its molecule, style
// and colours.

#include <string>

#include "app/annotation/placed_words.h"
#include "app/picture/description.h"
#include "app/viewer/frames.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {

/// Em size of words in a window, points: that of the panel's font of 15 points.
constexpr double kWordPoints = 15 / 1.164;

class PictureWords {
public:
    PictureWords(Stage& stage, const Frames& frames) : stage_(stage), frames_(frames) {}

    const PlacedWords& placed() const { return placed_; }
    /// Finds the positions of the view's words. @returns whether all were found; reports the others
    bool place(double now);
    /// As above after atoms moved.
    void follow(double now) {
        const Words& words = stage_.view().words;
        if (!words.labels.empty() || !words.measures.empty()) place(now);
    }
    /// Em size in the window, pixels.
    double size() const;
    /// Sets the scale of the window's text. @param percent  100: the default
    void setTextPercent(int percent) { textScale_ = percent / 100.0; }

private:
    Stage& stage_;
    const Frames& frames_;
    PlacedWords placed_;
    double textScale_ = 1;
};

/// "Homo sapiens. X-ray diffraction, 1.9 Å", from the file; empty: not stated.
std::string originText(const FileSummary& file);

}  // namespace nacre::app
