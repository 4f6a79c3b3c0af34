#include "app/desktop/view_command.h"

#include "app/desktop/window_session.h"

namespace nacre::app {

void viewCommand(const ViewOptions& options) { WindowSession(options).loop(); }

}  // namespace nacre::app
