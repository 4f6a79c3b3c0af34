#include <filesystem>

#include "app/cli/commands.h"
#include "app/cli/picture_job.h"
#include "app/download/load_scene.h"
#include "app/files/cache_folder.h"
#include "app/files/messages.h"

namespace nacre::app {

namespace {

/// "a.png" as "a-2.png".
std::string numberedName(const std::string& name, std::size_t number) {
    if (name.empty()) return name;
    const std::filesystem::path path(name);
    return (path.parent_path() / (path.stem().string() + "-" + std::to_string(number))).string() +
           path.extension().string();
}

DeviceOptions chooseDevice(const PictureDescription& options) {
    DeviceOptions device = options.device;
    device.selfTests = cacheFolder(options.input.cache, "devices");
    device.onSelfTest = [] {
        sayNote("testing this device and driver, once: which drawing paths are correct, and how fast they are");
    };
    return device;
}

/// Draws a picture of each snapshot of a scene.
void renderSnapshots(PictureDescription options) {
    OpenScene scene(options.input);
    const std::size_t count = scene.times().size();
    const PictureDescription all = options;
    Canvas canvas(chooseDevice(options));
    for (std::size_t number = 1; number <= count; ++number) {
        options.input.snapshot = static_cast<int>(number);
        options.output = numberedName(all.output, number);
        options.layers = numberedName(all.layers, number);
        options.stats = numberedName(all.stats, number);
        options.capture = numberedName(all.capture, number);
        options.saveView = numberedName(all.saveView, number);
        Progress progress;
        PictureJob job(options, progress);
        job.prepare(&scene);
        for (const std::string& warning : job.warnings())
            sayWarning("snapshot " + std::to_string(number) + ": " + warning);
        job.draw(canvas);
        job.write();
    }
}

}  // namespace

void renderCommand(const PictureDescription& options) {
    if (options.input.snapshot == kAllSnapshots) return renderSnapshots(options);
    Progress progress;
    PictureJob job(options, progress);
    job.prepare();
    for (const std::string& warning : job.warnings()) sayWarning(warning);
    Canvas canvas(chooseDevice(options));
    canvas.renderer.makePipelinesAhead();
    job.draw(canvas);
    job.write();
}

}  // namespace nacre::app
