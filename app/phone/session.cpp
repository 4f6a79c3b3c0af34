#include "app/phone/session.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <thread>
#include <utility>

#include "app/download/molecule_sources.h"
#include "app/input/read_input.h"
#include "app/viewer/kept_files.h"
#include "engine/error.h"
#include "engine/srgb.h"

namespace nacre::app {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::string_view kSample = "sample:";

/// A path in the cache folder; empty without one.
std::string kept(const PhoneHost& host, const char* name) {
    return host.cache.empty() ? std::string() : host.cache + "/" + name;
}

ViewerOptions viewerOptions(const PhoneHost& host) {
    ViewerOptions options;
    options.occlusionCache = kept(host, "occlusion");
    options.errorsStay = true;
    return options;
}

/// A view from another app or session asks before it downloads.
InputOptions makeInput(const PhoneHost& host, const PictureDescription& first) {
    InputOptions input;
    input.path = first.input.path;
    if (!first.input.path.empty()) input.namedBy = "the last view";
    input.cache = host.cache.empty() ? "off" : host.cache;
    input.memoryMegabytes = static_cast<std::int64_t>(memoryShare(4) >> 20);
    return input;
}

}  // namespace

PhoneSession::PhoneSession(PhoneHost host, const PictureDescription& first, double pixelsPerPoint)
    : host_(std::move(host)),
      session_(sessionHost(), phoneSources(makeInput(host_, first), host_.readFile), first, viewerOptions(host_),
               host_.wake) {
    scale_ = pixelsPerPoint;
    makePanel();
    viewer().pause();
}

SessionHost PhoneSession::sessionHost() {
    SessionHost session;
    session.device = [this] {
        DeviceOptions device{.validate = host_.validate, .surface = host_.surface, .selfTests = kept(host_, "devices")};
        return device;
    };
    session.loadPipelines = [this] { return loadPipelineCache(kept(host_, "pipelines.bin")); };
    session.keepPipelines = [this](const std::vector<std::byte>& data) {
        keepPipelineCache(kept(host_, "pipelines.bin"), data);
    };
    session.prepare = [this](Renderer& renderer) { renderer.setOverlayGlyphs(panel_->glyphs()); };
    session.lost = host_.log;
    session.windowMayGo = host_.windowMayGo;
    return session;
}

void PhoneSession::makePanel() {
    panel_.reset();
    PanelHost host;
    host.run = [this](ViewerCommand command) { run(command); };
    host.openDialog = host_.pickDocument;
    host.askText = host_.askText;
    host.downloads = host_.downloads;
    host.fontWith = systemFontWith;
    host.statistics = [this] { return session_.statistics(); };
    if (host_.copyText)
        host.copyReport = [this] {
            host_.copyText(session_.report(host_.system));
            viewer().messages().say("Report copied", now());
        };
    host.dark = host_.dark;
    host.shakes = host_.shakes;
    panel_ = std::make_unique<Panel>(scale_ * textScale_, std::move(host), PanelHand::fingers);
    panel_->setInsets(insets_);
}

/// Redraws text at its size.
void PhoneSession::remakePanel() {
    makePanel();
    if (Renderer* held = session_.renderer()) held->setOverlayGlyphs(panel_->glyphs());
    viewer().schedule().overlayChanged();
}

/// The panel's points scale with its text.
TouchEvent PhoneSession::onPanel(const TouchEvent& event) const {
    return {event.finger, event.phase, event.at / textScale_};
}

// --- the window

void PhoneSession::resize(PixelSize pixels, double pixelsPerPoint) {
    if (std::exchange(scale_, pixelsPerPoint) != pixelsPerPoint) remakePanel();
    if (pixels.width && pixels.height) viewer().frames().resize(pixels, scale_, now());
}

void PhoneSession::setTextScale(double scale) {
    constexpr double kSmallest = 0.8, kLargest = 2;  // the panel does not fit beyond these
    const double taken = std::clamp(scale, kSmallest, kLargest);
    if (std::exchange(textScale_, taken) != taken) remakePanel();
}

void PhoneSession::setInsets(const Insets& insets) {
    insets_ = insets;
    panel_->setInsets(insets);
    viewer().schedule().overlayChanged();
}

void PhoneSession::setSeen(bool seen) {
    seen_ = seen;
    session_.setIdleTests(seen);
    if (!seen) return viewer().pause();
    if (session_.renderer()) return viewer().resume(now());
    if (!host_.windowMayGo) {
        session_.open(now());
        return viewer().resume(now());
    }
    if (session_.opening()) return;
    openedFor_ = windows_;
    session_.openAside();
}

/// Takes the device made on another thread, possibly for a window that has vanished.
void PhoneSession::takeDevice() {
    try {
        if (!session_.takeOpened(now())) return;
    } catch (const Error&) {
        if (openedFor_ == windows_) throw;
        return setSeen(seen_);
    }
    if (openedFor_ != windows_) session_.renderer()->releaseWindow();
    setSeen(seen_);
}

void PhoneSession::awaitDevice() {
    if (!session_.opening()) return;
    session_.awaitOpened();
    takeDevice();
}

bool PhoneSession::awaitSubmitted(double seconds) {
    const auto begin = std::chrono::steady_clock::now();
    const auto left = [&] {
        return seconds - std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const Renderer* held = session_.renderer();
    const bool done = !held || held->awaitSubmitted(seconds);
    while (testing() && left() > 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return done && !testing();
}

void PhoneSession::releaseWindow() {
    ++windows_;
    if (Renderer* held = session_.renderer()) held->releaseWindow();
}

void PhoneSession::lowMemory() {
    viewer().frames().setMostSamples(1);
    if (!seen_ && !session_.opening()) session_.close();
}

// --- the user

void PhoneSession::touch(const TouchEvent& event, double when) {
    if (panel_->input().touch(onPanel(event)))
        viewer().schedule().overlayChanged();
    else
        viewer().touch(event, when);
}

void PhoneSession::mouse(MouseButton button, const TouchEvent& event, Modifiers with, double when) {
    const bool down = event.phase == TouchPhase::began;
    if (down) held_ = button, panelDrag_ = panel_->input().touch(onPanel(event));
    if (panelDrag_) {
        if (!down) panel_->input().touch(onPanel(event));
        return viewer().schedule().overlayChanged();
    }
    if (event.phase == TouchPhase::moved)
        viewer().mouseMove(event.at, when);
    else
        viewer().mouseButton(held_, down, event.at, with, when);
}

void PhoneSession::hover(std::optional<glm::dvec2> at) {
    if (at) panel_->input().pointer(*at * scale_);
    if (!at || panel_->input().ownsPointer())
        viewer().picking().pointerLeft();
    else
        viewer().mouseMove(*at, now());
}

void PhoneSession::run(ViewerCommand command) {
    viewer().schedule().overlayChanged();
    switch (command) {
        case ViewerCommand::panel:
            return panel_->togglePanel();
        case ViewerCommand::help:
            return panel_->toggleHelp();
        case ViewerCommand::openFile:
            return panel_->showStart();
        case ViewerCommand::saveAs:
        case ViewerCommand::savePicture:
            return sharePicture();
        case ViewerCommand::saveView:
            return shareView();
        case ViewerCommand::clearPicks:
            if (panel_->closeTop()) return;
            break;
        default:
            break;
    }
    viewer().run(command, now());
}

bool PhoneSession::back() {
    const bool closed = panel_->closeTop(), open = !closed && panel_->panelOpen();
    if (open) panel_->togglePanel();
    viewer().schedule().overlayChanged();
    return closed || open;
}

void PhoneSession::typed(const std::string& name, const std::string& text) {
    panel_->input().typed(name, text);
    viewer().schedule().overlayChanged();
}

void PhoneSession::fail(const std::string& text) {
    if (host_.log) host_.log(text);
    viewer().messages().fail(text, now());
}

void PhoneSession::sharePicture() {
    if (!host_.sharePicture || !viewer().document() || !session_.renderer()) return;
    try {
        host_.sharePicture(picture(), shareName() + ".png");
    } catch (const Error& error) {
        viewer().messages().fail(error.what(), now());
    }
}

/// As JSON. Paths differ between devices: includes only the file's name.
void PhoneSession::shareView() {
    if (!host_.shareText || !viewer().document()) return;
    PictureDescription view = viewer().picking().savedView();
    view.input.path = std::filesystem::path(view.input.path).filename().string();
    host_.shareText(savedViewJson(view), shareName() + ".view.json");
}

PictureBytes PhoneSession::picture(std::uint32_t samples) {
    const PixelSize size = viewer().frames().size();
    PictureDescription wanted = viewer().picking().measuredView();
    wanted.size = {size.width, size.height};
    wanted.words.size = viewer().words().size();
    wanted.supersample = samples;
    const Picture picture = viewer().frames().draw(*session_.renderer(), std::move(wanted));
    PictureBytes bytes{picture.width, picture.height, std::vector<std::uint8_t>(picture.rgba.size())};
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) codePixel(&picture.rgba[i], true, &bytes.rgba[i]);
    return bytes;
}

std::string PhoneSession::shareName() const {
    const std::string& input = viewer().view().input.path;
    const std::size_t colon = input.starts_with(kSample) ? kSample.size() : 0;
    std::string name = std::filesystem::path(input.substr(colon)).filename().string();
    if (const std::size_t dot = name.find('.', 1); dot != std::string::npos) name.resize(dot);
    return name.empty() ? "nacre" : name;
}

// --- accessibility

std::vector<Control> PhoneSession::spoken() const {
    Control picture;
    picture.role = "image";
    picture.name = viewer().title();
    picture.value = spokenValue(viewer().picking().annotations());
    picture.seenRight = static_cast<float>(viewer().frames().size().width);
    picture.seenBottom = static_cast<float>(viewer().frames().size().height);
    std::vector<Control> all{picture};
    for (const Control& control : panel_->controls())
        // the picture's value already states it
        if (control.seen() && control.role != "status") all.push_back(control);
    return all;
}

void PhoneSession::tap(glm::dvec2 pixel) {
    touch({0, TouchPhase::began, pixel / scale_}, now());
    touch({0, TouchPhase::ended, pixel / scale_}, now());
}

void PhoneSession::press(const std::string& role, const std::string& name) {
    if (const Control* c = findControl(panel_->controls(), role, name))
        tap(glm::dvec2(c->seenLeft + c->seenRight, c->seenTop + c->seenBottom) / 2.0);
}

void PhoneSession::adjust(const std::string& name, bool up) {
    if (const auto at = placeOfStep(panel_->controls(), name, up)) tap(*at);
}

// --- the loop

double PhoneSession::step() {
    takeDevice();
    if (!seen_ && session_.renderer() && !host_.windowMayGo) return kNever;
    const double time = now();
    const double wake = session_.step(time, [&] {
        const Overlay* overlay = panel_->draw(viewer(), viewer().frames().size(), time);
        if (panel_->glyphsChanged()) session_.renderer()->setOverlayGlyphs(panel_->glyphs());
        return overlay;
    });
    if (!seen_ || !session_.renderer() || !panel_->restless()) return wake;
    viewer().schedule().overlayChanged();
    return time;
}

std::optional<PictureDescription> viewOfState(const std::string& json) {
    try {
        return parseSavedView(json, "the last view");
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::string spokenValue(const Annotations& annotations) {
    std::string text;
    for (const std::string* part :
         {&annotations.error, &annotations.atom, &annotations.measurement, &annotations.message})
        if (!part->empty()) text += (text.empty() ? "" : ". ") + *part;
    return text;
}

}  // namespace nacre::app
