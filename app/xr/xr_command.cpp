#include "app/xr/xr_command.h"

#include "app/movie/stop_request.h"
#include "app/xr/xr_session.h"

namespace nacre::app {

void xrCommand(const PictureDescription& first) {
    HeadsetSession session(first);
    const StopRequest stop;
    session.loop([&] { return stop.asked(); });
}

}  // namespace nacre::app
