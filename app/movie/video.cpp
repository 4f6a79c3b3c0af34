// H.264 in MP4 and VP9 in WebM: feeds raw frames to the program ffmpeg.

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "app/files/output_file.h"
#include "app/movie/movie_file.h"
#include "engine/coded_picture.h"
#include "engine/error.h"

extern "C" char** environ;

namespace nacre::app {
namespace {

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

bool isMp4(const std::string& path) { return fileExtension(path) == ".mp4"; }

std::vector<std::string> makeArguments(const OutputFile& file, const MovieShape& shape, bool alpha) {
    const std::string size = std::to_string(shape.size.width) + "x" + std::to_string(shape.size.height);
    std::vector<std::string> words{
        "ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt",
        alpha ? "rgba" : "rgb24", "-s", size, "-framerate", number(shape.framesPerSecond), "-i", "pipe:0",
        // Colours for video players: BT.709's matrix, code values 16 to 235.
        "-vf", std::string("scale=out_color_matrix=bt709:out_range=tv,format=") + (alpha ? "yuva420p" : "yuv420p"),
        "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv"};
    const auto add = [&](std::initializer_list<const char*> more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    if (isMp4(file.path()))  // beside medium and 16: the same PSNR, 0.4 times the CPU time, 1.05 to 1.26 times the size
        add({"-c:v", "libx264", "-preset", "veryfast", "-crf", "14", "-movflags", "+faststart", "-f", "mp4"});
    else
        add({"-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0", "-cpu-used", "2", "-auto-alt-ref", alpha ? "0" : "1",
             "-f", "webm"});
    add({"-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1"});
    words.push_back(file.temporary());
    return words;
}

class Video : public MovieFile {
public:
    Video(const std::string& path, const MovieShape& shape)
        : file_(path), shape_(shape), alpha_(shape.alpha && !isMp4(path)), complaints_(std::tmpfile()) {
        if (isMp4(path) && (shape.size.width % 2 || shape.size.height % 2))
            throw Error("cannot write file", path,
                        "H.264 takes even numbers of pixels only: --size " +
                            std::to_string(shape.size.width + shape.size.width % 2) + "x" +
                            std::to_string(shape.size.height + shape.size.height % 2));
        if (!complaints_) throw Error("cannot write file", path, std::strerror(errno));
        start();
    }
    ~Video() override {
        if (child_ > 0) {
            kill(child_, SIGKILL);
            wait();
        }
        if (pipe_ >= 0) close(pipe_);
        if (complaints_) std::fclose(complaints_);
    }
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    void add(const Picture& picture) override {
        coded_ = coded(picture, alpha_).bytes;
        for (std::size_t done = 0; done < coded_.size();) {
            const ssize_t n = write(pipe_, coded_.data() + done, coded_.size() - done);
            if (n > 0) done += static_cast<std::size_t>(n);
            if (n < 0 && errno != EINTR) complain(wait());
        }
    }

    void finish() override {
        close(pipe_);
        pipe_ = -1;
        const int status = wait();
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) complain(status);
        file_.commit();
    }

private:
    void start() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error("cannot write file", file_.path(), std::strerror(errno));
        pipe_ = ends[1];
        std::signal(SIGPIPE, SIG_IGN);  // if ffmpeg ends early, writing reports an error
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, fileno(complaints_), STDERR_FILENO);
        // Its own process group: Ctrl-C only reaches nacre, which then finishes the movie.
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t usual;
        sigemptyset(&usual);
        sigaddset(&usual, SIGPIPE);
        posix_spawnattr_setsigdefault(&attributes, &usual);
        posix_spawnattr_setpgroup(&attributes, 0);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
        std::vector<std::string> words = makeArguments(file_, shape_, alpha_);
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        const int failure = posix_spawnp(&child_, "ffmpeg", &actions, &attributes, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
        close(ends[0]);
        if (failure == 0) return;
        child_ = -1;
        throw Error("cannot write file", file_.path(),
                    failure == ENOENT ? "the program ffmpeg, which writes videos, is not installed (Debian: ffmpeg); "
                                        ".gif, .png and folders of frames work without it"
                                      : std::string("ffmpeg: ") + std::strerror(failure));
    }

    int wait() {
        int status = 0;
        while (child_ > 0 && waitpid(child_, &status, 0) < 0 && errno == EINTR) {
        }
        child_ = -1;
        return status;
    }

    /// Throws an error with ffmpeg's last line.
    [[noreturn]] void complain(int status) {
        std::string line, last;
        std::rewind(complaints_);
        for (int c; (c = std::fgetc(complaints_)) != EOF && line.size() < 400;) {
            if (c == '\n' || c == '\r') {
                if (!line.empty()) last = line;
                line.clear();
            } else {
                line.push_back(static_cast<char>(c));
            }
        }
        if (!line.empty()) last = line;
        if (last.empty() && WIFSIGNALED(status)) last = "ended by signal " + std::to_string(WTERMSIG(status));
        throw Error("cannot write file", file_.path(), "ffmpeg: " + (last.empty() ? "it failed" : last));
    }

    OutputFile file_;
    MovieShape shape_;
    bool alpha_;
    std::FILE* complaints_;
    int pipe_ = -1;
    pid_t child_ = -1;
    std::vector<std::uint8_t> coded_;
};

}  // namespace

std::unique_ptr<MovieFile> makeVideo(const std::string& path, const MovieShape& shape) {
    return std::make_unique<Video>(path, shape);
}

}  // namespace nacre::app
