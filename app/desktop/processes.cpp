#include "app/desktop/processes.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/files/cache_folder.h"

extern char** environ;

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

/// Contents of a settings file in the user's folder.
std::string readSettings(const std::string& underHome) {
    const std::string home = environmentVariable("HOME");
    if (home.empty()) return {};
    std::ifstream in(fs::path(home) / underHome);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Makes a pipe that other programs do not inherit.
bool makePipe(int (&ends)[2]) {
    if (pipe(ends) != 0) return false;
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
    return true;
}

}  // namespace

bool hasProgram(const std::string& name) {
    std::istringstream folders(environmentVariable("PATH"));
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((fs::path(folder) / name).c_str(), X_OK) == 0) return true;
    return false;
}

std::optional<std::string> runProgram(const std::vector<std::string>& arguments, const std::string& input,
                                      ProgramOutput output) {
    int in[2], out[2];
    if (!makePipe(in)) return std::nullopt;
    if (!makePipe(out)) return close(in[0]), close(in[1]), std::nullopt;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in[0], 0);
    if (output == ProgramOutput::taken)
        posix_spawn_file_actions_adddup2(&actions, out[1], 1);
    else
        posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    pid_t pid = -1;
    const int failed = posix_spawnp(&pid, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(in[0]);
    close(out[1]);
    std::optional<std::string> result;
    if (failed == 0) {
        // A program that does not read its input must not kill this one by SIGPIPE.
        struct sigaction ignore {
        }, before{};
        ignore.sa_handler = SIG_IGN;
        sigaction(SIGPIPE, &ignore, &before);
        for (std::size_t sent = 0; sent < input.size();) {
            const ssize_t n = write(in[1], input.data() + sent, input.size() - sent);
            if (n <= 0) break;
            sent += static_cast<std::size_t>(n);
        }
        sigaction(SIGPIPE, &before, nullptr);
        close(in[1]);
        std::string text;
        char part[4096];
        for (ssize_t n = 0; (n = read(out[0], part, sizeof part)) > 0;) text.append(part, static_cast<std::size_t>(n));
        int status = 0;
        waitpid(pid, &status, 0);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) result = text;
    } else {
        close(in[1]);
    }
    close(out[0]);
    return result;
}

bool copyPng(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    // Both leave a process that owns the selection; xclip's keeps its output open.
    const auto hands = [&](const std::vector<std::string>& program) {
        return runProgram(program, bytes.str(), ProgramOutput::dropped).has_value();
    };
    if (!environmentVariable("WAYLAND_DISPLAY").empty() && hands({"wl-copy", "--type", "image/png"})) return true;
    return hands({"xclip", "-selection", "clipboard", "-t", "image/png", "-i"});
}

bool systemIsDark() {
    if (const std::string theme = environmentVariable("GTK_THEME"); !theme.empty())
        return theme.find("dark") != std::string::npos;
    if (hasProgram("gsettings"))
        if (const auto scheme = runProgram({"gsettings", "get", "org.gnome.desktop.interface", "color-scheme"}))
            if (scheme->find("dark") != std::string::npos) return true;
    if (readSettings(".config/gtk-3.0/settings.ini").find("gtk-application-prefer-dark-theme=1") != std::string::npos)
        return true;
    return readSettings(".config/kdeglobals").find("Dark") != std::string::npos;
}

}  // namespace nacre::app
