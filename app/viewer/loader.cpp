#include "app/viewer/loader.h"

#include <utility>

#include "app/drawing/default_look.h"
#include "app/drawing/map_layers.h"
#include "app/drawing/scenes.h"
#include "app/input/read_input.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/threads.h"

namespace nacre::app {

void Loader::start(Job job) {
    if (running_.valid())
        next_ = std::move(job);  // replaces any waiting job
    else
        launch(std::move(job));
}

Loader::~Loader() {
    cancel();
    if (thread_.joinable()) thread_.join();
}

/// Stores the document before the wake-up, so that it is found.
void Loader::launch(Job job) {
    if (thread_.joinable()) thread_.join();
    last_ = job.view;
    lastFirst_ = job.first;
    const auto task =
        std::make_shared<std::packaged_task<Document()>>([this, job = std::move(job)]() mutable { return load(job); });
    running_ = task->get_future();
    const auto run = [this, task] {
        (*task)();
        if (wake_) wake_();
    };
    if (!mayStart(thread_, run)) run();
}

/// Copies the displayed scene if only maps differ, so that a level's slider does not wait for it. Moving scenes are
/// rebuilt.
void Loader::build(const PictureDescription& view, const Document& shown) {
    Job job{view, shown.molecule, false, shown.placed, shown.moves()};
    const Rebuild rebuild = rebuildFor(shown.drawing.description(), view, CameraBy::hand);
    if (!job.moves && !rebuild.molecule && !rebuild.scene && rebuild.maps) job.shown = shown.drawing.copy();
    if (shown.view.look.assembly == view.look.assembly) job.frame = shown.drawing.frame();
    start(std::move(job));
}

Document Loader::load(Job& job) const {
    Document document{job.view, job.molecule, job.placed, std::move(job.shown)};
    if (!document.molecule) {
        const auto molecule = std::make_shared<Molecule>(sources_.read(job.view));
        document.placed = document.molecule = molecule;
        if (sources_.motion) document.motion = sources_.motion(molecule, job.view);
        // The camera frames the trajectory's first frame, not the positions in the molecule's file.
        if (document.motion && !job.view.input.trajectory.path.empty())
            movePositions(*molecule, document.motion->positions(0));
    }
    if (job.first)
        takeDefaultLook(*document.molecule, drawnAtoms(*document.molecule, document.view.drawn), document.view,
                        document.view.look);
    if (sources_.maps) sources_.maps(document.view);
    if (job.first) lookIntoCrystal(*document.molecule, document.view);
    // Copies of an assembly do not move.
    const bool moves = (job.moves || document.motion) && document.view.look.assembly.empty();
    if (!moves) document.placed = document.molecule;
    if (job.frame) document.drawing.keepFrame(*job.frame);
    if (moves)
        document.drawing.buildMoving(*document.molecule, *document.placed, document.view);
    else
        document.drawing.build(*document.molecule, document.view);
    document.drawing.takeCamera(document.view.camera);
    if (job.first) takeSceneLook(*document.molecule, document.drawing.radius(), document.view);
    return document;
}

void Loader::wait() const {
    if (running_.valid()) running_.wait();
}

std::optional<Document> Loader::take() {
    if (!running_.valid()) return std::nullopt;
    if (running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    std::future<Document> done = std::move(running_);
    const bool cancelled = std::exchange(cancelled_, false);
    if (next_) {
        launch(std::move(*next_));
        next_.reset();
        return std::nullopt;
    }
    if (cancelled) return std::nullopt;
    return done.get();
}

void Loader::throwFailure() {
    if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    std::promise<Document> again;  // holds the document again, if there was no error
    std::future<Document> done = std::move(running_);
    running_ = again.get_future();
    try {
        again.set_value(done.get());
    } catch (const Error&) {
        running_ = {};
        throw;
    } catch (...) {
        again.set_exception(std::current_exception());
    }
}

void Loader::cancel() {
    if (!running_.valid()) return;
    cancelled_ = true;
    next_.reset();
    if (sources_.cancel) sources_.cancel();
}

}  // namespace nacre::app
