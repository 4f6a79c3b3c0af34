// What was seen before: each act of the user is a step, a drag from its beginning to its end.

#include "app/viewer/viewer.h"

namespace nacre::app {

/// Called before whatever changes what is seen: what stood until now becomes a step. A flight counts as arrived.
void Viewer::remember() {
    if (!document()) return;
    SavedView now = view();
    now.camera = motion_.destination();
    history_.add(now);
    unremembered_ = true;
}

bool Viewer::unrememberedChange() const {
    if (!unremembered_) return false;
    SavedView now = view();
    now.camera = motion_.destination();
    return history_.differs(now);
}

bool Viewer::canUndo() const { return document() && (history_.canUndo() || unrememberedChange()); }
bool Viewer::canRedo() const { return document() && history_.canRedo() && !unrememberedChange(); }

void Viewer::undo(double now) {
    if (!document()) return;
    if (unremembered_) remember();
    if (!history_.canUndo()) return say("nothing to undo", now);
    restore(history_.undo(), now);
}

void Viewer::redo(double now) {
    if (!document()) return;
    if (unremembered_) remember();
    if (!history_.canRedo()) return say("nothing to redo", now);
    restore(history_.redo(), now);
}

void Viewer::show(const SavedView& to, double now, double seconds) {
    remember();
    restore(to, now, seconds);
    unremembered_ = true;
}

void Viewer::restore(const SavedView& to, double now, double seconds) {
    const SavedView before = view();
    // What is shown may still be something else than what was asked for before.
    const SavedView& there = document_.view;
    const bool file = !document() || to.input != there.input || to.format != there.format || to.name != there.name ||
                      to.further != there.further || to.fits != there.fits ||
                      to.trajectory.path != there.trajectory.path;
    const bool frame = !file && document_.moves() && to.look.assembly == there.look.assembly;  // the player has it
    const bool another = file || (!frame && to.model != there.model);
    Camera camera = motion_.camera();
    view_ = to;
    camera.projection = to.camera.projection;
    camera.fovDegrees = to.camera.fovDegrees;
    motion_.set(camera);
    motion_.fly(to.camera, now, seconds);
    playback_.stop();
    clipped_ = false;
    unremembered_ = false;
    dismissFailure();
    restoring_ = another;
    if (another)
        loader_.read(to);
    else if (to.look != before.look || to.drawn != before.drawn || to.uncover != before.uncover || loader_.busy())
        loader_.build(to, document_);
    if (!another) putWords(now);
    if (frame) {
        setLaying(to.trajectory);
        const std::int64_t number = hasTrajectory() ? to.trajectory.frame : to.model;
        playback_.goTo(
            std::min(static_cast<std::size_t>(std::max<std::int64_t>(number, 1) - 1), playback_.frames() - 1));
        player_->want(playback_.frame());
    }
    if (to.occlusionDirections != before.occlusionDirections) occlusion_ = to.occlusionDirections ? 0 : 1;
    changed(now);
}

}  // namespace nacre::app
