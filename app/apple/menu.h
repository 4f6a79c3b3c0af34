#pragma once
// What the app's menu offers, for any toolkit to show: all that changes the picture. Made anew each time it is opened,
// so that its marks tell the truth.

#include <functional>
#include <string>
#include <vector>

#include "app/viewer/viewer.h"

namespace nacre::app {

struct MenuItem {
    std::string title;
    std::string symbol = {};  ///< name of an SF Symbol; may be empty
    bool checked = false;
    std::function<void()> choose = {};  ///< empty: a submenu of `children`, which may have none
    std::vector<MenuItem> children = {};
};

/// @param viewer lives longer than the items
/// @param now    what time it is when one is chosen
std::vector<MenuItem> viewMenu(Viewer& viewer, const std::function<double()>& now);

}  // namespace nacre::app
