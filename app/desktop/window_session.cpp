#include "app/desktop/window_session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <utility>

#include "app/desktop/end_signals.h"
#include "app/desktop/processes.h"
#include "app/download/database_id.h"
#include "app/download/molecule_sources.h"
#include "app/files/cache_folder.h"
#include "app/files/messages.h"
#include "app/files/printable.h"
#include "app/viewer/file_kind.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::uint32_t kSoftwareSamples = 2;  // per pixel side, for refinement on a CPU
// Resolution during motion on a CPU: large blocks look worse than a low frame rate.
constexpr double kSoftwareFrameSeconds = 0.025, kSoftwareScale = 0.7;

}  // namespace

double WindowSession::now() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

const double WindowSession::kStarted = WindowSession::now();

struct WindowSession::Chosen {
    std::mutex mutex;
    std::vector<std::string> paths;
    std::string savePath;
    PathChosen whereChosen;  ///< receives savePath
};

WindowSession::WindowSession(const ViewOptions& options)
    : options_(options),
      remembered_(loadWindowState()),
      window_(firstSize(), events()),
      recent_(recentPath()),
      samples_(samplesPath()),
      dark_(systemIsDark()),
      panel_(makePanel(nullptr)),
      session_(host(), windowSources(options.first.input), firstView(), viewerOptions(), Window::wake),
      chosen_(std::make_shared<Chosen>()) {
    if (!remembered_.panelOpen) panel_->togglePanel();
    viewer().words().setTextPercent(textPercent_);
    scale_ = window_.pixelsPerPoint();
    opening_ = now();
    session_.open(opening_);
    open_ = now();
    if (renderer().stats().device.type == "software") {
        viewer().frames().setMostSamples(kSoftwareSamples);
        viewer().frames().keepSharp(kSoftwareFrameSeconds, kSoftwareScale);
    }
    viewer().frames().setDebugView(options.first.debug, now());
    viewer().camera().aim(options.first.aim, now());
    // Errors that may be temporary are retried in the window.
    const std::string& input = options.first.input.path;
    if (!parseDatabaseId(input) && !parseDatabaseId(meantInput(input))) viewer().reading().throwEarlyFailure();
    shownSamples_ = sampleFiles();
    window_.show();
    resized();
}

void WindowSession::loop() {
    while (!window_.closing() && !EndSignals::came()) step(std::numeric_limits<double>::infinity());
    keepWindowState();
    window_.hide();
    recorder_.finish();
    saveState(viewer().restartView());
    rememberFile();
    if (!options_.first.stats.empty()) writeStats();
    if (const std::vector<std::string> messages = renderer().validationMessages(); !messages.empty())
        throw Error("Vulkan validation", renderer().stats().device.name,
                    std::to_string(messages.size()) + " messages, the first: " + messages.front());
}

double WindowSession::step(double longest) {
    // The frame uses the newest input, not that from before the wait.
    viewer().frames().await(now());
    window_.handleEvents(0);
    tellRecording();
    viewer().schedule().setDisplayInterval(1 / window_.refreshRate());
    const double wake = session_.step(now(), [this] {
        const Overlay* overlay = panel_->draw(viewer(), window_.size(), now());
        if (panel_->glyphsChanged()) renderer().setOverlayGlyphs(panel_->glyphs());
        return overlay;
    });
    inputs_.frameDrawn(panel_->input());
    if (panel_->textPercent() != textPercent_) rescaled(), viewer().schedule().overlayChanged();
    const bool shown = renderer().stats().windowFrames != shown_;
    if (shown) {
        shown_ = renderer().stats().windowFrames;
        lastShown_ = now();
        if (sceneShown_ == 0 && viewer().document()) sceneShown_ = lastShown_;
        if (inputAt_ > 0) latencies_.push_back(1000 * (lastShown_ - inputAt_));
    }
    inputAt_ = 0;  // the pending input changed nothing
    window_.setTitle(printable(viewer().title()));
    if (panel_->restless()) viewer().schedule().overlayChanged();
    // Frames at the display's rate; checks of the bake may be more frequent.
    const double soonest = shown ? lastFrame_ + 0.95 / window_.refreshRate() : now();
    if (!panel_->restless() && std::isinf(wake) && drawSample()) return 0;
    const double next = std::max(panel_->restless() ? now() : wake, soonest);
    const double due = std::isinf(wake) && !panel_->restless() ? wake : next - now();
    window_.handleEvents(std::min(due, longest));
    lastFrame_ = now();
    takeChosen();
    return due;
}

/// Handles the result of a dialog.
void WindowSession::takeChosen() {
    std::vector<std::string> paths;
    std::string savePath;
    PathChosen whereChosen;
    {
        const std::lock_guard lock(chosen_->mutex);
        paths.swap(chosen_->paths);
        savePath.swap(chosen_->savePath);
        if (!savePath.empty()) whereChosen.swap(chosen_->whereChosen);
    }
    if (!savePath.empty() && whereChosen) whereChosen(savePath);
    if (paths.empty()) return;
    const bool beside = panel_->opensTogether();
    panel_->closeTop();
    openFiles(std::move(paths), beside);
}

void WindowSession::openFiles(std::vector<std::string> paths, bool beside) {
    for (std::string& path : paths) path = lasting(path);
    if (!beside) rememberFile();
    viewer().open(paths, beside, now());
}

/// Structures may be added to the current scene: the user decides.
void WindowSession::dropFiles(const std::vector<std::string>& paths) {
    const bool beside = panel_->opensTogether();
    while (panel_->closeTop()) {
    }
    const bool structures = std::any_of(paths.begin(), paths.end(),
                                        [](const auto& path) { return detectKind(path) == FileKind::structure; });
    if (!viewer().document() || !structures || beside) return openFiles(paths, beside);
    panel_->askToOpen(paths);
    viewer().schedule().overlayChanged();
}

/// @param before  the panel that it replaces; null: none
std::unique_ptr<Panel> WindowSession::makePanel(const Panel* before) {
    const int text = before ? before->textPercent() : remembered_.textPercent;
    auto panel = std::make_unique<Panel>(window_.pixelsPerPoint(), panelHost(), PanelHand::mouse, text);
    panel->setBrightness(before ? before->brightness() : remembered_.brightness);
    panel->setDarkCanvas(before ? before->darkCanvas() : remembered_.darkCanvas);
    if (before) panel->showPage(before->page());
    if (before && !before->panelOpen()) panel->togglePanel();
    textPercent_ = text;
    return panel;
}

/// The given size, else that of the last window.
PixelSize WindowSession::firstSize() const {
    if (remembered_.width > 0 && !options_.first.given.contains("size")) return {remembered_.width, remembered_.height};
    return {options_.first.size.width, options_.first.size.height};
}

void WindowSession::keepWindowState() {
    WindowState state = remembered_;
    if (!window_.isFullScreen()) {
        const auto points = [this](std::uint32_t pixels) {
            return static_cast<std::uint32_t>(std::lround(pixels / window_.pixelsPerPoint()));
        };
        state.width = points(window_.size().width), state.height = points(window_.size().height);
    }
    state.brightness = panel_->brightness();
    state.darkCanvas = panel_->darkCanvas();
    state.textPercent = panel_->textPercent();
    state.panelOpen = panel_->panelOpen();
    saveWindowState(state);
}

PanelHost WindowSession::panelHost() {
    PanelHost host;
    host.run = [this](ViewerCommand command) { run(command); };
    host.browses = !FileDialog::available();
    if (!host.browses) {
        host.openDialog = [this] { openDialog(); };
        host.saveDialog = [this](const std::string& title, const std::string& suggested, PathChosen chosen) {
            saveDialog(title, suggested, std::move(chosen));
        };
    }
    host.open = [this](const std::vector<std::string>& inputs, bool beside) { openFiles(inputs, beside); };
    host.recent = [this]() -> const std::vector<RecentFile>& { return recent_.files(); };
    host.samples = [this]() -> const std::vector<RecentFile>& { return shownSamples_; };
    if (options_.restore)
        if (const auto saved = loadState(); saved && !saved->input.path.empty() && saved->input.path != "-") {
            host.lastView = std::filesystem::path(saved->input.path).filename().string();
            host.goOn = [this, view = *saved] { viewer().show(view, now()); };
        }
    host.freeName = [this](const char* extension) { return pictureName(extension); };
    host.savePicture = [this](const PictureWish& wish) { savePicture(wish); };
    host.savesScenes = true;
    host.record = [this](const RecordingWish& wish, const std::vector<PictureDescription>& keys) {
        record(wish, keys);
    };
    host.recording = [this] { return recorder_.state(); };
    host.stopRecording = [this] { recorder_.stop(); };
    host.videos = hasProgram("ffmpeg");
    host.quit = [this] { window_.close(); };
    host.saveAndQuit = [this] {
        saveView();
        quitsOnceSaved_ = true;
    };
    host.copyPicture = [this] { run(ViewerCommand::copyPicture); };
    host.clipboard = [this] { return (clipboard_ = window_.clipboard()).c_str(); };
    host.setClipboard = [this](const char* text) { window_.setClipboard(text); };
    host.downloads = true;
    host.scalesText = true;
    host.captures = options_.first.device.capture;
    host.statistics = [this] { return session_.statistics(); };
    host.copyReport = [this] {
        window_.setClipboard(session_.report("desktop").c_str());
        viewer().messages().say("Report copied", now());
    };
    host.dark = dark_;
    host.fontWith = systemFontWith;
    return host;
}

SessionHost WindowSession::host() {
    SessionHost host;
    host.device = [this] {
        DeviceOptions device = options_.first.device;
        device.selfTests = cacheFolder(options_.first.input.cache, "devices");
        device.surface = window_.surface();
        return device;
    };
    host.loadPipelines = [] { return loadPipelineCache(); };
    host.keepPipelines = savePipelineCache;
    host.prepare = [this](Renderer& renderer) { renderer.setOverlayGlyphs(panel_->glyphs()); };
    host.lost = sayWarning;
    return host;
}

PictureDescription WindowSession::firstView() const {
    PictureDescription view = options_.first;
    view.aim = {};  // the viewer receives the aim separately
    view.aim.uncover = options_.first.aim.uncover;
    view.input.path = lasting(view.input.path);
    view.view = lasting(view.view);
    for (FurtherInput& further : view.input.further) further.path = lasting(further.path);
    return view;
}

ViewerOptions WindowSession::viewerOptions() const {
    ViewerOptions options;
    options.occlusionBytes = options_.first.occlusion.bytes();
    options.occlusionCache = cacheFolder(options_.first.input.cache, "occlusion");
    options.tuning = options_.first.tuning;
    options.errorsStay = true;
    return options;
}

/// Records the first input that the next frame answers.
void WindowSession::input(InputQueue::Kind kind, std::function<void()> handle) {
    if (inputAt_ == 0) inputAt_ = now();
    inputs_.add(panel_->input(), kind, std::move(handle));
    if (kind == InputQueue::Kind::key) viewer().schedule().overlayChanged();
}

WindowEvents WindowSession::events() {
    WindowEvents e;
    e.resized = [this] { resized(); };
    e.iconified = [this](bool iconified) {
        if (!iconified) return viewer().resume(now());
        viewer().pause();
        saveState(viewer().restartView());
    };
    e.damaged = [this] { viewer().schedule().overlayChanged(); };
    using Kind = InputQueue::Kind;
    e.pointer = [this](glm::dvec2 at) {
        input(Kind::pointer, [this, at] {
            pointer_ = at;
            panel_->input().pointer(at);
            if (panelDrag_ || panel_->input().ownsPointer())
                viewer().picking().pointerLeft();
            else
                viewer().mouseMove(at / scale_, now());
        });
    };
    e.button = [this](MouseButton button, bool down, Modifiers with) {
        input(Kind::pointer, [this, button, down, with] {
            // The receiver of a press also gets its release.
            if (down) panelDrag_ = panel_->input().ownsPointer();
            if (panelDrag_)
                panel_->input().button(button, down);
            else
                viewer().mouseButton(button, down, pointer_ / scale_, with, now());
            if (!down) panelDrag_ = false;
        });
    };
    e.wheel = [this](double steps, Modifiers with) {
        input(Kind::pointer, [this, steps, with] {
            if (panel_->input().ownsPointer())
                panel_->input().wheel(steps);
            else if (with.control)
                viewer().changeLevel(steps, now());
            else
                viewer().wheel(steps, pointer_ / scale_, now());
        });
    };
    const auto command = [this](const std::optional<ViewerCommand>& of) {
        if (of) run(*of);
    };
    e.special = [this, command](SpecialKey key, bool down, bool repeated, Modifiers with) {
        if (repeated && !inputs_.empty()) return;  // a held key must not get ahead of the frames
        input(Kind::key, [=, this] { command(panel_->input().press(key, down, with)); });
    };
    e.character = [this, command](char32_t c) { input(Kind::key, [=, this] { command(panel_->input().type(c)); }); };
    e.shortcut = [this, command](const KeyEvent& key) {
        input(Kind::key, [=, this] { command(panel_->input().press(key)); });
    };
    e.closing = [this] { quit(); };
    e.dropped = [this](const std::vector<std::string>& paths) { dropFiles(paths); };
    return e;
}

/// Text has another size, by the display's density or the user's choice: recreates the panel.
void WindowSession::rescaled() {
    scale_ = window_.pixelsPerPoint();
    panel_ = makePanel(panel_.get());
    viewer().words().setTextPercent(textPercent_);
    renderer().setOverlayGlyphs(panel_->glyphs());
}

void WindowSession::resized() {
    const PixelSize size = window_.size();
    if (size.width == 0 || size.height == 0) return viewer().pause();
    if (window_.pixelsPerPoint() != scale_) rescaled();
    viewer().frames().resize(size, scale_, now());
    viewer().resume(now());
}

void WindowSession::run(ViewerCommand command) {
    viewer().schedule().overlayChanged();
    switch (command) {
        case ViewerCommand::panel:
            return panel_->togglePanel();
        case ViewerCommand::help:
            return panel_->toggleHelp();
        case ViewerCommand::palette:
            return panel_->showPalette();
        case ViewerCommand::fullScreen:
            return window_.toggleFullScreen();
        case ViewerCommand::openFile:
            return panel_->showStart();
        case ViewerCommand::record:
            return viewer().document() ? panel_->showRecord() : void();
        case ViewerCommand::keepView:
            if (!viewer().document()) return;
            panel_->keepView(viewer());
            return viewer().messages().say(
                "added as keyframe " + std::to_string(panel_->keptViews()) + " (Shift R records)", now());
        case ViewerCommand::saveAs:
            return viewer().document() ? panel_->showSave() : void();
        case ViewerCommand::clearPicks:
            if (panel_->closeTop()) return;
            break;
        case ViewerCommand::quit:
            return quit();
        case ViewerCommand::savePicture:
            if (!viewer().document()) return;
            return savePicture({window_.size(), false, pictureName(".png")});
        case ViewerCommand::copyPicture:
            return copyPicture();
        case ViewerCommand::saveView:
            return saveView();
        case ViewerCommand::saveScene:
            return saveScene();
        case ViewerCommand::captureFrame:
            return captureFrame();
        default:
            break;
    }
    viewer().run(command, now());
}

/// Asks first if anything would be lost. A second request confirms.
void WindowSession::quit() {
    std::string unsaved;
    quitsOnceSaved_ = false;
    if (recorder_.state().running) unsaved += "The movie is still being recorded. ";
    if (const std::size_t keys = panel_->unrecordedViews())
        unsaved +=
            (keys == 1 ? "1 keyframe was" : std::to_string(keys) + " keyframes were") + std::string(" not recorded. ");
    if (viewer().hasUnsavedWork()) unsaved += "Labels, measurements or rules are not in a saved view. ";
    if (unsaved.empty() || panel_->asksToQuit()) return window_.close();
    panel_->askToQuit(unsaved);
    viewer().schedule().overlayChanged();
}

void WindowSession::openDialog() {
    dialog_.open([chosen = chosen_](const std::vector<std::string>& paths) {
        {
            const std::lock_guard lock(chosen->mutex);
            chosen->paths = paths;
        }
        Window::wake();
    });
}

void WindowSession::saveDialog(const std::string& title, const std::string& suggested, PathChosen whereChosen) {
    {
        const std::lock_guard lock(chosen_->mutex);
        chosen_->whereChosen = std::move(whereChosen);
    }
    dialog_.save(title, suggested, [chosen = chosen_](const std::vector<std::string>& paths) {
        {
            const std::lock_guard lock(chosen->mutex);
            chosen->savePath = paths.front();
        }
        Window::wake();
    });
}

}  // namespace nacre::app
