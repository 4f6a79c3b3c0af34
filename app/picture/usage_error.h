#pragma once

#include <stdexcept>

namespace nacre::app {

/// Options were used wrongly; what() explains it in one line.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace nacre::app
