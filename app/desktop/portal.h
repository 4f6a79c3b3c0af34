#pragma once
// The desktop's dialogs by org.freedesktop.portal.FileChooser: what programs in a sandbox have, and what shows the
// dialog of whichever desktop runs.

#include <string>
#include <vector>

namespace nacre::app {

struct PortalAnswer {
    bool there = false;              ///< a portal answered; otherwise another dialog has to do
    std::vector<std::string> paths;  ///< what was chosen; empty: nothing
};

/// Whether the session's bus has a portal, or can start one.
bool hasPortal();
/// Shows the dialog for one file or several and waits until it is closed. A thread that may wait calls it.
PortalAnswer openByPortal(const std::string& title);
/// The same for one file that is to be written. @param suggested  a name, or a path
PortalAnswer saveByPortal(const std::string& title, const std::string& suggested);

/// The path of a "file:" URI, empty for any other.
std::string pathOfUri(const std::string& uri);

}  // namespace nacre::app
