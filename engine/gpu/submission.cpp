#include "engine/gpu/submission.h"

#include "engine/error.h"

namespace nacre::gpu {

Submission::Submission(const Device& device, const std::string& name)
    : device_(device),
      commands_(*device, device.queueFamily()),
      fence_(*device, vk::FenceCreateInfo()),
      descriptors_(device),
      timer_(device) {
    device.name(commands_.pool(), name);
    device.name(*fence_, name + " is done");
}

Submission::~Submission() {
    if (pending_) device_.settle();
}

void Submission::begin() {
    descriptors_.reset();
    device_.log().begin();
    commands_.reset();
    commands_.begin();
}

void Submission::end() {
    commands_.end();
    device_->resetFences(*fence_);
    const auto handles = commands_.handles();
    device_.submit(vk::SubmitInfo({}, {}, handles), *fence_);
    pending_ = true;
}

bool Submission::done() {
    if (pending_ && fence_.getStatus() == vk::Result::eSuccess) pending_ = false;
    return !pending_;
}

void Submission::wait() {
    if (pending_ && device_->waitForFences(*fence_, true, UINT64_MAX) != vk::Result::eSuccess)
        throw Error("the device stopped", device_.caps().deviceName, "waiting for a submission failed");
    pending_ = false;
}

}  // namespace nacre::gpu
