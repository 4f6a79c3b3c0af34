#pragma once
// What a program says on standard error besides what it was asked for: each one line, safe to print.

#include <string>

namespace nacre::app {

/// "nacre: error: ..."; never kept back.
void sayError(const std::string& text);
/// "nacre: warning: ...": something is not as it was asked for.
void sayWarning(const std::string& text);
/// "nacre: ...": what may be good to know.
void sayNote(const std::string& text);

/// Keeps back warnings, notes and progress from now on.
void beQuiet();
bool isQuiet();

}  // namespace nacre::app
