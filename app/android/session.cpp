#include "app/android/session.h"

#include <algorithm>
#include <filesystem>

#include "app/android/log.h"
#include "app/android/render_thread.h"
#include "app/android/surface.h"
#include "app/download/molecule_sources.h"
#include "app/shared/molecules.h"
#include "app/viewer/kept_files.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

ViewerOptions optionsOf(const SessionFiles& files) {
    ViewerOptions options;
    options.occlusionCache = files.occlusion;
    options.errorsStay = true;
    return options;
}

/// A view that was kept asks before it downloads what the cache has no more.
InputOptions inputOf(const SessionFiles& files, const SavedView& first) {
    InputOptions input;
    input.path = first.input;
    if (!first.input.empty()) input.namedBy = "the last view";
    input.cache = files.cache;
    input.memoryMegabytes = static_cast<std::int64_t>(memoryShare(4) >> 20);
    return input;
}

}  // namespace

// --- window

AndroidSession::AndroidSession(SessionFiles files, const SavedView& first, double pixelsPerPoint, SharedState& shared,
                               std::function<void()> wake, PlatformCalls platform)
    : files_(std::move(files)),
      shared_(shared),
      platform_(std::move(platform)),
      session_(host(), phoneSources(inputOf(files_, first)), first, optionsOf(files_), std::move(wake)) {
    makePanel(pixelsPerPoint);
    viewer().pause();
}

SessionHost AndroidSession::host() {
    SessionHost host;
    host.device = [this] {
        DeviceOptions device;
        device.surface = surfaceOf([this] { return window_; });
        device.selfTests = files_.devices;
        return device;
    };
    host.loadPipelines = [this] { return loadPipelineCache(files_.pipelines); };
    host.keepPipelines = [this](const std::vector<std::byte>& data) { keepPipelineCache(files_.pipelines, data); };
    host.prepare = [this](Renderer& renderer) { renderer.setOverlayGlyphs(panel_->glyphs()); };
    host.lost = [](const std::string& why) { logError(why); };
    host.windowMayGo = true;
    return host;
}

void AndroidSession::makePanel(double pixelsPerPoint) {
    scale_ = pixelsPerPoint;
    panel_.reset();
    PanelHost host;
    host.run = [this](ViewerCommand command) { run(command); };
    host.openDialog = platform_.pickDocument;
    host.askText = platform_.askText;
    host.downloads = static_cast<bool>(platform_.askText);
    host.fontWith = systemFontWith;
    host.statistics = [this] { return session_.statistics(); };
    panel_ = std::make_unique<Panel>(pixelsPerPoint, std::move(host), PanelHand::fingers);
}

PixelSize AndroidSession::size() const {
    if (!window_) return {};
    return {static_cast<std::uint32_t>(std::max(ANativeWindow_getWidth(window_), 0)),
            static_cast<std::uint32_t>(std::max(ANativeWindow_getHeight(window_), 0))};
}

void AndroidSession::windowCreated(ANativeWindow* window) {
    window_ = window;
    if (!session_.renderer()) session_.open(steadySeconds());
    windowChanged();
}

void AndroidSession::windowChanged() {
    if (window_ && size().width && size().height) viewer().resize(size(), scale_, steadySeconds());
    contentChanged(content_);
    settle();
}

void AndroidSession::windowDestroyed() {
    if (Renderer* renderer = session_.renderer()) renderer->releaseWindow();
    window_ = nullptr;
    settle();
}

void AndroidSession::contentChanged(const ARect& content) {
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
    viewer().overlayChanged();
}

void AndroidSession::densityChanged(double pixelsPerPoint) {
    if (pixelsPerPoint != scale_) {
        makePanel(pixelsPerPoint);
        if (Renderer* renderer = session_.renderer()) renderer->setOverlayGlyphs(panel_->glyphs());
    }
    windowChanged();
}

void AndroidSession::displayRefreshes(double rate) { viewer().setDisplayInterval(1 / rate); }

/// Draws while there is a window that is to be seen.
void AndroidSession::settle() {
    if (window_ && started_)
        viewer().resume(steadySeconds());
    else
        viewer().pause();
}

// --- activity

void AndroidSession::started() {
    started_ = true;
    settle();
}

/// Another window has the user's attention, or will; this one may still be seen.
void AndroidSession::paused() {
    viewer().pause();
    panel_->forgetTouch();
    keepView(files_.view, viewer().view());
    settle();
}

void AndroidSession::stopped() {
    started_ = false;
    settle();
}

void AndroidSession::lowMemory() {
    viewer().lowMemory();
    if (!window_) session_.close();
}

void AndroidSession::giveUp() {
    session_.close();
    window_ = nullptr;
}

// --- the user

void AndroidSession::touch(const TouchEvent& event, double when) {
    if (panel_->touch(event))
        viewer().overlayChanged();
    else
        viewer().touch(event, when);
}

void AndroidSession::wheel(double steps, glm::dvec2 at) { viewer().wheel(steps, at, steadySeconds()); }

void AndroidSession::key(const KeyEvent& event) {
    if (const auto command = commandOf(event)) run(*command);
}

void AndroidSession::back() {
    if (!panel_->closeTop() && panel_->panelOpen()) panel_->togglePanel();
    viewer().overlayChanged();
}

void AndroidSession::open(const std::string& path) { viewer().open(path, steadySeconds()); }

void AndroidSession::say(const std::string& text) {
    logError(text);
    viewer().say(text, steadySeconds());
}

void AndroidSession::fail(const std::string& text) {
    logError(text);
    viewer().fail(text, steadySeconds());
}

void AndroidSession::run(ViewerCommand command) {
    if (command == ViewerCommand::panel) panel_->togglePanel();
    if (command == ViewerCommand::help) panel_->toggleHelp();
    if (command == ViewerCommand::openFile) panel_->showStart();
    if (command == ViewerCommand::saveAs || command == ViewerCommand::savePicture) share();
    if (command == ViewerCommand::saveView) shareView();
    viewer().overlayChanged();
    viewer().run(command, steadySeconds());
}

std::string AndroidSession::shareName(const char* extension) {
    const std::string stem = std::filesystem::path(viewer().document()->view.input).stem().string();
    return (stem.empty() ? "nacre" : stem) + extension;
}

/// The picture as it is seen, to whichever app the user chooses.
void AndroidSession::share() {
    if (!platform_.share || !viewer().document() || !session_.renderer()) return;
    try {
        RenderSettings settings = viewer().pictureWithWords(viewer().size(), viewer().textSize());
        settings.supersample = RenderSettings::kEdges;
        Picture picture = session_.renderer()->render(settings);
        viewer().paintWords(settings.view, viewer().textSize(), false, picture);
        platform_.share(picture, shareName(".png"));
    } catch (const Error& error) {
        viewer().fail(error.what(), steadySeconds());
    }
}

/// The view as JSON, likewise.
void AndroidSession::shareView() {
    if (!platform_.shareText || !viewer().document()) return;
    SavedView view = viewer().savedView();
    view.input = std::filesystem::path(view.input).filename().string();  // another device has it elsewhere
    platform_.shareText(savedViewJson(view), shareName(".view.json"));
}

void AndroidSession::typed(const std::string& name, const std::string& text) {
    panel_->typed(name, text);
    viewer().overlayChanged();
}

void AndroidSession::press(const std::string& role, const std::string& name) {
    const Control* c = findControl(panel_->controls(), role, name);
    if (!c) return;
    const glm::dvec2 at = glm::dvec2(c->seenLeft + c->seenRight, c->seenTop + c->seenBottom) / 2.0 / scale_;
    touch({0, TouchPhase::began, at}, steadySeconds());
    touch({0, TouchPhase::ended, at}, steadySeconds());
}

void AndroidSession::adjust(const std::string& name, bool up) {
    const auto at = placeOfStep(panel_->controls(), name, up);
    if (!at) return;
    touch({0, TouchPhase::began, *at / scale_}, steadySeconds());
    touch({0, TouchPhase::ended, *at / scale_}, steadySeconds());
}

/// The picture comes first, then what stands over it.
void AndroidSession::tellControls() {
    Control picture;
    picture.role = "image";
    picture.name = viewer().title();
    picture.seenRight = static_cast<float>(size().width), picture.seenBottom = static_cast<float>(size().height);
    const std::string lines = controlLines({picture}) + controlLines(panel_->controls());
    {
        const std::lock_guard lock(shared_.mutex);
        if (lines == shared_.lines) return;
        shared_.lines = lines;
    }
    if (platform_.controlsChanged) platform_.controlsChanged();
}

// --- the loop

void AndroidSession::awaitFrame() {
    if (window_ && started_) viewer().awaitFrame(steadySeconds());
}

double AndroidSession::step() {
    const double now = steadySeconds();
    const double wake = session_.step(now, [&] {
        const Overlay* overlay = panel_->draw(viewer(), size(), now);
        if (panel_->glyphsChanged()) session_.renderer()->setOverlayGlyphs(panel_->glyphs());
        return overlay;
    });
    if (shared_.read) tellControls();
    shared_.wantsBack = panel_->helpOpen() || panel_->panelOpen();
    {
        const std::lock_guard lock(shared_.mutex);
        shared_.view = viewer().view();
    }
    if (!window_ || !started_ || !panel_->restless()) return wake;
    viewer().overlayChanged();
    return now;
}

}  // namespace nacre::app
