#pragma once

#include <string>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/timer.h"

namespace nacre::gpu {

/// A submission that the host does not wait for, one at a time. Keeps its resources until it is done.
class Submission {
public:
    Submission(const Device& device, const std::string& name);
    ~Submission();
    Submission(const Submission&) = delete;

    /// Records by the given function and submits. Nothing may be pending, and nothing is after a failure.
    template <typename RecordCommands>
    void submit(RecordCommands&& record) {
        begin();
        record(commands_);
        end();
    }
    /// Whether a submission may still be running.
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
