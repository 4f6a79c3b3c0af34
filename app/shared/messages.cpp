#include "app/shared/messages.h"

#include <iostream>

#include "app/shared/printable.h"

namespace nacre::app {
namespace {

bool quiet = false;

void say(const char* kind, const std::string& text) {
    std::cerr << "nacre: " + std::string(kind) + printable(text) + "\n" << std::flush;
}

}  // namespace

void sayError(const std::string& text) { say("error: ", text); }

void sayWarning(const std::string& text) {
    if (!quiet) say("warning: ", text);
}

void sayNote(const std::string& text) {
    if (!quiet) say("", text);
}

void beQuiet() { quiet = true; }
bool isQuiet() { return quiet; }

}  // namespace nacre::app
