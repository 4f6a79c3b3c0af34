#pragma once

#include <string>

#include "engine/gpu/device.h"

namespace nacre::gpu {

/// Turns failures of Vulkan into words, and remembers a loss of the device.
class LossGuard {
public:
    explicit LossGuard(const Device& device) : device_(device) {}

    /// @throws Error what the call throws, in words
    template <typename Call>
    auto operator()(Call&& call) {
        try {
            return call();
        } catch (const vk::SystemError& failure) {
            throw told(failure);
        }
    }
    bool lost() const { return !loss_.empty(); }
    /// What is known of the loss, in one line; empty: the device is there.
    const std::string& loss() const { return loss_; }

private:
    Error told(const vk::SystemError& failure) {
        Error error = device_.errorOf(failure);
        if (failure.code() == vk::make_error_code(vk::Result::eErrorDeviceLost)) loss_ = error.what();
        return error;
    }

    const Device& device_;
    std::string loss_;
};

}  // namespace nacre::gpu
