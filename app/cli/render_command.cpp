#include "app/cli/commands.h"
#include "app/cli/picture_job.h"
#include "app/files/cache_folder.h"
#include "app/files/messages.h"

namespace nacre::app {

void renderCommand(const PictureDescription& options) {
    Progress progress;
    PictureJob job(options, progress);
    job.prepare();
    for (const std::string& warning : job.warnings()) sayWarning(warning);
    DeviceOptions device = options.device;
    device.selfTests = cacheFolder(options.input.cache, "devices");
    device.onSelfTest = [] {
        sayNote("testing this device and driver, once: which drawing paths are correct, and how fast they are");
    };
    Canvas canvas(device);
    canvas.renderer.makePipelinesAhead();
    job.draw(canvas);
    job.write();
}

}  // namespace nacre::app
