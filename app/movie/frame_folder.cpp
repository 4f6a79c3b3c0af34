// Frames as pictures of their own: frames/frame_00001.png, each as `nacre render` would write it.

#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "app/files/messages.h"
#include "app/images/image_file.h"
#include "app/movie/movie_file.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

std::string frameName(std::uint64_t number) {
    char name[40];
    std::snprintf(name, sizeof name, "frame_%05llu.png", static_cast<unsigned long long>(number));
    return name;
}

class FrameFolder : public MovieFile {
public:
    FrameFolder(const std::string& path, const MovieShape& shape) : folder_(path), shape_(shape) {
        std::error_code error;
        fs::create_directories(folder_, error);
        if (error) throw Error("cannot write folder", path, error.message());
    }

    void add(const Picture& picture) override {
        OutputFile file((folder_ / frameName(++frames_)).string());
        writePicture(file, picture, {shape_.alpha});
    }

    void finish() override {
        const fs::path next = folder_ / frameName(frames_ + 1);
        std::error_code error;
        if (fs::exists(next, error))
            sayWarning(folder_.string() + " holds frames of another movie: " + next.filename().string() +
                       " and maybe more");
    }

private:
    fs::path folder_;
    MovieShape shape_;
    std::uint64_t frames_ = 0;
};

}  // namespace

std::unique_ptr<MovieFile> makeFrameFolder(const std::string& path, const MovieShape& shape) {
    return std::make_unique<FrameFolder>(path, shape);
}

}  // namespace nacre::app
