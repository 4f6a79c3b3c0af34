#include "app/cli/batch_lines.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "app/input/input_files.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::size_t kLongestLine = 1 << 20;  // bytes

}  // namespace

const std::string& BatchLine::whole() const {
    if (tooLong) throw UsageError("the line has more than " + std::to_string(kLongestLine >> 20) + " MB");
    return text;
}

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
    for (BatchLine line; readLine(line);)
        if (line.text.find_first_not_of(" \t\r") != std::string::npos) return line;
    return std::nullopt;
}

bool BatchLines::readLine(BatchLine& line) {
    line = {++number_, {}, false};
    for (;;) {
        if (at_ == buffer_.size() && !fill()) return !line.text.empty();
        const std::size_t end = std::min(buffer_.find('\n', at_), buffer_.size());
        const std::size_t room = kLongestLine - line.text.size();
        line.tooLong = line.tooLong || end - at_ > room;
        line.text.append(buffer_, at_, std::min(end - at_, room));
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
        got = 0;  // nothing yet; or nothing at all, if it is stopped now
    }
    const int why = errno;
    buffer_.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0) throw Error("cannot read jobs", path_, std::strerror(why));
    return got > 0;
}

namespace fs = std::filesystem;

namespace {

std::size_t fileKey(const std::string& path) {
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
    return std::hash<std::string>{}(error ? path : place.string());
}

std::vector<std::string> listInputs(const PictureDescription& job) {
    std::vector<std::string> inputs{resolveInputPath(job.input), job.view, resolveTrajectoryPath(job.input)};
    for (const FurtherInput& further : job.input.further)
        inputs.push_back(resolveInputPath(furtherInput(job.input, further)));
    return inputs;
}

/// Whether a non-empty file exists that is not the output of statsJson().
bool isOther(const std::string& path) {
    constexpr std::string_view kBegin = "{\n  \"view\": {\n";
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string begin(kBegin.size(), '\0');
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return file.gcount() > 0 && begin != kBegin;
}

}  // namespace

BatchFiles::BatchFiles(const std::string& jobs) {
    if (jobs != "-") files_.emplace(fileKey(jobs), false);
}

void BatchFiles::claim(const PictureDescription& job) {
    const std::pair<const char*, const std::string&> outputs[] = {
        {"output", job.output}, {"layers", job.layers}, {"stats", job.stats}, {"save_view", job.saveView}};
    if (isOther(job.stats)) throw UsageError("\"stats\": the existing file is not a stats file: " + job.stats);
    const std::lock_guard lock(turn_);
    for (const auto& [name, path] : outputs) {
        const auto known = path.empty() ? files_.end() : files_.find(fileKey(path));
        if (known == files_.end()) continue;
        throw UsageError("\"" + std::string(name) + "\": an earlier job " +
                         (known->second ? "writes the same file: " : "reads this file: ") + path);
    }
    for (const std::string& path : listInputs(job))
        if (!path.empty()) files_.emplace(fileKey(path), false);
    for (const auto& [name, path] : outputs)
        if (!path.empty()) files_.emplace(fileKey(path), true);
}

}  // namespace nacre::app
