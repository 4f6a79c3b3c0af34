#include "app/viewer/picture_words.h"

#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "engine/error.h"

namespace nacre::app {
bool PictureWords::place(double now) {
    if (!stage_.shown()) return true;
    stage_.schedule.overlayChanged();
    try {
        placed_ = stage_.document.drawing.placeWords(stage_.view().words, WordsOfHidden::leftOut);
    } catch (const Error& error) {
        stage_.messages.say(error.what(), now);
        return false;
    }
    const std::vector<std::string>& leftOut = placed_.leftOut;
    if (leftOut.empty()) return true;
    const std::string more = leftOut.size() > 1 ? " and " + std::to_string(leftOut.size() - 1) + " more" : "";
    stage_.messages.say("Hidden, because its atoms are not drawn: " + leftOut.front() + more, now);
    return true;
}

double PictureWords::size() const {
    const double own = stage_.view().words.size;
    return (own > 0 ? own : kWordPoints * textScale_) * frames_.pixelsPerPoint();
}

std::string originText(const FileSummary& file) {
    std::string text = file.method;
    if (file.resolution) text += (text.empty() ? "" : ", ") + numberText(*file.resolution) + " Å";
    if (file.organism.empty()) return text;
    return file.organism + (text.empty() ? "" : ". " + text);
}

}  // namespace nacre::app
