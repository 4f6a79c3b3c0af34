#include "app/apple/session.h"

#include <filesystem>
#include <limits>

#include "app/shared/srgb.h"
#include "app/viewer/local_molecules.h"

namespace nacre::app {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::string_view kSample = "sample:";

ViewerOptions viewerOptions(const std::string& occlusionCache) {
    ViewerOptions options;
    options.occlusionCache = occlusionCache;
    return options;
}

SessionHost hostOf(const MoleculeHost& host) {
    SessionHost session;
    session.device = [surface = host.surface, validate = host.validate, folder = host.occlusionCache] {
        DeviceOptions device;
        device.validate = validate;
        device.surface = surface;
        if (!folder.empty()) device.selfTests = (std::filesystem::path(folder).parent_path() / "devices").string();
        return device;
    };
    session.loadPipelines = host.loadPipelines;
    session.keepPipelines = host.keepPipelines;
    return session;
}

}  // namespace

MoleculeSession::MoleculeSession(MoleculeHost host, const SavedView& first)
    : session_(hostOf(host), localMolecules(host.readFile), first, viewerOptions(host.occlusionCache), host.wake) {
    session_.open(0);
}

void MoleculeSession::resize(PixelSize pixels, double pixelsPerPoint, double now) {
    if (pixels.width && pixels.height) viewer().resize(pixels, pixelsPerPoint, now);
}

void MoleculeSession::enterBackground() {
    foreground_ = false;
    viewer().pause();
}

void MoleculeSession::enterForeground(double now) {
    if (!holdsDevice()) session_.open(now);
    foreground_ = true;
    viewer().resume(now);
}

void MoleculeSession::lowMemory() {
    viewer().lowMemory();
    if (!foreground_) session_.close();
}

double MoleculeSession::step(double now) { return foreground_ && holdsDevice() ? session_.step(now) : kNever; }

PictureBytes MoleculeSession::picture(std::uint32_t samples) {
    RenderSettings settings = viewer().settings();
    settings.supersample = samples;
    const Picture picture = session_.renderer()->render(settings);
    PictureBytes bytes{picture.width, picture.height, std::vector<std::uint8_t>(picture.rgba.size())};
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) codePixel(&picture.rgba[i], true, &bytes.rgba[i]);
    return bytes;
}

std::string MoleculeSession::shareName() const {
    const std::string& input = viewer().view().input;
    const std::size_t colon = input.starts_with(kSample) ? kSample.size() : 0;
    std::string name = std::filesystem::path(input.substr(colon)).filename().string();
    if (const std::size_t dot = name.find('.', 1); dot != std::string::npos) name.resize(dot);
    return name.empty() ? "nacre" : name;
}

std::string spokenValue(const Annotations& annotations) {
    std::string text;
    for (const std::string* part : {&annotations.atom, &annotations.measurement, &annotations.message})
        if (!part->empty()) text += (text.empty() ? "" : ". ") + *part;
    return text;
}

}  // namespace nacre::app
