#include "app/viewer/loader.h"

namespace nacre::app {

void Loader::start(const SavedView& view, std::shared_ptr<const Molecule> molecule) {
    Job job{view, std::move(molecule)};
    if (running_.valid())
        next_ = std::move(job);  // instead of whatever else was waiting
    else
        launch(std::move(job));
}

void Loader::launch(Job job) {
    running_ = std::async(std::launch::async, [this, job = std::move(job)] {
        // Told whether it went well or not; take() never waits for more than this thread's last step.
        struct Waker {
            const std::function<void()>& wake;
            ~Waker() {
                if (wake) wake();
            }
        } waker{wake_};
        Document document{job.view, job.molecule, {}};
        if (!document.molecule) document.molecule = std::make_shared<const Molecule>(sources_.read(job.view));
        document.scene = sources_.build(*document.molecule, job.view);
        return document;
    });
}

void Loader::wait() const {
    if (running_.valid()) running_.wait();
}

std::optional<Document> Loader::take() {
    if (!running_.valid()) return std::nullopt;
    // The waker runs before the future is ready: a short wait bridges the gap.
    if (running_.wait_for(std::chrono::milliseconds(2)) != std::future_status::ready) return std::nullopt;
    std::future<Document> done = std::move(running_);
    if (next_) {
        launch(std::move(*next_));
        next_.reset();
        return std::nullopt;
    }
    return done.get();
}

}  // namespace nacre::app
