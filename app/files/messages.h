#pragma once
// Messages on standard error: one line each, safe to print.

#include <string>
#include <vector>

namespace nacre::app {

/// "nacre: error: ..."; never suppressed.
void sayError(const std::string& text);
/// "nacre: warning: ...": the result differs from the request.
void sayWarning(const std::string& text);
/// As above, never suppressed: an action caused by an untrusted file.
void sayNotice(const std::string& text);
/// "nacre: ...": useful information.
void sayNote(const std::string& text);

/// Suppresses warnings, notes and progress from now on.
void beQuiet();
bool isQuiet();

/// From now on errors include every known cause, such as each address tried.
void beVerbose();
bool isVerbose();

/// Whether a progress line is on the terminal; the next message replaces it.
void setLineShown(bool shown);

/// While it exists, collects this thread's warnings, notices and notes instead of printing them.
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
