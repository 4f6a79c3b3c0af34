#include "app/cli/batch_lines.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "engine/error.h"

namespace nacre::app {

BatchLines::BatchLines(const std::string& path, std::function<bool()> stopped)
    : path_(path), stopped_(std::move(stopped)) {
    if (path != "-") file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe is waited for below
    if (file_ < 0) throw Error("cannot read jobs", path, std::strerror(errno));
    struct stat status {};
    const bool known = fstat(file_, &status) == 0;
    isFile_ = path != "-" && known && S_ISREG(status.st_mode);
    if (!known || !S_ISDIR(status.st_mode)) return;
    if (file_ > 0) close(file_);
    throw Error("cannot read jobs", path, "it is a folder");
}

BatchLines::~BatchLines() {
    if (file_ > 0) close(file_);
}

std::optional<BatchLine> BatchLines::next() {
    const std::lock_guard lock(turn_);
    for (std::string text; readLine(text);)
        if (text.find_first_not_of(" \t\r") != std::string::npos) return BatchLine{number_, std::move(text)};
    return std::nullopt;
}

bool BatchLines::readLine(std::string& text) {
    text.clear();
    ++number_;
    for (;;) {
        if (at_ == buffer_.size() && !fill()) return !text.empty();
        const std::size_t end = std::min(buffer_.find('\n', at_), buffer_.size());
        if (text.size() + end - at_ > kLongestLine)
            throw Error("cannot read jobs", path_, "a line has more than 1 MB", number_);
        text.append(buffer_, at_, end - at_);
        at_ = end;
        if (at_ == buffer_.size()) continue;
        ++at_;
        return true;
    }
}

/// Reads more. Polls a slow pipe, since a signal does not wake every thread. @returns whether there is more @throws
/// Error
bool BatchLines::fill() {
    constexpr int kLook = 100;  // milliseconds
    buffer_.resize(1 << 16);
    at_ = 0;
    ssize_t got = 0;
    while (!stopped_()) {
        pollfd ready{file_, POLLIN, 0};
        if (poll(&ready, 1, kLook) == 0) continue;
        got = read(file_, buffer_.data(), buffer_.size());
        if (got >= 0 || (errno != EINTR && errno != EAGAIN)) break;
        got = 0;  // nothing yet; nothing at all, if it is stopped now
    }
    const int why = errno;
    buffer_.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0) throw Error("cannot read jobs", path_, std::strerror(why));
    return got > 0;
}

}  // namespace nacre::app
