#pragma once
// Recently opened files, with a small picture each. Ignores a list that cannot be read, and failures to write it.

#include <string>
#include <vector>

#include "app/panel/panel.h"
#include "engine/results.h"

namespace nacre::app {

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
