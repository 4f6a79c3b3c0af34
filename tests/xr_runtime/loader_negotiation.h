#pragma once
// How the loader gets at a runtime, as "OpenXR Loader - Design and Operation" states it. Debian has no header of it.

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

constexpr std::uint32_t XR_CURRENT_LOADER_RUNTIME_VERSION = 1;

struct XrNegotiateLoaderInfo {
    std::int32_t structType;
    std::uint32_t structVersion;
    std::size_t structSize;
    std::uint32_t minInterfaceVersion, maxInterfaceVersion;
    XrVersion minApiVersion, maxApiVersion;
};

struct XrNegotiateRuntimeRequest {
    std::int32_t structType;
    std::uint32_t structVersion;
    std::size_t structSize;
    std::uint32_t runtimeInterfaceVersion;
    XrVersion runtimeApiVersion;
    PFN_xrGetInstanceProcAddr getInstanceProcAddr;
};
