#pragma once
// Locations of the desktop's last view and compiled pipelines, and names for saved files; and recently opened files,
// with a small picture each. Ignores a list that cannot be read, and failures to write it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/panel/panel.h"
#include "app/picture/saved_view.h"
#include "engine/results.h"

namespace nacre::app {

/// $XDG_STATE_HOME/nacre/view.json, by default ~/.local/state/nacre/view.json
std::optional<PictureDescription> loadState();
void saveState(const PictureDescription& view);

/// $XDG_STATE_HOME/nacre/recent.json, by default ~/.local/state/nacre/recent.json; empty if there is no such folder
std::string recentPath();

/// $XDG_CACHE_HOME/nacre/pipelines.bin, by default ~/.cache/nacre/pipelines.bin
std::vector<std::byte> loadPipelineCache();
void savePipelineCache(const std::vector<std::byte>& data);

/// A name in the current folder that no file has yet: "1bna.png", "1bna-2.png", ...
std::string freeName(const std::string& input, const std::string& extension);

class RecentFiles {
public:
    static constexpr std::size_t kMost = 8;
    static constexpr PixelSize kPicture{65, 44};  ///< pixels: the start screen shows it at twice as many points

    /// @param path  of the list; empty: keep none
    explicit RecentFiles(std::string path);

    const std::vector<RecentFile>& files() const { return files_; }
    /// Moves a file to the front. @param picture  of kPicture pixels; may be empty
    void add(const std::string& input, const std::string& name, const Picture& picture);

private:
    void write() const;

    std::string path_;
    std::vector<RecentFile> files_;
};

}  // namespace nacre::app
