#include "app/android/session.h"

#include <algorithm>

#include "app/android/log.h"
#include "app/android/render_thread.h"
#include "app/android/surface.h"
#include "app/shared/local_molecules.h"
#include "app/viewer/kept_files.h"
#include "engine/error.h"

namespace nacre::app {

// --- the screen

void WindowScreen::setScene(const Representation& scene) {
    if (renderer_) renderer_->setScene(scene);
}

double WindowScreen::advanceOcclusion(const RenderSettings& settings, double milliseconds) {
    if (!renderer_) return 0;
    RenderSettings kept = settings;
    kept.occlusion.cache = occlusionFolder_;
    return renderer_->advanceOcclusion(kept, milliseconds);
}

FrameOutcome WindowScreen::present(const RenderSettings& settings, const WindowFrame& frame) {
    if (!renderer_) return FrameOutcome::hidden;
    try {
        const FrameOutcome outcome = renderer_->present(settings, frame);
        failures_ = 0;
        return outcome;
    } catch (const Error& error) {
        // A window that is about to go refuses frames before anyone is told; another one comes.
        constexpr int kMostFailures = 3;
        if (++failures_ > kMostFailures) throw;
        logError(error.what());
        renderer_->releaseWindow();
        return FrameOutcome::hidden;
    }
}

PixelSize WindowScreen::windowSize() const { return renderer_ ? renderer_->windowSize() : PixelSize{1, 1}; }

std::uint32_t WindowScreen::atomAt(const RenderSettings& settings, double x, double y, double reach) {
    return renderer_ ? renderer_->atomAt(settings, x, y, reach) : 0;
}

// --- window

Session::Session(SessionFiles files, const SavedView& first, double pixelsPerPoint, SharedState& shared,
                 std::function<void()> wake)
    : files_(std::move(files)),
      shared_(shared),
      screen_(files_.occlusion),
      viewer_(screen_, localMolecules(), first, ViewerOptions{}, std::move(wake)) {
    makePanel(pixelsPerPoint);
    viewer_.pause();
}

void Session::makePanel(double pixelsPerPoint) {
    scale_ = pixelsPerPoint;
    panel_.reset();
    panel_ = std::make_unique<Panel>(
        pixelsPerPoint, [this](ViewerCommand command) { run(command); }, PanelHand::fingers);
}

void Session::makeRenderer() {
    DeviceOptions device;
    device.surface = surfaceOf([this] { return window_; });
    device.pipelineCache = loadPipelineCache(files_.pipelines);
    renderer_ = std::make_unique<Renderer>(device);
    screen_.setRenderer(renderer_.get());
    renderer_->setScene({});
    renderer_->setOverlayGlyphs(panel_->glyphs());
    viewer_.screenLost(steadySeconds());
}

PixelSize Session::size() const {
    if (!window_) return {};
    return {static_cast<std::uint32_t>(std::max(ANativeWindow_getWidth(window_), 0)),
            static_cast<std::uint32_t>(std::max(ANativeWindow_getHeight(window_), 0))};
}

void Session::windowCreated(ANativeWindow* window) {
    window_ = window;
    if (!renderer_) makeRenderer();
    windowChanged();
}

void Session::windowChanged() {
    if (window_ && size().width && size().height) viewer_.resize(size(), scale_, steadySeconds());
    contentChanged(content_);
    settle();
}

void Session::windowDestroyed() {
    if (renderer_) renderer_->releaseWindow();
    window_ = nullptr;
    settle();
}

void Session::contentChanged(const ARect& content) {
    content_ = content;
    const auto width = static_cast<std::int32_t>(size().width), height = static_cast<std::int32_t>(size().height);
    // While the window turns, its content may still be that of the other way up.
    const bool fits = content.left >= 0 && content.top >= 0 && content.left < content.right &&
                      content.top < content.bottom && content.right <= width && content.bottom <= height;
    Insets insets;
    if (fits)
        insets = {static_cast<float>(content.left), static_cast<float>(content.top),
                  static_cast<float>(width - content.right), static_cast<float>(height - content.bottom)};
    panel_->setInsets(insets);
    viewer_.overlayChanged();
}

void Session::densityChanged(double pixelsPerPoint) {
    if (pixelsPerPoint != scale_) {
        makePanel(pixelsPerPoint);
        if (renderer_) renderer_->setOverlayGlyphs(panel_->glyphs());
    }
    windowChanged();
}

/// Draws while there is a window that is to be seen.
void Session::settle() {
    if (window_ && started_)
        viewer_.resume(steadySeconds());
    else
        viewer_.pause();
}

// --- activity

void Session::started() {
    started_ = true;
    settle();
}

/// Another window has the user's attention, or will; this one may still be seen.
void Session::paused() {
    viewer_.pause();
    panel_->forgetTouch();
    keepView(files_.view, viewer_.view());
    settle();
}

void Session::stopped() {
    started_ = false;
    settle();
}

void Session::lowMemory() {
    viewer_.lowMemory();
    if (!window_) dropRenderer();
}

void Session::dropRenderer() {
    screen_.setRenderer(nullptr);
    renderer_.reset();
}

void Session::giveUp() {
    dropRenderer();
    window_ = nullptr;
}

// --- the user

void Session::touch(const TouchEvent& event, double when) {
    if (panel_->touch(event))
        viewer_.overlayChanged();
    else
        viewer_.touch(event, when);
}

void Session::wheel(double steps, glm::dvec2 at) { viewer_.wheel(steps, at, steadySeconds()); }

void Session::key(const KeyEvent& event) {
    if (const auto command = commandOf(event)) run(*command);
}

void Session::back() {
    if (panel_->helpOpen())
        panel_->toggleHelp();
    else if (panel_->panelOpen())
        panel_->togglePanel();
    viewer_.overlayChanged();
}

void Session::open(const std::string& path) { viewer_.open(path, steadySeconds()); }

void Session::say(const std::string& text) {
    logError(text.c_str());
    viewer_.say(text, steadySeconds());
}

void Session::run(ViewerCommand command) {
    if (command == ViewerCommand::panel) panel_->togglePanel();
    if (command == ViewerCommand::help) panel_->toggleHelp();
    viewer_.overlayChanged();
    viewer_.run(command, steadySeconds());
}

// --- the loop

double Session::step() {
    const double now = steadySeconds();
    const double wake = viewer_.update(now, [&] { return panel_->draw(viewer_, size(), now); });
    shared_.wantsBack = panel_->helpOpen() || panel_->panelOpen();
    {
        const std::lock_guard lock(shared_.mutex);
        shared_.view = viewer_.view();
    }
    if (viewer_.deviceLost()) {
        if (++lost_ > 3) throw Error("the device stopped", renderer_->stats().device.name, "again and again");
        dropRenderer();
        makeRenderer();
        return now;
    }
    saveWarmCaches();
    if (!window_ || !started_ || !panel_->restless()) return wake;
    viewer_.overlayChanged();
    return now;
}

/// What the driver compiled for the first refined picture is all that later ones need.
void Session::saveWarmCaches() {
    if (cachesSaved_ || !renderer_ || renderer_->stats().windowFrames < 3) return;
    cachesSaved_ = true;
    keepPipelineCache(files_.pipelines, renderer_->pipelineCache());
}

}  // namespace nacre::app
