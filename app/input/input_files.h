#pragma once
// The molecule that a saved view names. The view may be untrusted: it must not download or read anything without its
// user's knowledge.

#include <string>
#include <vector>

#include "app/picture/description.h"

namespace nacre::app {

/// The file of INPUT; "-", samples and downloads unchanged. A view's path is relative to the view's folder. If it does
/// not exist and the view states its hash, it is the file beside the view with that hash, whatever its name.
std::string resolveInputPath(const InputOptions& input);

/// The path that opens the file of INPUT: that of the open file, if there is one, else resolveInputPath().
std::string openedPath(const InputOptions& input);

/// A path for a saved view: relative to the view's folder if it is inside, so that both can move together.
std::string pathInView(const std::string& view, const std::string& path);

/// Identifies a file's content: its length in bytes and its XXH3, "49842-1f0c...". Empty for anything but a readable
/// regular file.
std::string fileHash(const std::string& path);

/// As above for a trajectory, from its first and last 16 MiB only.
std::string trajectoryHash(const std::string& path);

/// The picture as saved in a view at a path: file paths relative to the view, with their hashes.
PictureDescription withPathsIn(const std::string& view, PictureDescription picture);

/// The trajectory of INPUT, found as in resolveInputPath(); without a hash, a file of the same name next to the view is
/// enough.
std::string resolveTrajectoryPath(const InputOptions& input);

/// Notices before a view's trajectory is opened: it is outside the view's folder, or has changed.
/// @param path  from resolveTrajectoryPath()
std::vector<std::string> trajectoryNotices(const TrajectoryOptions& trajectory);

/// Notice before a view's file outside its folder is opened; otherwise empty.
std::string outsideNotice(const InputOptions& input);

}  // namespace nacre::app
