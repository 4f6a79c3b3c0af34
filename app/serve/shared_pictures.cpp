#include "app/serve/shared_pictures.h"

namespace nacre::app {

SharedPictures::Shared SharedPictures::get(const std::string& name, const std::function<ServedPicture()>& draw) {
    std::promise<Shared> promise;
    const std::shared_future<Shared> own = promise.get_future().share();
    std::shared_future<Shared> others;
    {
        const std::lock_guard lock(turn_);
        const auto [at, first] = drawn_.try_emplace(name, own);
        if (!first) others = at->second;
    }
    if (others.valid()) return others.get();
    try {
        promise.set_value(std::make_shared<const ServedPicture>(draw()));
    } catch (...) {
        promise.set_exception(std::current_exception());
    }
    {
        const std::lock_guard lock(turn_);
        drawn_.erase(name);
    }
    return own.get();
}

}  // namespace nacre::app
