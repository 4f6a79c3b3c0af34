#pragma once
// The desktop's dialogs by org.freedesktop.portal.FileChooser: they work in a sandbox and on every desktop.

#include <string>
#include <vector>

namespace nacre::app {

struct PortalAnswer {
    bool there = false;              ///< a portal answered; otherwise use another dialog
    std::vector<std::string> paths;  ///< chosen paths; empty: none
};

/// Whether the session bus has a portal, or can start one.
bool hasPortal();
/// Shows the dialog for one or several files and blocks until it is closed.
PortalAnswer openByPortal(const std::string& title);
/// As above for a file to be written. @param suggested  a name, or a path
PortalAnswer saveByPortal(const std::string& title, const std::string& suggested);

/// The path of a "file:" URI, empty for any other.
std::string pathOfUri(const std::string& uri);

}  // namespace nacre::app
