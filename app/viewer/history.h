#pragma once
// What was seen before, and what was taken back. A view is compared by what a file of it would say.

#include <string>
#include <vector>

#include "app/picture/saved_view.h"

namespace nacre::app {

class History {
public:
    static constexpr std::size_t kMost = 200;  ///< views

    /// Forgets everything but a view.
    void begin(const SavedView& view);
    /// Adds a view, unless it is the one that is there; what was taken back is forgotten then.
    void add(const SavedView& view);
    bool canUndo() const { return at_ > 0; }
    bool canRedo() const { return at_ + 1 < views_.size(); }
    bool empty() const { return views_.empty(); }
    /// Whether a view is other than the one that is there.
    bool differs(const SavedView& view) const;
    /// The view before; only if canUndo(). Good until the next call.
    const SavedView& undo() { return views_[--at_].view; }
    const SavedView& redo() { return views_[++at_].view; }

private:
    struct Entry {
        SavedView view;
        std::string text;
    };
    std::vector<Entry> views_;
    std::size_t at_ = 0;
};

}  // namespace nacre::app
