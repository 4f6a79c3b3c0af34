#include "app/desktop/file_dialog.h"

#include <cstdlib>
#include <optional>
#include <sstream>
#include <string_view>

#include "app/desktop/portal.h"
#include "app/desktop/processes.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

#ifndef NACRE_PORTAL
bool hasPortal() { return false; }
PortalAnswer openByPortal(const std::string&) { return {}; }
PortalAnswer saveByPortal(const std::string&, const std::string&) { return {}; }
#endif

constexpr const char* kOpen = "Open";

bool preferKdialog() {
    const char* desktop = std::getenv("XDG_CURRENT_DESKTOP");
    const bool onKde = desktop && std::string_view(desktop).find("KDE") != std::string_view::npos;
    return hasProgram("kdialog") && (onKde || !hasProgram("zenity"));
}

/// Programs print one file per line.
std::vector<std::string> splitLines(const std::optional<std::string>& answer) {
    std::vector<std::string> lines;
    std::istringstream text(answer.value_or(""));
    for (std::string line; std::getline(text, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

std::vector<std::string> askToOpen() {
    if (PortalAnswer answer = openByPortal(kOpen); answer.there) return answer.paths;
    return splitLines(preferKdialog() ? runProgram({"kdialog", "--title", kOpen, "--multiple", "--separate-output",
                                                    "--getopenfilename", "."})
                                      : runProgram({"zenity", "--file-selection", "--multiple", "--separator=\n",
                                                    std::string("--title=") + kOpen}));
}

std::vector<std::string> askToSave(const std::string& title, const std::string& suggested) {
    if (PortalAnswer answer = saveByPortal(title, suggested); answer.there) return answer.paths;
    return splitLines(preferKdialog() ? runProgram({"kdialog", "--title", title, "--getsavefilename", suggested})
                                      : runProgram({"zenity", "--file-selection", "--save", "--confirm-overwrite",
                                                    "--title=" + title, "--filename=" + suggested}));
}

}  // namespace

bool FileDialog::available() { return hasProgram("zenity") || hasProgram("kdialog") || hasPortal(); }

FileDialog::~FileDialog() {
    if (thread_.joinable()) thread_.detach();  // closing the window does not wait for the dialog
}

void FileDialog::open(Chosen chosen) { run(askToOpen, std::move(chosen)); }

void FileDialog::save(const std::string& title, const std::string& suggested, Chosen chosen) {
    run([=] { return askToSave(title, suggested); }, std::move(chosen));
}

void FileDialog::run(std::function<std::vector<std::string>()> ask, Chosen chosen) {
    if (busy_->exchange(true)) return;
    if (thread_.joinable()) thread_.join();
    const bool started = mayStart(thread_, [ask = std::move(ask), chosen = std::move(chosen), busy = busy_] {
        const std::vector<std::string> paths = ask();
        if (!paths.empty()) chosen(paths);
        busy->store(false);
    });
    if (!started) busy_->store(false);
}

}  // namespace nacre::app
