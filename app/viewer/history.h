#pragma once
// What was seen before, and what was taken back: each act of the user is a step, a drag from its beginning to its end.

#include <vector>

#include "app/picture/description.h"

namespace nacre::app {

class History {
public:
    static constexpr std::size_t kMost = 200;  ///< views

    /// Forgets everything but a view.
    void begin(const PictureDescription& view);
    /// Before an act: what is seen until then becomes a step, unless it is the last one; what was taken back is
    /// forgotten then.
    void remember(const PictureDescription& now);
    /// What is seen may be none of the steps: it is one before anything is taken back.
    void acted() { acted_ = true; }
    bool empty() const { return views_.empty(); }
    // Of the view that is seen now
    bool canUndo(const PictureDescription& now) const { return at_ > 0 || isAnother(now); }
    bool canRedo(const PictureDescription& now) const { return at_ + 1 < views_.size() && !isAnother(now); }
    /// The view before, or after; null: there is none. Good until the next call.
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
