#include "app/cli/commands.h"
#include "app/cli/picture_job.h"
#include "app/shared/messages.h"

namespace nacre::app {

void renderCommand(const RenderOptions& options) {
    Progress progress;
    PictureJob job(options, progress);
    job.prepare();
    for (const std::string& warning : job.warnings()) sayWarning(warning);
    Renderer renderer(options.device);
    job.draw(renderer);
    job.write();
}

}  // namespace nacre::app
