#include "app/shared/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "engine/error.h"

namespace nacre::app {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) { throw Error("cannot write file", path, why); }

// Temporary names of files that are open, for the signal handler: plain memory, since it may call next to nothing.
// More than fit are written just the same; only an interrupted run would leave them behind.
constexpr std::size_t kMostRemembered = 8;
std::array<std::array<char, 4096>, kMostRemembered> unfinished{};

extern "C" void removeUnfinished(int signal) {
    for (const auto& name : unfinished)
        if (name[0] != '\0') unlink(name.data());
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void remember(const std::string& temporary) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, removeUnfinished) == SIG_IGN) std::signal(signal, SIG_IGN);  // as under nohup
    std::signal(SIGXFSZ, SIG_IGN);  // over a limit on file sizes, writing fails like on a full disk
    for (auto& name : unfinished)
        if (name[0] == '\0' && temporary.size() < name.size()) {
            std::memcpy(name.data(), temporary.c_str(), temporary.size() + 1);
            return;
        }
}

void forget(const std::string& temporary) {
    for (auto& name : unfinished)
        if (temporary == name.data()) name[0] = '\0';
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), target_(path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) fail(path, "it is a folder");
    // A link keeps pointing where it does: what it points to is replaced.
    if (fs::is_symlink(path, ignored)) {
        const fs::path real = fs::weakly_canonical(path, ignored);
        if (!real.empty()) target_ = real.string();
    }
    if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored)) fail(path, "it is not a plain file");
    const fs::path folder = fs::path(target_).parent_path();
    for (int attempt = 0;; ++attempt) {
        const std::string name =
            ".nacre-" + std::to_string(getpid()) + "-" + std::to_string(attempt) + extensionOf(path);
        temporary_ = (folder / name).string();
        const int file = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) {
            close(file);
            remember(temporary_);
            return;
        }
        if (errno != EEXIST || attempt >= 1000) fail(path, std::strerror(errno));
    }
}

OutputFile::~OutputFile() {
    if (!committed_) unlink(temporary_.c_str());
    forget(temporary_);
    if (also_.empty()) return;
    unlink(also_.c_str());
    forget(also_);
}

void OutputFile::alsoRemove(const std::string& name) {
    also_ = name;
    remember(also_);
}

void OutputFile::commit() {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) fail(path_, error.message());
    committed_ = true;
}

std::string extensionOf(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

void writeText(OutputFile& file, const std::string& text) {
    std::ofstream stream(file.temporary(), std::ios::binary | std::ios::trunc);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) fail(file.path(), "the data could not be written (is the disk full?)");
    file.commit();
}

}  // namespace nacre::app
