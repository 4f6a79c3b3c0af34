#include "app/files/messages.h"

#include <atomic>
#include <iostream>

#include "app/files/printable.h"

namespace nacre::app {
namespace {

bool quiet = false, verbose = false;
std::atomic<bool> lineShown = false;
thread_local HeardMessages* heard = nullptr;

void say(const char* kind, const std::string& text) {
    std::cerr << std::string(lineShown ? "\r\x1b[K" : "") + "nacre: " + std::string(kind) + printable(text) + "\n"
              << std::flush;
}

}  // namespace

void sayError(const std::string& text) { say("error: ", shortened(text)); }

void sayWarning(const std::string& text) {
    if (heard || !quiet) sayNotice(text);
}

void sayNotice(const std::string& text) {
    if (heard)
        heard->warnings.push_back(text);
    else
        say("warning: ", text);
}

void sayNote(const std::string& text) {
    if (heard)
        heard->notes.push_back(text);
    else if (!quiet)
        say("", text);
}

void setLineShown(bool shown) { lineShown = shown; }
void beQuiet() { quiet = true; }
bool isQuiet() { return quiet; }
void beVerbose() { verbose = true; }
bool isVerbose() { return verbose; }

HeardMessages::HeardMessages() : before_(heard) { heard = this; }
HeardMessages::~HeardMessages() { heard = before_; }

}  // namespace nacre::app
