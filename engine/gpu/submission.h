#pragma once

#include <string>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/timer.h"

namespace nacre::gpu {

/// Commands that the host does not wait for: one submission at a time. Keeps its resources until they are done.
class Submission {
public:
    Submission(const Device& device, const std::string& name);
    ~Submission();
    Submission(const Submission&) = delete;

    /// Records by the given function and submits. Nothing may be pending. After a failure nothing is.
    template <typename RecordCommands>
    void submit(RecordCommands&& record) {
        begin();
        record(commands_);
        end();
    }
    /// Submitted and not yet known to be done.
    bool pending() const { return pending_; }
    /// Whether nothing is in flight.
    bool done();
    /// Waits until nothing is in flight.
    void wait();

    DescriptorPool& descriptors() { return descriptors_; }
    Timer& timer() { return timer_; }

private:
    void begin();
    void end();

    const Device& device_;
    CommandBuffer commands_;
    vk::raii::Fence fence_;
    DescriptorPool descriptors_;
    Timer timer_;
    bool pending_ = false;
};

}  // namespace nacre::gpu
