#include "engine/self_test/start_guard.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <utility>

#include "engine/error.h"
#include "engine/self_test/kept_results.h"

namespace nacre {
namespace {

constexpr const char* kStartHeading = "nacre start 1";
/// One death may have any cause; two are blamed on the driver.
constexpr int kBlamed = 2;
/// After so many starts that worked, riskier modes are tried again: a driver may have been updated under the same key.
constexpr int kForgiven = 20;

struct Note {
    std::string driverKey = "-";           ///< of the last start that showed frames
    std::array<int, kStartModes> ended{};  ///< starts of each mode that ended the program, the open one among them
    int open = -1;                         ///< mode of a start that shows no frame yet
    long process = 0;                      ///< its process ID
    int good = 0;  ///< starts in modes other than the usual one that worked, since modes were last forgiven
};

Note readNote(const std::string& folder) {
    const std::optional<std::string> text = keptResults(folder).read(kStartNote);
    if (!text) return {};
    std::istringstream lines(*text);
    std::string heading;
    Note note;
    if (!std::getline(lines, heading) || heading != kStartHeading) return {};
    lines >> note.driverKey;
    for (int& count : note.ended) lines >> count;
    if (!(lines >> note.open >> note.process) || note.open < -1 || note.open >= kStartModes) return {};
    if (!(lines >> note.good)) note.good = 0;  // notes of earlier versions lack this
    return note;
}

void writeNote(const std::string& folder, const Note& note) {
    std::ostringstream text;
    text << kStartHeading << '\n' << note.driverKey << '\n';
    for (const int count : note.ended) text << count << ' ';
    text << '\n' << note.open << ' ' << note.process << ' ' << note.good << '\n';
    const std::string whole = text.str();
    const std::string_view parts[] = {whole};
    keptResults(folder).write(kStartNote, parts);
}

/// Whether a start's process still runs: another window of this program.
bool isAlive(long process) { return process > 0 && kill(static_cast<pid_t>(process), 0) == 0; }

}  // namespace

StartGuard::StartGuard(std::string folder) : folder_(std::move(folder)) {
    if (folder_.empty()) return;
    Note note = readNote(folder_);
    if (note.open >= 0 && isAlive(note.process)) return;  // that process guards its own start
    int mode = note.open + 1;                             // riskier modes wait until one has worked
    while (mode < kStartModes && note.ended[static_cast<std::size_t>(mode)] >= kBlamed) ++mode;
    if (mode == kStartModes) {
        writeNote(folder_, {});  // the next start tries all modes again
        throw Error("cannot start drawing", "the graphics driver ended the program at each of the last starts",
                    "an update of the system may bring another driver");
    }
    ++note.ended[static_cast<std::size_t>(mode)];
    note.open = mode;
    note.process = getpid();
    writeNote(folder_, note);
    mode_ = static_cast<StartMode>(mode);
    open_ = true;
}

void StartGuard::end(bool well, const std::string& driverKey) {
    if (!std::exchange(open_, false)) return;
    Note note = readNote(folder_);
    int& ended = note.ended[static_cast<std::size_t>(mode_)];
    ended = well ? 0 : std::max(ended - 1, 0);
    note.open = -1;
    if (well && mode_ != StartMode::usual && ++note.good >= kForgiven) {
        for (int& count : note.ended) count = std::min(count, kBlamed - 1);
        note.good = 0;
    }
    if (well && note.driverKey != driverKey) {
        if (note.driverKey != "-") note.ended = {};
        note.driverKey = driverKey;
    }
    writeNote(folder_, note);
}

}  // namespace nacre
