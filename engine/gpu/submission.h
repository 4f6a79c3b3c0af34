#pragma once

#include <string>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/timer.h"

namespace nacre::gpu {

/// Commands that the host does not wait for: one submission at a time. What they use lives until they are done.
class Submission {
public:
    Submission(const Device& device, const std::string& name);
    ~Submission();
    Submission(const Submission&) = delete;

    /// Records by the given function and submits. Nothing is pending before, nor if any of that fails.
    template <typename RecordCommands>
    void submit(RecordCommands&& record) {
        begin();
        record(commands_);
        end();
    }
    /// It was submitted, and nobody has found it done yet.
    bool pending() const { return pending_; }
    /// Whether nothing is in flight, or no longer.
    bool done();
    /// Until nothing is.
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
