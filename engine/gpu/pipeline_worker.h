#pragma once
// Pipelines that are made on a thread of their own before a frame asks for them, so that none waits for a driver that
// compiles: what a zoom is going to want, or the next pass of the same picture.

#include <condition_variable>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>

#include "engine/gpu/pipeline.h"

namespace nacre::gpu {

using PipelineDescription = std::variant<GraphicsPipeline, ComputePipeline>;

class PipelineWorker {
public:
    /// @param device  outlives this, as do layouts and render passes of what is wanted
    explicit PipelineWorker(const Device& device) : device_(device) {}
    /// What is being made is finished first.
    ~PipelineWorker();
    PipelineWorker(const PipelineWorker&) = delete;

    /// To be made, in the order of the calls, unless it is already wanted.
    void want(const PipelineDescription& description);
    /// The pipeline if it was wanted and could be made, once. Waits for one that is being made; one that is not yet
    /// begun is the caller's to make.
    std::optional<vk::raii::Pipeline> take(const PipelineDescription& description);
    /// Whether any that is wanted is still to be made.
    bool busy() const;

private:
    enum class State : std::uint8_t { waits, beingMade, made, failed };
    struct Wanted {
        std::string name, detail;
        PipelineDescription description;
        State state = State::waits;
        vk::raii::Pipeline pipeline{nullptr};
    };
    void run();
    std::list<Wanted>::iterator find(const PipelineDescription& description);

    const Device& device_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::list<Wanted> wanted_;
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace nacre::gpu
