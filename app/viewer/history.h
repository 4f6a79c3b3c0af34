#pragma once
// Undo history of views: each user action is a step, a drag counts once.

#include <vector>

#include "app/picture/description.h"

namespace nacre::app {

class History {
public:
    static constexpr std::size_t kMost = 200;  ///< views

    /// Clears the history except for one view.
    void begin(const PictureDescription& view);
    /// Call before an action: makes the current view a step, unless it is the last one; clears the redo steps.
    void remember(const PictureDescription& now);
    /// The current view may not be a step yet: it becomes one before the next undo.
    void acted() { acted_ = true; }
    bool empty() const { return views_.empty(); }
    // For the current view
    bool canUndo(const PictureDescription& now) const { return at_ > 0 || isAnother(now); }
    bool canRedo(const PictureDescription& now) const { return at_ + 1 < views_.size() && !isAnother(now); }
    /// The previous or next view; null: none. Valid until the next call.
    const PictureDescription* undo(const PictureDescription& now) { return go(now, -1); }
    const PictureDescription* redo(const PictureDescription& now) { return go(now, 1); }

private:
    bool isAnother(const PictureDescription& now) const;
    const PictureDescription* go(const PictureDescription& now, int step);
    std::vector<PictureDescription> views_;
    std::size_t at_ = 0;
    bool acted_ = false;
};

}  // namespace nacre::app
