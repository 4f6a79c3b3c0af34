#include "app/apple/session.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "app/shared/local_molecules.h"
#include "app/shared/srgb.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::uint64_t kFramesOfWarmUp = 3;  // live, refined, kept
constexpr std::string_view kSample = "sample:";

/// The main thread draws and takes touches: what it does at rest must not be felt by the next touch.
ViewerOptions viewerOptions(const std::string& occlusionCache) {
    ViewerOptions options;
    options.restingMilliseconds = 16;
    options.occlusionCache = occlusionCache;
    return options;
}

}  // namespace

MoleculeSession::MoleculeSession(SessionHost host, const SavedView& first)
    : host_(std::move(host)),
      renderer_(makeRenderer()),
      screen_(*renderer_),
      viewer_(screen_, localMolecules(host_.readFile), first, viewerOptions(host_.occlusionCache), host_.wake) {}

std::unique_ptr<Renderer> MoleculeSession::makeRenderer() {
    DeviceOptions device;
    device.validate = host_.validate;
    device.surface = host_.surface;
    device.pipelineCache = host_.pipelineCache;
    auto renderer = std::make_unique<Renderer>(device);
    renderer->setScene({});
    return renderer;
}

void MoleculeSession::renew(double now) {
    renderer_.reset();  // it has the window: the next cannot have it before
    renderer_ = makeRenderer();
    screen_.setRenderer(*renderer_);
    viewer_.screenLost(now);
}

void MoleculeSession::resize(PixelSize pixels, double pixelsPerPoint, double now) {
    if (pixels.width && pixels.height) viewer_.resize(pixels, pixelsPerPoint, now);
}

void MoleculeSession::enterBackground() {
    foreground_ = false;
    viewer_.pause();
}

void MoleculeSession::enterForeground(double now) {
    if (!renderer_) renew(now);
    foreground_ = true;
    viewer_.resume(now);
}

void MoleculeSession::lowMemory() {
    viewer_.lowMemory();
    if (!foreground_) renderer_.reset();
}

double MoleculeSession::step(double now) {
    if (!foreground_ || !renderer_) return kNever;
    const double wake = viewer_.update(now);
    if (viewer_.deviceLost()) {
        constexpr int kMost = 3;
        if (++lost_ > kMost) throw Error("the device stopped", renderer_->stats().device.name, "again and again");
        renew(now);
        return now;
    }
    savePipelines();
    return wake;
}

void MoleculeSession::savePipelines() {
    if (pipelinesKept_ || renderer_->stats().windowFrames < kFramesOfWarmUp) return;
    pipelinesKept_ = true;
    host_.pipelineCache = renderer_->pipelineCache();
    if (host_.keepPipelines) host_.keepPipelines(host_.pipelineCache);
}

PictureBytes MoleculeSession::picture(std::uint32_t samples) {
    RenderSettings settings = viewer_.settings();
    settings.supersample = samples;
    const Picture picture = renderer_->render(settings);
    PictureBytes bytes{picture.width, picture.height, std::vector<std::uint8_t>(picture.rgba.size())};
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        const float alpha = std::clamp(picture.rgba[i + 3], 0.0f, 1.0f);
        for (std::size_t c = i; c < i + 3; ++c)
            bytes.rgba[c] = toByte(linearToSrgb(alpha > 0 ? picture.rgba[c] / alpha : 0.0f));
        bytes.rgba[i + 3] = toByte(alpha);
    }
    return bytes;
}

std::string MoleculeSession::shareName() const {
    const std::string& input = viewer_.view().input;
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
