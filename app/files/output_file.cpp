#include "app/files/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>

#include "app/files/unnamed_file.h"
#include "engine/error.h"
#include "engine/storage/plain_file.h"

namespace nacre::app {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPrefix = ".nacre-";
constexpr std::size_t kDigits = 16, kHostDigits = 4;
constexpr std::string_view kCapture = "_capture.rdc";  // added by RenderDoc
constexpr std::time_t kAbandonedSeconds = 600;
constexpr const char* kDiskFull = "the data could not be written (is the disk full?)";

[[noreturn]] void fail(const std::string& path, const std::string& why) { throw Error("cannot write file", path, why); }

// Temporary names of open files, for the signal handler: in plain memory, since the handler may call almost nothing.
// More files work, but an interrupted run would leave them behind.
constexpr std::size_t kMostRemembered = 128;
std::array<std::array<char, 4096>, kMostRemembered> unfinished{};
std::mutex unfinishedTurn;  // for writers; the handler only reads

extern "C" void removeUnfinished(int signal) {
    removeUnfinishedFiles();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// ".nacre-0123456789abcdef", and an extension.
bool isTemporaryName(std::string_view name) {
    if (!name.starts_with(kPrefix) || name.size() < kPrefix.size() + kDigits) return false;
    const std::string_view digits = name.substr(kPrefix.size(), kDigits), rest = name.substr(kPrefix.size() + kDigits);
    return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos &&
           (rest.empty() || rest[0] == '.' || rest == kCapture);
}

/// Identifies the machine that writes a file: the first digits of its temporary name.
std::string hostDigits() {
    char name[256] = {}, digits[kHostDigits + 1];
    gethostname(name, sizeof name - 1);
    std::snprintf(digits, sizeof digits, "%04x", static_cast<unsigned>(std::hash<std::string>{}(name)&0xFFFF));
    return digits;
}

/// Whether an unlocked temporary file of ours is abandoned. On the same machine the lock decides; locks of other
/// machines may be invisible, and libraries write without them: there age decides.
bool isAbandoned(const std::string& name, const struct stat& status) {
    const bool here = name.compare(kPrefix.size(), kHostDigits, hostDigits()) == 0 && !name.ends_with(kCapture);
    return here || std::time(nullptr) - status.st_mtime > kAbandonedSeconds;
}

/// Whether a folder is new to this process, so that a run with many files scans it only once.
bool isNew(const std::string& folder) {
    constexpr std::size_t kMost = 4096;
    static std::mutex turn;
    static std::set<std::string> met;
    const std::lock_guard lock(turn);
    if (met.size() == kMost) met.clear();
    return met.insert(folder).second;
}

/// Removes leftovers of ended processes from a folder: old, unlocked files of ours.
void sweep(const std::string& folder) {
    if (!isNew(folder)) return;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
        const std::string path = entry.path().string(), name = entry.path().filename().string();
        if (!isTemporaryName(name)) continue;
        const int file = openPlain(path, O_RDONLY);
        if (file < 0) continue;
        struct stat status {};
        if (fstat(file, &status) == 0 && status.st_uid == geteuid() && isAbandoned(name, status) &&
            flock(file, LOCK_EX | LOCK_NB) == 0)
            unlink(path.c_str());
        close(file);
    }
}

/// The target of a name through all links; for a missing file, in the folder where it would be.
fs::path realPath(const std::string& path) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? fs::path(path) : real;
}

/// Status of a named file. Standard streams by descriptor: not every machine has /dev/stdin. @returns whether it exists
bool find(const NamedFile& file, struct stat& status) {
    if (file.written && isStandardOutput(file.path)) return fstat(STDOUT_FILENO, &status) == 0;
    if (file.path == "-") return fstat(STDIN_FILENO, &status) == 0;
    return stat(file.path.c_str(), &status) == 0;
}

bool sameFile(const NamedFile& a, const NamedFile& b) {
    struct stat one {
    }, other{};
    // Streams may share a terminal or /dev/null.
    if (find(a, one) && find(b, other))
        return one.st_dev == other.st_dev && one.st_ino == other.st_ino && S_ISREG(one.st_mode);
    return realPath(a.path) == realPath(b.path);
}

}  // namespace

void removeOnSignals(const std::string& temporary) {
    removeUnfinishedOnSignals();
    failOverFileSize();
    const std::lock_guard turn(unfinishedTurn);
    for (auto& name : unfinished)
        if (name[0] == '\0' && temporary.size() < name.size()) {
            std::memcpy(name.data(), temporary.c_str(), temporary.size() + 1);
            return;
        }
}

void keepOnSignals(const std::string& temporary) {
    const std::lock_guard turn(unfinishedTurn);
    for (auto& name : unfinished)
        if (temporary == name.data()) name[0] = '\0';
}

void removeUnfinishedFiles() {
    for (const auto& name : unfinished)
        if (name[0] != '\0') unlink(name.data());
    for (const auto& name : unfinished)
        if (name[0] != '\0') rmdir(name.data());
}

void removeUnfinishedOnSignals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU})
        // Ignored signals stay ignored, as under nohup; other handlers end the program normally, which removes files.
        if (struct sigaction now{}; sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL)
            std::signal(signal, removeUnfinished);
}

bool isStandardOutput(const std::string& path) {
    return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

OutputFile::OutputFile(const std::string& path, const std::string& extension) : path_(path), target_(path) {
    if (isStandardOutput(path)) {
        path_ = "standard output";
        target_.clear();
        makeTemporary(fs::temp_directory_path().string(), extension);
        return;
    }
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) fail(path, "it is a folder");
    // Links stay: their target is replaced.
    if (fs::is_symlink(path, ignored)) {
        const fs::path real = fs::weakly_canonical(path, ignored);
        if (!real.empty()) target_ = real.string();
    }
    if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored)) fail(path, "it is not a plain file");
    makeTemporary(fs::path(target_).parent_path().string(), fileExtension(path));
}

void OutputFile::makeTemporary(const std::string& folder, const std::string& extension) {
    sweep(folder);
    struct stat before {
    }, now{};
    const bool replaces = !target_.empty() && stat(target_.c_str(), &before) == 0;
    // Until it is locked, another run may consider it abandoned.
    for (bool there = false; !there; there = stat(temporary_.c_str(), &now) == 0) {
        if (lock_ >= 0) close(lock_);
        temporary_ = (fs::path(folder) /
                      (std::string(kPrefix) + hostDigits() + unforeseenDigits().substr(kHostDigits) + extension))
                         .string();
        lock_ = openPlain(temporary_, O_RDWR | O_CREAT | O_EXCL, target_.empty() ? 0600 : 0666);
        if (lock_ < 0) fail(path_, std::strerror(errno));
        // Another run that removes leftovers may hold the lock: waits, then checks whether the file still exists.
        // Without locks only age identifies leftovers.
        while (flock(lock_, LOCK_EX) != 0 && errno == EINTR) {
        }
    }
    if (replaces) fchmod(lock_, before.st_mode & 0777);
    removeOnSignals(temporary_);
}

OutputFile::~OutputFile() {
    if (!temporary_.empty() && !committed_) unlink(temporary_.c_str());
    keepOnSignals(temporary_);
    if (lock_ >= 0) close(lock_);
    if (also_.empty()) return;
    unlink(also_.c_str());
    keepOnSignals(also_);
}

void OutputFile::alsoRemove(const std::string& name) {
    also_ = name;
    removeOnSignals(also_);
}

void OutputFile::commit() {
    if (target_.empty()) return copyToStandardOutput();
    std::error_code error;
    if (fs::is_directory(target_, error)) fail(path_, "it is a folder");
    fs::rename(temporary_, target_, error);
    if (error) fail(path_, error.message());
    committed_ = true;
}

void OutputFile::copyToStandardOutput() const {
    const int file = openPlain(temporary_, O_RDONLY);
    if (file < 0) fail(path_, std::strerror(errno));
    std::array<char, 1 << 16> buffer{};
    std::string why;
    for (ssize_t count; why.empty() && (count = read(file, buffer.data(), buffer.size())) != 0;) {
        if (count < 0) why = std::strerror(errno);
        for (ssize_t done = 0; done < count && why.empty();) {
            const ssize_t written = write(STDOUT_FILENO, buffer.data() + done, static_cast<std::size_t>(count - done));
            if (written < 0 && errno != EINTR) why = std::strerror(errno);
            if (written > 0) done += written;
        }
    }
    close(file);
    if (!why.empty()) fail(path_, why);
}

std::string fileExtension(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

void writeText(OutputFile& file, const std::string& text) {
    const int stream = openPlain(file.temporary(), O_WRONLY | O_TRUNC);
    bool whole = stream >= 0;
    for (std::size_t done = 0; whole && done < text.size();) {
        const ssize_t written = write(stream, text.data() + done, text.size() - done);
        if (written > 0) done += static_cast<std::size_t>(written);
        whole = written > 0 || (written < 0 && errno == EINTR);
    }
    if (stream >= 0) whole = close(stream) == 0 && whole;
    if (!whole) fail(file.path(), kDiskFull);
    file.commit();
}

void checkApart(std::span<const NamedFile> files) {
    for (std::size_t i = 0; i < files.size(); ++i)
        for (std::size_t j = i + 1; j < files.size(); ++j) {
            const NamedFile &a = files[i], &b = files[j];
            if (a.path.empty() || b.path.empty() || (!a.written && !b.written)) continue;
            const bool both = a.written && b.written;
            if (both && isStandardOutput(a.path) && isStandardOutput(b.path))
                throw std::invalid_argument(std::string(a.name) + " and " + b.name + " are both standard output");
            if (sameFile(a, b))
                throw std::invalid_argument(std::string(a.name) + " and " + b.name + " are the same file: " + b.path);
        }
}

}  // namespace nacre::app
