#pragma once
// What a saved view names as its molecule. Someone else may have written the view: it must not fetch, nor have read,
// what its user does not know of.

#include <string>
#include <vector>

#include "app/picture/input_options.h"

namespace nacre::app {

/// The file that INPUT names; "-" and samples and downloads as they are. A path that a view names starts from the
/// view's folder. If nothing is there, and the view states the file's hash, it is the file beside the view that has
/// it, by whatever name.
std::string filePathOf(const InputOptions& input);

/// A path as a view of this name states it: from its folder on, if it leads into it, so that both can move together.
std::string pathInView(const std::string& view, const std::string& path);

/// What a file's content is known by: its length in bytes and its XXH3, "49842-1f0c...". Empty for what is no plain
/// file or cannot be read.
std::string fileHash(const std::string& path);

/// The same of a trajectory, of which no more than the first and the last 16 MiB are read.
std::string trajectoryHash(const std::string& path);

/// Where the trajectory is that INPUT moves by, as filePathOf(); where the view states no hash, one of its name beside
/// the view will do.
std::string trajectoryPathOf(const InputOptions& input);

/// What to say before a trajectory is opened that a view names: it is not in the view's folder, or has changed.
/// @param path  as trajectoryPathOf() has it
std::vector<std::string> trajectoryNotices(const TrajectoryOptions& trajectory);

/// What to say before a file that a view names outside of its own folder is opened; otherwise empty.
std::string outsideNotice(const InputOptions& input);

}  // namespace nacre::app
