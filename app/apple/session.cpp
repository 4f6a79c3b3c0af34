#include "app/apple/session.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "app/download/molecule_sources.h"
#include "app/shared/molecules.h"
#include "app/shared/srgb.h"

namespace nacre::app {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::string_view kSample = "sample:";

ViewerOptions viewerOptions(const std::string& occlusionCache) {
    ViewerOptions options;
    options.occlusionCache = occlusionCache;
    options.errorsStay = true;
    return options;
}

/// A view that came from elsewhere, or was kept, asks before it downloads.
InputOptions inputOf(const MoleculeHost& host, const SavedView& first) {
    InputOptions input;
    input.path = first.input;
    if (!first.input.empty()) input.namedBy = "the view";
    const std::filesystem::path folder = host.occlusionCache;
    input.cache = folder.empty() ? "off" : folder.parent_path().string();
    input.memoryMegabytes = static_cast<std::int64_t>(memoryShare(4) >> 20);
    return input;
}

}  // namespace

SessionHost MoleculeSession::sessionHost() {
    SessionHost session;
    session.device = [this] {
        DeviceOptions device;
        device.validate = host_.validate;
        device.surface = host_.surface;
        const std::filesystem::path folder = host_.occlusionCache;
        if (!folder.empty()) device.selfTests = (folder.parent_path() / "devices").string();
        return device;
    };
    session.loadPipelines = host_.loadPipelines;
    session.keepPipelines = host_.keepPipelines;
    session.prepare = [this](Renderer& renderer) { renderer.setOverlayGlyphs(panel_->glyphs()); };
    return session;
}

MoleculeSession::MoleculeSession(MoleculeHost host, const SavedView& first)
    : host_(std::move(host)),
      session_(sessionHost(), phoneSources(inputOf(host_, first), host_.readFile), first,
               viewerOptions(host_.occlusionCache), host_.wake) {
    makePanel(scale_);
    session_.open(0);
}

void MoleculeSession::makePanel(double pixelsPerPoint) {
    scale_ = pixelsPerPoint;
    PanelHost host;
    // A panel has no clock: what its buttons do happens at the time of the frame that they are pressed in.
    host.run = [this](ViewerCommand command) { run(command, viewer().lastUpdate()); };
    host.openDialog = host_.pickDocument;
    host.statistics = [this] { return session_.statistics(); };
    host.dark = host_.dark;
    host.askText = host_.askText;
    host.downloads = host_.downloads;
    host.shakes = true;
    panel_ = std::make_unique<Panel>(pixelsPerPoint, std::move(host), PanelHand::fingers);
}

void MoleculeSession::resize(PixelSize pixels, double pixelsPerPoint, double now) {
    if (pixels.width == 0 || pixels.height == 0) return;
    if (pixelsPerPoint != scale_) {
        makePanel(pixelsPerPoint);
        if (Renderer* held = session_.renderer()) held->setOverlayGlyphs(panel_->glyphs());
    }
    viewer().resize(pixels, pixelsPerPoint, now);
}

void MoleculeSession::setInsets(const Insets& insets) {
    panel_->setInsets(insets);
    viewer().overlayChanged();
}

void MoleculeSession::touch(const TouchEvent& event, double now) {
    if (panel_->touch(event))
        viewer().overlayChanged();
    else
        viewer().touch(event, now);
}

void MoleculeSession::mouse(MouseButton button, const TouchEvent& event, Modifiers with, double now) {
    const bool down = event.phase == TouchPhase::began;
    if (down) panelDrag_ = panel_->touch(event);
    if (panelDrag_) {
        if (!down) panel_->touch(event);
        return viewer().overlayChanged();
    }
    if (event.phase == TouchPhase::moved)
        viewer().mouseMove(event.at, now);
    else
        viewer().mouseButton(button, down, event.at, with, now);
}

void MoleculeSession::typed(const std::string& name, const std::string& text) {
    panel_->typed(name, text);
    viewer().overlayChanged();
}

void MoleculeSession::run(ViewerCommand command, double now) {
    viewer().overlayChanged();
    switch (command) {
        case ViewerCommand::panel:
            return panel_->togglePanel();
        case ViewerCommand::help:
            return panel_->toggleHelp();
        case ViewerCommand::openFile:
            return panel_->showStart();
        case ViewerCommand::saveAs:
        case ViewerCommand::savePicture:
            if (host_.share && viewer().document()) host_.share(ViewerCommand::savePicture);
            return;
        case ViewerCommand::saveView:
            if (host_.share) host_.share(command);
            return;
        case ViewerCommand::clearPicks:
            if (panel_->closeTop()) return;
            break;
        default:
            break;
    }
    viewer().run(command, now);
}

std::vector<Control> MoleculeSession::spoken() const {
    Control picture;
    picture.role = "image";
    picture.name = viewer().title();
    picture.value = spokenValue(viewer().annotations());
    picture.seenRight = static_cast<float>(viewer().size().width);
    picture.seenBottom = static_cast<float>(viewer().size().height);
    std::vector<Control> all{picture};
    for (const Control& control : panel_->controls())
        if (control.seen() && control.role != "status") all.push_back(control);  // the picture's value has that
    return all;
}

void MoleculeSession::tap(glm::dvec2 pixel, double now) {
    touch({0, TouchPhase::began, pixel / scale_}, now);
    touch({0, TouchPhase::ended, pixel / scale_}, now);
}

void MoleculeSession::press(const std::string& role, const std::string& name, double now) {
    if (const Control* c = findControl(panel_->controls(), role, name))
        tap(glm::dvec2(c->seenLeft + c->seenRight, c->seenTop + c->seenBottom) / 2.0, now);
}

void MoleculeSession::adjust(const std::string& name, bool up, double now) {
    if (const auto at = placeOfStep(panel_->controls(), name, up)) tap(*at, now);
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

double MoleculeSession::step(double now) {
    if (!foreground_ || !holdsDevice()) return kNever;
    const double wake = session_.step(now, [&] {
        const Overlay* overlay = panel_->draw(viewer(), viewer().size(), now);
        if (panel_->glyphsChanged()) session_.renderer()->setOverlayGlyphs(panel_->glyphs());
        return overlay;
    });
    if (!panel_->restless()) return wake;
    viewer().overlayChanged();
    return now;
}

PictureBytes MoleculeSession::picture(std::uint32_t samples) {
    RenderSettings settings = viewer().pictureWithWords(viewer().size(), viewer().textSize());
    settings.supersample = samples;
    Picture picture = session_.renderer()->render(settings);
    viewer().paintWords(settings.view, viewer().textSize(), false, picture);
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
    for (const std::string* part :
         {&annotations.error, &annotations.atom, &annotations.measurement, &annotations.message})
        if (!part->empty()) text += (text.empty() ? "" : ". ") + *part;
    return text;
}

}  // namespace nacre::app
