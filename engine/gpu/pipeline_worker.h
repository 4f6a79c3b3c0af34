#pragma once
// Makes pipelines on a worker thread before a frame asks for them, so that frames do not wait for the driver's
// compiler: for a coming zoom, or the next pass of the same picture.

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
    /// @param device  outlives this, as do layouts and render passes of wanted pipelines
    explicit PipelineWorker(const Device& device) : device_(device) {}
    /// Finishes the pipeline that is being made.
    ~PipelineWorker();
    PipelineWorker(const PipelineWorker&) = delete;

    /// Queues a pipeline, unless it is already queued.
    void want(const PipelineDescription& description);
    /// The pipeline, once, if it was queued and could be made. Waits if it is being made. If it is not begun, returns
    /// nothing and the caller makes it.
    std::optional<vk::raii::Pipeline> take(const PipelineDescription& description);
    /// Whether any queued pipeline is not made yet.
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
