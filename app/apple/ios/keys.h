#pragma once

#import <UIKit/UIKit.h>

#include <optional>

#include "app/viewer/commands.h"

NS_ASSUME_NONNULL_BEGIN

namespace nacre::app {

/// What a key of a hardware keyboard asks for, by the table that every shell shares.
std::optional<ViewerCommand> commandOfKey(UIKey* key);

}  // namespace nacre::app

NS_ASSUME_NONNULL_END
