#include "app/viewer/loader.h"

#include <algorithm>
#include <utility>

#include "app/drawing/scenes.h"
#include "app/input/read_input.h"
#include "app/picture/options.h"
#include "app/viewer/presets.h"
#include "engine/error.h"

namespace nacre::app {

void Loader::start(Job job) {
    if (running_.valid())
        next_ = std::move(job);  // instead of whatever else was waiting
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
    std::promise<Document> promise;
    running_ = promise.get_future();
    thread_ = std::thread([this, job = std::move(job), promise = std::move(promise)]() mutable {
        try {
            promise.set_value(load(job));
        } catch (...) {
            promise.set_exception(std::current_exception());
        }
        if (wake_) wake_();
    });
}

Document Loader::load(const Job& job) const {
    Document document{job.view, job.molecule, {}, job.placed};
    if (!document.molecule) {
        const auto molecule = std::make_shared<Molecule>(sources_.read(job.view));
        document.placed = document.molecule = molecule;
        if (sources_.motion) document.motion = sources_.motion(molecule, job.view);
        // The file of the names may have the atoms elsewhere: the camera goes by where the first frame has them.
        if (document.motion && !job.view.input.trajectory.path.empty())
            movePositions(*molecule, document.motion->positions(0));
    }
    if (job.first) firstLook(*document.molecule, document.view);
    if (sources_.maps) sources_.maps(document.view);
    if (job.shown) {
        document.scene = job.shown->scene;
        document.radius = document.scene.radius;
    } else {
        build(document, job.moves || document.motion);
    }
    document.maps =
        mapLayersOf(*document.molecule, document.view, document.scene.center, {document.view.camera, document.radius});
    document.radius = std::max(document.radius, document.maps.frame);
    if (job.first) takeSceneLook(*document.molecule, document.radius, document.view);
    return document;
}

/// A slider of a level must not wait for unchanged parts, wherever the camera is meanwhile. A moving scene is rebuilt.
std::shared_ptr<const Document> Loader::mapsAlone(const PictureDescription& view, const Document& shown) {
    constexpr Facets kMolecule = Facet::input | Facet::frame | Facet::scene;
    const Facets parts = difference(shown.view, view);
    const bool other = (parts & kMolecule) != 0 || shown.view.aim.uncover != view.aim.uncover ||
                       (!view.look.style && shown.view.look.usual != view.look.usual);
    const bool focused = view.maps.aroundFocus && has(parts, Facet::view);
    if (shown.moves() || other || !(has(parts, Facet::map) || focused)) return nullptr;
    return std::make_shared<const Document>(shown);
}

/// Copies of an assembly do not move.
void Loader::build(Document& document, bool moves) const {
    const PictureDescription& view = document.view;
    if (!moves || !view.look.assembly.empty()) {
        document.scene = sources_.build(*document.molecule, view);
        document.placed = document.molecule;
        document.radius = document.scene.radius;
        return;
    }
    document.moving =
        std::make_shared<MovingScene>(movingSceneOf(*document.molecule, view.input.path, view.drawn, view.look));
    document.radius = document.moving->scene().radius;
    if (document.placed != document.molecule) document.moving->move(*document.placed);
    document.scene = document.moving->scene();
    document.recolor.emplace(view);
    (*document.recolor)(document.scene);
    uncoverIn(document.scene, *document.placed, view);
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
    std::promise<Document> again;  // the document, if there was no error, is put back
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
