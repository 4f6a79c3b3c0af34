#pragma once
// What a program says on standard error besides what it was asked for: each one line, safe to print.

#include <string>
#include <vector>

namespace nacre::app {

/// "nacre: error: ..."; never kept back.
void sayError(const std::string& text);
/// "nacre: warning: ...": something is not as it was asked for.
void sayWarning(const std::string& text);
/// The same; never kept back: what somebody else's file had this program do.
void sayNotice(const std::string& text);
/// "nacre: ...": what may be good to know.
void sayNote(const std::string& text);

/// Keeps back warnings, notes and progress from now on.
void beQuiet();
bool isQuiet();

/// Errors tell all that is known of their causes from now on: every address that was asked.
void beVerbose();
bool isVerbose();

/// Whether a line of progress stands on the terminal, which what is said then replaces.
void setLineShown(bool shown);

/// As long as it is there, warnings, notices and notes of the thread that made it come to it and are not printed.
class HeardMessages {
public:
    HeardMessages();
    ~HeardMessages();
    HeardMessages(const HeardMessages&) = delete;
    HeardMessages& operator=(const HeardMessages&) = delete;

    std::vector<std::string> warnings, notes;

private:
    HeardMessages* before_;
};

}  // namespace nacre::app
