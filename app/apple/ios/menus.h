#pragma once

#import <UIKit/UIKit.h>

#include "app/apple/menu.h"

NS_ASSUME_NONNULL_BEGIN

namespace nacre::app {

/// @param chosen called after what an item does
NSArray<UIMenuElement*>* menuElements(const std::vector<MenuItem>& items, dispatch_block_t chosen);

}  // namespace nacre::app

NS_ASSUME_NONNULL_END
