#include "app/viewer/frames.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "app/drawing/focus.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kOutlinePoints = 2;  // width of the outline of marked atoms

/// A small molecule in a style: a cartoon requires a backbone.
Representation standIn(RepresentationOptions look, Style style) {
    look.style = style;
    look.rules.clear();
    look.assembly.clear();
    const Molecule m = sampleMolecule(style == Style::cartoon ? "dna" : "glucose");
    return represent(m, drawnAtoms(m), look);
}

bool isSize(PixelSize a, PixelSize b) { return a.width == b.width && a.height == b.height; }

/// A view with margins. @param corner  of the view in the whole, pixels
View wholePart(View view, const glm::dvec2& corner, std::uint32_t width, std::uint32_t height) {
    const glm::dvec2 from = glm::dvec2(width, height) / 2.0, to = corner + glm::dvec2(view.width, view.height) / 2.0;
    view.pan += glm::dvec2(to.x - from.x, from.y - to.y) / view.pixelsPerAngstrom;
    view.width = width;
    view.height = height;
    return view;
}

/// The atom visible at a point, or the nearest one within a reach; 0: none.
std::uint32_t nearestSeen(const std::vector<std::uint32_t>& atoms, PixelSize size, glm::dvec2 at, double reach) {
    std::uint32_t atom = 0;
    double nearest = reach * reach + 0.5;
    const auto first = [&](double place) {
        return static_cast<std::uint32_t>(std::max(std::floor(place - reach), 0.0));
    };
    for (std::uint32_t y = first(at.y); y < size.height && y <= at.y + reach; ++y)
        for (std::uint32_t x = first(at.x); x < size.width && x <= at.x + reach; ++x) {
            const glm::dvec2 away = glm::dvec2(x, y) - glm::floor(at);
            const double distance = glm::dot(away, away);
            const std::uint32_t here = atoms[std::size_t{y} * size.width + x];
            if (here == 0 || distance >= nearest) continue;
            nearest = distance;
            atom = here;
        }
    return atom;
}

}  // namespace

// --- the window

void Frames::resize(PixelSize pixels, double pixelsPerPoint, double now) {
    size_ = {std::max(pixels.width, 1u), std::max(pixels.height, 1u)};
    scale_ = pixelsPerPoint;
    stage_.changed(now);
}

void Frames::setCovered(const Insets& pixels, double now) {
    if (pixels == covered_) return;
    covered_ = pixels;
    stage_.changed(now);
}

PixelSize Frames::freeSize() const {
    const auto left = [](std::uint32_t side, float covered) {
        return static_cast<std::uint32_t>(std::max(static_cast<float>(side) - covered, 1.0f));
    };
    return {left(size_.width, covered_.left + covered_.right), left(size_.height, covered_.top + covered_.bottom)};
}

// --- the picture

RenderSettings Frames::settings() const {
    RenderSettings s = pictureSettings(freeSize());
    // From the window's centre to that of the free area.
    s.view = wholePart(s.view, freeCorner(), size_.width, size_.height);
    if (stage_.shown()) s.view = oneEyeView(s.view, stage_.view().stereo);
    return s;
}

std::vector<FreePart> Frames::freeParts() const {
    const Stereo& stereo = stage_.view().stereo;
    const PixelSize free = freeSize();
    const glm::ivec2 window(size_.width, size_.height);
    if (!stereo.both() || !stage_.shown()) {
        View view = pictureSettings(free).view;
        if (stage_.shown()) view = oneEyeView(view, stereo);
        return {{view, freeCorner(), {0, 0}, window}};
    }
    const Size size = eyeSize(stereo, {free.width, free.height});
    const View middle = pictureSettings({size.width, size.height}).view;
    if (stereo.mode == Stereo::Mode::anaglyph)
        return {{eyeView(middle, stereo, Eye::left), freeCorner(), {0, 0}, window, OverlayEye::left},
                {eyeView(middle, stereo, Eye::right), freeCorner(), {0, 0}, window, OverlayEye::right}};
    // The eyes share the free area. Each part extends beyond it by the larger of both margins.
    const int axis = stereo.beside() ? 0 : 1;
    const int border = static_cast<int>(freeCorner()[axis]) +
                       (axis == 0 ? static_cast<int>(size.width) : static_cast<int>(size.height));
    glm::ivec2 whole = window;
    whole[axis] = std::max(border, window[axis] - border);
    std::vector<FreePart> parts;
    for (const Eye eye : kEyes) {
        const bool second = (eye == Eye::right) != (stereo.mode == Stereo::Mode::crossEyed);
        FreePart part{eyeView(middle, stereo, eye), freeCorner(), {0, 0}, whole};
        if (second) part.corner[axis] = border;
        part.from[axis] = second ? border : border - whole[axis];
        parts.push_back(part);
    }
    return parts;
}

std::optional<std::array<WindowEye, 2>> Frames::eyes() const {
    const Stereo& stereo = stage_.view().stereo;
    if (!stereo.both() || !stage_.shown()) return std::nullopt;
    std::array<WindowEye, 2> eyes;
    const std::vector<FreePart> parts = freeParts();
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& [view, corner, from, size, overlay] = parts[i];
        eyes[i] = {wholePart(view, corner - glm::dvec2(from), static_cast<std::uint32_t>(size.x),
                             static_cast<std::uint32_t>(size.y)),
                   from.x, from.y};
    }
    if (stereo.mode == Stereo::Mode::anaglyph) eyes[0].channels = kAnaglyphLeft, eyes[1].channels = kAnaglyphRight;
    eyes[0].view = paired(eyes[0].view, eyes[1].view);
    return eyes;
}

RenderSettings Frames::pictureSettings(PixelSize size) const {
    const PictureDescription& view = stage_.view();
    const Document& document = stage_.document;
    RenderSettings s = document.drawing.settingsFor(view, view.camera, {size.width, size.height});
    if (stage_.shown()) focusLens(*document.placed, view, document.drawing.scene().center, s);
    setUp(s);
    return s;
}

/// Settings determined by the device and its user.
void Frames::setUp(RenderSettings& s) const {
    s.occlusion.bytes = options_.occlusionBytes;
    s.occlusion.cache = options_.occlusionCache;
    s.tuning = options_.tuning;
    s.debug = debug_;
}

const RenderSettings& Frames::compose(PictureDescription picture) {
    picture.aim.placed = picture.camera.isPlaced();
    Drawing& drawing = stage_.document.drawing;
    drawing.compose(picture);
    setUp(drawing.settings);
    return drawing.settings;
}

Picture Frames::draw(Renderer& renderer, PictureDescription picture, bool marked) {
    picture.debug = debug_;
    marked = marked && !picture.stereo.both();
    RenderSettings drawn = compose(std::move(picture));
    if (!marked) return stage_.document.drawing.drawAs(drawn, renderer);
    drawn.view = oneEyeView(drawn.view, stage_.document.drawing.stereo());
    Picture image = renderer.render(drawn);
    const PixelSize size{drawn.view.width, drawn.view.height};
    const double enlarged =
        std::min(size.width, size.height) / static_cast<double>(std::min(size_.width, size_.height));
    paintMarks(makeOutline(renderer.atoms(drawn), size, {marks_.selected}, kOutlinePoints * scale_ * enlarged), image);
    stage_.document.drawing.addWords(drawn, image);
    return image;
}

glm::dvec2 Frames::projectPoint(const glm::dvec3& place, const View& view) const {
    const glm::dvec3 v = view.seen(place);
    const double magnify =
        view.projection == Projection::perspective ? view.eyeDistance / (view.eyeDistance - v.z) : 1.0;
    const glm::dvec2 q = (glm::dvec2(v) * magnify + view.pan) * view.pixelsPerAngstrom;
    return {(view.width / 2.0 + q.x) / scale_, (view.height / 2.0 - q.y) / scale_};
}

std::optional<std::uint32_t> Frames::atomAt(glm::dvec2 at, double reach, double now) {
    if (!stage_.shown() || !sceneThere_) return std::nullopt;
    if (seenAt_ == stage_.changes() && isSize(seenSize_, size_) && !seen_.empty())
        return nearestSeen(seen_, size_, at * scale_, reach * scale_);
    try {
        RenderSettings s = settings();
        glm::dvec2 pixel = at * scale_;
        if (const auto both = eyes(); both && stage_.view().stereo.mode != Stereo::Mode::anaglyph) {
            const auto isAt = [&](const WindowEye& eye) { return pixel.x >= eye.x && pixel.y >= eye.y; };
            const std::size_t second = (*both)[0].x + (*both)[0].y > (*both)[1].x + (*both)[1].y ? 0 : 1;
            const WindowEye& eye = (*both)[isAt((*both)[second]) ? second : 1 - second];
            s.view = eye.view;
            pixel -= glm::dvec2(eye.x, eye.y);
        }
        return screen_.atomAt(s, pixel.x, pixel.y, reach * scale_);
    } catch (const Error& error) {
        if (!noticeLoss()) stage_.messages.say(error.what(), now);
        return std::nullopt;
    }
}

void Frames::setDebugView(DebugView view, double now) {
    debug_ = view;
    stage_.changed(now);
}

void Frames::keepSharp(double seconds, double leastScale) {
    stage_.schedule.setLongestFrame(seconds);
    stage_.schedule.setLeastScale(leastScale);
    tellsScale_ = true;
}

std::string Frames::coarseness() const {
    if (!tellsScale_ || frame_.scale >= 1) return {};
    return "Reduced resolution while moving (" + std::to_string(std::lround(100 * frame_.scale)) + " %)";
}

std::uint32_t Frames::refinedSamples() const {
    constexpr std::uint32_t kThroughLens = 8;  // each through another point of the lens
    if (debug_ != DebugView::none) return 1;   // numbers cannot be averaged
    const std::uint32_t n = stage_.view().effects.depthOfField.strength > 0 ? kThroughLens : options_.mostSamples;
    return n * n;
}

// --- the scene

bool Frames::put(Representation scene, void (Screen::*how)(Representation)) {
    try {
        (screen_.*how)(std::move(scene));
        sceneThere_ = true;
    } catch (const Error&) {
        if (!noticeLoss()) throw;
        sceneThere_ = false;
    }
    return sceneThere_;
}

void Frames::setMarks(Highlights marks) {
    constexpr double kSlow = 300;  // milliseconds per frame; the first mark in a view would delay it by that
    if (screen_.frameMilliseconds() > kSlow) marks.hovered = 0;
    if (marks == marks_) return;
    marks_ = std::move(marks);
    marksDue_ = true;
    stage_.schedule.overlayChanged();
}

/// Computes the outline of the marked atoms from the atom in each pixel. A view at rest is drawn for that once; in
/// motion, with fewer pixels, and only if the device needs a fraction of a frame for it.
void Frames::findMarks(bool moving) {
    constexpr double kMostMilliseconds = 8;
    constexpr std::uint32_t kMovingStep = 2;
    const std::uint32_t step = moving ? kMovingStep : 1;
    const PixelSize size{std::max(size_.width / step, 1u), std::max(size_.height / step, 1u)};
    const bool fresh = seenAt_ == stage_.changes() && isSize(seenSize_, size);
    if (fresh && !marksDue_) return;
    const double pixels = static_cast<double>(size.width) * size.height;
    // Two eyes would see it at different places.
    const bool shows = marks_.any() && stage_.shown() && sceneThere_ && !lost_ && !stage_.view().stereo.both() &&
                       (!moving || (seenMilliseconds_ > 0 && seenMilliseconds_ * pixels < kMostMilliseconds));
    if (!shows && shownMarks_.spans.empty() && !marksDue_) return;
    marksDue_ = false;
    shownMarks_ = {{}, step};
    if (!shows) return;
    if (!fresh) {
        RenderSettings s = settings();
        s.view.width = size.width, s.view.height = size.height;
        s.view.pixelsPerAngstrom /= step;
        try {
            SeenAtoms seen = screen_.atoms(s);
            seen_ = std::move(seen.atoms);
            seenMilliseconds_ = seen.milliseconds / pixels;
        } catch (const Error&) {
            seen_.clear();  // the frame reports the same error, or is unaffected
            if (noticeLoss()) return;
        }
        seenSize_ = size;
        seenAt_ = stage_.changes();
    }
    shownMarks_.spans = makeOutline(seen_, size, marks_, kOutlinePoints * scale_ / step);
}

/// Puts the document's scene on a screen that lacks it.
void Frames::putScene(double now) {
    restartOcclusion();
    if (sceneThere_) return;
    try {
        Representation scene = stage_.document.drawing.joinedScene();
        screen_.setScene(std::move(scene));
        sceneThere_ = true;
        sceneRetry_.succeeded();
    } catch (const Error& error) {
        failed(error, sceneRetry_, now);
    }
}

void Frames::expectScene(const PictureDescription& coming) {
    std::vector<Style> styles{Style::spacefill, Style::cartoon};  // takeDefaultLook() chooses one
    if (coming.look.style) styles = {*coming.look.style};
    if (styles == expected_) return;
    expected_ = styles;
    RenderSettings s = settings();
    try {
        for (const Style style : styles) {
            Representation like = standIn(coming.look, style);
            Camera camera;
            camera.projection = stage_.view().camera.projection;
            s.view = makeView(camera, like.radius, size_.width, size_.height);
            screen_.expectScene(std::move(like), s, frame_);
        }
    } catch (const Error&) {
        // The next read reports the same error, or is unaffected.
    }
}

void Frames::advanceOcclusion(double now, bool moving, bool playing) {
    try {
        // At rest, every update of the bake draws a frame, which should not cost more than the work that it shows.
        const double shown = std::clamp(2 * screen_.frameMilliseconds(), 50.0, 250.0);
        const OcclusionPace pace = moving ? OcclusionPace{options_.movingMilliseconds, 0, true}
                                          : OcclusionPace{options_.restingMilliseconds, shown, false};
        RenderSettings s = settings();
        s.occlusion.moving = playing;
        occlusion_ = screen_.advanceOcclusion(s, pace);
        occlusionRetry_.succeeded();
        noticeLoss();
    } catch (const Error& error) {
        occlusion_ = 0;  // the previous state is lost
        failed(error, occlusionRetry_, now);
    }
}

// --- frames

FrameSchedule::Next Frames::next(double now, bool moving) const {
    return stage_.schedule.next(now, moving, bakedShare());
}

double Frames::update(double now, bool playing, const std::function<const Overlay*()>& overlay) {
    const bool moving = stage_.moving(now);
    drew_ = false;
    if (!sceneThere_ && sceneRetry_.due(now)) putScene(now);
    if (std::exchange(played_, playing) && !playing) restartOcclusion();  // as in a picture again
    if (stage_.shown() && sceneThere_ && occlusion_ < 1 && occlusionRetry_.due(now))
        advanceOcclusion(now, moving || playing, playing);
    findMarks(moving || playing);
    if (lost_) return now;
    if (!frameRetry_.due(now)) return frameRetry_.at();
    stage_.schedule.setSamples(refinedSamples());
    stage_.schedule.setMeshes(stage_.shown() && !stage_.document.drawing.scene().triangles.empty());
    if (const auto due = next(now, moving); due.draw != Draw::nothing) draw(due, now, moving, overlay);
    const FrameSchedule::Next after = next(now, moving);
    double wake = after.draw != Draw::nothing ? now : after.wake;
    if (after.draw == Draw::nothing && !occlusionRetry_.due(now)) wake = occlusionRetry_.at();
    wake = std::min(wake, now < stage_.handRests() ? stage_.handRests() : kNever);
    if (!sceneThere_) wake = std::min(wake, sceneRetry_.at());
    return frameRetry_.due(now) ? wake : frameRetry_.at();
}

void Frames::await(double now) {
    if (!stage_.schedule.visible() || lost_ || !frameRetry_.due(now)) return;
    if (next(now, stage_.moving(now)).draw != Draw::nothing) screen_.awaitFrame();
}

void Frames::draw(const FrameSchedule::Next& next, double now, bool moving,
                  const std::function<const Overlay*()>& overlay) {
    frame_ = {};
    frame_.quality = next.draw == Draw::live     ? WindowFrame::Quality::live
                     : next.draw == Draw::refine ? WindowFrame::Quality::refined
                                                 : WindowFrame::Quality::kept;
    frame_.scale = next.scale;
    frame_.meshError = next.meshError;
    frame_.samples = refinedSamples();
    frame_.sample = next.sample;
    if (overlay) frame_.overlay = overlay();
    FrameOutcome outcome = FrameOutcome::lost;
    try {
        const RenderSettings s = settings();
        frame_.eyes = eyes();
        outcome = screen_.present(s, frame_);
        frameRetry_.succeeded();
    } catch (const Error& error) {
        return failed(error, frameRetry_, now);
    }
    switch (outcome) {
        case FrameOutcome::shown:
            stage_.schedule.shown(next, now, moving, bakedShare(), screen_.frameMilliseconds() / 1000);
            drew_ = true;
            break;
        case FrameOutcome::resized:
            resize(screen_.windowSize(), scale_, now);
            break;
        case FrameOutcome::hidden:
            stage_.schedule.setVisible(false);  // until Viewer::resume()
            break;
        case FrameOutcome::lost:
            noticeLoss();
            lost_ = true;
            break;
    }
}

void Frames::replaced(double now) {
    lost_ = false;
    if (!loss_.empty()) stage_.messages.say(std::exchange(loss_, {}), now);
    expected_.clear();
    sceneThere_ = !stage_.shown();
    sceneRetry_ = occlusionRetry_ = frameRetry_ = {};
    putScene(now);
    stage_.schedule.windowChanged(now);
}

void Frames::failed(const std::exception& error, Retry& retry, double now) {
    retry.failed(now);
    if (!noticeLoss()) stage_.messages.say(error.what(), now);
}

bool Frames::noticeLoss() {
    const std::string loss = screen_.deviceLoss();
    if (loss.empty()) return false;
    loss_ = loss;
    lost_ = true;
    return true;
}

}  // namespace nacre::app
