#include "app/desktop/view_command.h"

#include <csignal>

#include "app/desktop/end_signals.h"
#include "app/desktop/window_session.h"

namespace nacre::app {

void viewCommand(const ViewOptions& options) {
    {
        const EndSignals signals(Window::wake);
        WindowSession(options).loop();
    }
    // The exit status reports the signal.
    if (const int signal = EndSignals::came()) std::raise(signal);
}

}  // namespace nacre::app
