#include "app/viewer/history.h"

#include "app/picture/options.h"

namespace nacre::app {

void History::begin(const PictureDescription& view) {
    views_.assign(1, view);
    at_ = 0;
}

bool History::isAnother(const PictureDescription& now) const {
    return acted_ && (views_.empty() || difference(now, views_[at_]) != 0);
}

void History::remember(const PictureDescription& now) {
    acted_ = true;
    if (views_.empty()) return begin(now);
    if (difference(now, views_[at_]) == 0) return;
    views_.resize(at_ + 1);
    views_.push_back(now);
    if (views_.size() > kMost) views_.erase(views_.begin());
    at_ = views_.size() - 1;
}

const PictureDescription* History::go(const PictureDescription& now, int step) {
    if (acted_) remember(now);
    const std::size_t to = at_ + static_cast<std::size_t>(step);  // before the first, the index exceeds all
    if (to >= views_.size()) return nullptr;
    acted_ = false;
    at_ = to;
    return &views_[at_];
}

}  // namespace nacre::app
