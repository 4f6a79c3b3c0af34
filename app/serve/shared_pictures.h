#pragma once
// One drawing for all requests that ask for the same picture at the same time.

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/serve/workers.h"

namespace nacre::app {

class SharedPictures {
public:
    using Shared = std::shared_ptr<const ServedPicture>;

    /// The picture of this name: of `draw`, or of the thread that draws it now. @throws what that `draw` throws
    Shared get(const std::string& name, const std::function<ServedPicture()>& draw);

private:
    std::mutex turn_;
    std::map<std::string, std::shared_future<Shared>> drawn_;  ///< at the moment
};

}  // namespace nacre::app
