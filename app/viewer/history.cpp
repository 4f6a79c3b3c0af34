#include "app/viewer/history.h"

#include <utility>

namespace nacre::app {

void History::begin(const SavedView& view) {
    views_.clear();
    views_.push_back({view, savedViewJson(view)});
    at_ = 0;
}

bool History::differs(const SavedView& view) const { return views_.empty() || savedViewJson(view) != views_[at_].text; }

void History::add(const SavedView& view) {
    if (views_.empty()) return begin(view);
    std::string text = savedViewJson(view);
    if (text == views_[at_].text) return;
    views_.resize(at_ + 1);
    views_.push_back({view, std::move(text)});
    if (views_.size() > kMost) views_.erase(views_.begin());
    at_ = views_.size() - 1;
}

}  // namespace nacre::app
