#pragma once
// Locations of the desktop's last view and compiled pipelines, names for saved files, and recently opened files with a
// small picture each. Ignores unreadable lists, and failures to write them.

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

/// State of the window when it was last closed. $XDG_STATE_HOME/nacre/window.json
struct WindowState {
    std::uint32_t width = 0, height = 0;  ///< points; 0: not known
    Panel::Brightness brightness = Panel::Brightness::system;
    bool panelOpen = true, darkCanvas = false;
    int textPercent = 100;
    friend bool operator==(const WindowState&, const WindowState&) = default;
};
WindowState loadWindowState();
void saveWindowState(const WindowState& state);

/// $XDG_STATE_HOME/nacre/recent.json, by default ~/.local/state/nacre/recent.json; empty if there is no such folder
std::string recentPath();

/// $XDG_CACHE_HOME/nacre/samples.json, by default ~/.cache/nacre/samples.json: pictures of the samples
std::string samplesPath();

/// $XDG_CACHE_HOME/nacre/pipelines.bin, by default ~/.cache/nacre/pipelines.bin
std::vector<std::byte> loadPipelineCache();
void savePipelineCache(const std::vector<std::byte>& data);

/// An unused file name: "1bna.png", "1bna-2.png", ... in the current folder, or in the user's if that is not writable.
std::string freeName(const std::string& input, const std::string& extension);
/// "saved /home/me/1bna.png", for any path.
std::string savedMessage(const std::string& path);

class RecentFiles {
public:
    static constexpr std::size_t kMost = 8;
    // Pixels: as many as the start screen's points.
    static constexpr PixelSize kPicture{130, 88}, kBanner{592, 208};

    /// @param path  of the list; empty: keep none
    explicit RecentFiles(std::string path);

    const std::vector<RecentFile>& files() const { return files_; }
    /// Moves a file to the front. @param picture  of kPicture or kBanner pixels; may be empty
    void add(const std::string& input, const std::string& name, const Picture& picture);

private:
    void write() const;

    std::string path_;
    std::vector<RecentFile> files_;
};

}  // namespace nacre::app
