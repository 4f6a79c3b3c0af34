#include "engine/gpu/pipeline_worker.h"

#include <algorithm>

#include "engine/threads.h"

namespace nacre::gpu {

PipelineWorker::~PipelineWorker() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

namespace {

bool same(const PipelineDescription& a, const PipelineDescription& b) {
    if (const auto* graphics = std::get_if<GraphicsPipeline>(&a))
        return std::holds_alternative<GraphicsPipeline>(b) && samePipeline(*graphics, std::get<GraphicsPipeline>(b));
    return std::holds_alternative<ComputePipeline>(b) &&
           samePipeline(std::get<ComputePipeline>(a), std::get<ComputePipeline>(b));
}

}  // namespace

std::list<PipelineWorker::Wanted>::iterator PipelineWorker::find(const PipelineDescription& description) {
    return std::ranges::find_if(wanted_, [&](const Wanted& w) { return same(w.description, description); });
}

void PipelineWorker::want(const PipelineDescription& description) {
    {
        const std::lock_guard lock(mutex_);
        if (find(description) != wanted_.end()) return;
        Wanted& w = wanted_.emplace_back();
        w.description = description;
        // Names belong to the caller and may be gone when the worker runs.
        std::visit([&](auto& d) { w.name = d.name, d.name = w.name; }, w.description);
        if (auto* d = std::get_if<GraphicsPipeline>(&w.description)) w.detail = d->detail, d->detail = w.detail;
    }
    changed_.notify_all();
    if (thread_.joinable() || mayStart(thread_, [this] { run(); })) return;
    const std::lock_guard lock(mutex_);
    wanted_.clear();  // the frames that need them make them
}

std::optional<vk::raii::Pipeline> PipelineWorker::take(const PipelineDescription& description) {
    std::unique_lock lock(mutex_);
    const auto it = find(description);
    if (it == wanted_.end()) return std::nullopt;
    changed_.wait(lock, [&] { return it->state != State::beingMade; });
    std::optional<vk::raii::Pipeline> pipeline;
    if (it->state == State::made) pipeline = std::move(it->pipeline);
    wanted_.erase(it);
    return pipeline;
}

bool PipelineWorker::busy() const {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(wanted_,
                               [](const Wanted& w) { return w.state == State::waits || w.state == State::beingMade; });
}

void PipelineWorker::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        const auto next = [&] {
            return std::ranges::find_if(wanted_, [](const Wanted& w) { return w.state == State::waits; });
        };
        changed_.wait(lock, [&] { return ends_ || next() != wanted_.end(); });
        if (ends_) return;
        Wanted& w = *next();
        w.state = State::beingMade;
        lock.unlock();
        State state = State::failed;  // on failure the frame makes it again and reports the error
        try {
            w.pipeline = std::visit([&](const auto& d) { return makePipeline(device_, d); }, w.description);
            state = State::made;
        } catch (const std::exception&) {
        }
        lock.lock();
        w.state = state;
        changed_.notify_all();
    }
}

}  // namespace nacre::gpu
