#pragma once
// What was open before, with a small picture of each. A file of the list that cannot be read counts as empty, one that
// cannot be written is not missed.

#include <string>
#include <vector>

#include "app/panel/panel.h"
#include "engine/results.h"

namespace nacre::app {

class RecentFiles {
public:
    static constexpr std::size_t kMost = 8;
    static constexpr PixelSize kPicture{65, 44};  ///< pixels: a start screen shows twice as many points

    /// @param path  of the list; empty: none is kept
    explicit RecentFiles(std::string path);

    const std::vector<RecentFile>& files() const { return files_; }
    /// Puts a file first. @param picture  of kPicture pixels; may be empty
    void add(const std::string& input, const std::string& name, const Picture& picture);

private:
    void write() const;

    std::string path_;
    std::vector<RecentFile> files_;
};

}  // namespace nacre::app
