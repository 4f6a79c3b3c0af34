#pragma once

#include <string>

#include "engine/gpu/device.h"

namespace nacre::gpu {

/// Turns Vulkan failures into error messages, and remembers a device loss.
class LossGuard {
public:
    explicit LossGuard(const Device& device) : device_(device) {}

    /// @throws Error for the call's failure
    template <typename Call>
    auto operator()(Call&& call) {
        try {
            return call();
        } catch (const vk::SystemError& failure) {
            throw told(failure);
        }
    }
    bool lost() const { return !loss_.empty(); }
    /// Description of the loss, in one line; empty: the device is not lost.
    const std::string& loss() const { return loss_; }

private:
    Error told(const vk::SystemError& failure) {
        Error error = device_.makeError(failure);
        if (failure.code() == vk::make_error_code(vk::Result::eErrorDeviceLost)) loss_ = error.what();
        return error;
    }

    const Device& device_;
    std::string loss_;
};

}  // namespace nacre::gpu
