#pragma once

#import <QuartzCore/CAMetalLayer.h>

#include "engine/device_options.h"

NS_ASSUME_NONNULL_BEGIN

namespace nacre::app {

/// Makes Vulkan draw into a layer, by VK_EXT_metal_surface. The layer outlives the surface.
SurfaceSource makeSurface(CAMetalLayer* layer);

}  // namespace nacre::app

NS_ASSUME_NONNULL_END
