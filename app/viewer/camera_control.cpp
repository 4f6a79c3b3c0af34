#include "app/viewer/camera_control.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

#include "app/drawing/aim.h"
#include "app/picture/input_names.h"
#include "engine/error.h"
#include "engine/scene/view/orientation.h"

namespace nacre::app {
namespace {

constexpr double kKeyDegrees = 5, kKeyPoints = 20, kKeyZoom = 1.15;

/// Steps of the keys that move the camera.
struct Step {
    ViewerCommand command;
    glm::dvec2 rotate{}, pan{};  // steps
    double zoom = 1, roll = 0;   // times; steps
};
constexpr Step kSteps[] = {{ViewerCommand::rotateLeft, {-1, 0}},      {ViewerCommand::rotateRight, {1, 0}},
                           {ViewerCommand::rotateUp, {0, -1}},        {ViewerCommand::rotateDown, {0, 1}},
                           {ViewerCommand::panLeft, {}, {-1, 0}},     {ViewerCommand::panRight, {}, {1, 0}},
                           {ViewerCommand::panUp, {}, {0, -1}},       {ViewerCommand::panDown, {}, {0, 1}},
                           {ViewerCommand::zoomIn, {}, {}, kKeyZoom}, {ViewerCommand::zoomOut, {}, {}, 1 / kKeyZoom},
                           {ViewerCommand::rollLeft, {}, {}, 1, -1},  {ViewerCommand::rollRight, {}, {}, 1, 1}};

}  // namespace

bool CameraControl::apply(const Gesture& g, double now) {
    CameraMotion& motion = stage_.motion;
    switch (g.kind) {
        case Gesture::Kind::touched:
            stage_.remember();
            motion.touch();
            return true;
        case Gesture::Kind::rotate:
            motion.rotate(g.by, now);
            stage_.handMoved(now);
            return true;
        case Gesture::Kind::transform:
            motion.pan(g.by, stage_.radius(), frames_.viewport());
            motion.zoom(g.scale, g.at - frames_.freeOrigin(), stage_.radius(), frames_.viewport());
            motion.roll(g.turn);
            stage_.handMoved(now);
            return true;
        case Gesture::Kind::released:
            motion.release(now);
            return true;
        default:
            return false;
    }
}

void CameraControl::hold(const glm::dquat& orientation, double zoom, double now) {
    stage_.motion.hold(orientation, zoom);
    stage_.handMoved(now);
}

bool CameraControl::runByHand(ViewerCommand command, double now) {
    CameraMotion& motion = stage_.motion;
    const Viewport v = frames_.viewport();
    for (const Step& step : kSteps) {
        if (step.command != command) continue;
        stage_.remember();
        if (step.rotate != glm::dvec2()) {
            motion.touch();
            motion.rotate(step.rotate * kKeyDegrees, now);
        }
        if (step.pan != glm::dvec2()) motion.pan(step.pan * kKeyPoints, stage_.radius(), v);
        if (step.zoom != 1) motion.zoom(step.zoom, {v.width / 2, v.height / 2}, stage_.radius(), v);
        if (step.roll != 0) motion.roll(glm::radians(step.roll * kKeyDegrees));
        stage_.changed(now);
        return true;
    }
    return false;
}

bool CameraControl::run(ViewerCommand command, double now) {
    if (runByHand(command, now)) return true;
    CameraMotion& motion = stage_.motion;
    const bool rocking = motion.rocking(), turning = motion.autoRotation();
    switch (command) {
        case ViewerCommand::fit:
            stage_.remember();
            fit(now);
            return true;
        case ViewerCommand::reset:
            stage_.remember();
            motion.reset(now);
            unclip();
            return true;
        case ViewerCommand::rock:
            stage_.remember();
            motion.touch();
            motion.setRocking(!rocking);
            return true;
        case ViewerCommand::autoRotate:
            stage_.remember();
            motion.touch();
            motion.setAutoRotation(!turning);
            return true;
        default:
            return false;
    }
}

void CameraControl::aim(const Aim& aim, double now) {
    if (reading_.loader().busy() || !stage_.shown())
        aim_ = aim;
    else
        take(aim, true, now);
}

void CameraControl::arrived(bool fly, double now) {
    if (aim_.any()) take(std::exchange(aim_, {}), fly, now);
}

void CameraControl::alignToAxes() {
    const Document& document = stage_.document;
    if (document.molecule->atoms.empty()) return;
    const PixelSize size = frames_.freeSize();
    Camera camera = stage_.motion.camera();
    Aim axes;
    axes.principal = true;
    camera.orientation = aimed(camera, axes, *document.placed, {document.drawing.scene(), document.drawing.radius()},
                               {size.width, size.height})
                             .camera.orientation;
    stage_.motion.set(camera);
}

void CameraControl::fit(double now) {
    const Drawing& drawing = stage_.document.drawing;
    if (stage_.shown() && drawing.reframed()) {
        Camera from = stage_.motion.camera();
        from.zoom = 1;
        stage_.motion.fly(closeUp(from, drawnBalls(drawing.scene()), drawing.radius(), 0, kLargestZoom), now);
    } else {
        stage_.motion.fit(now);
    }
    unclip();
}

/// Restores what a close-up or view clipped or removed.
void CameraControl::unclip() {
    PictureDescription& view = stage_.wanted();
    if (std::exchange(clipped_, false)) view.effects.clip.near = -Clip::kNone;
    if (std::exchange(view.aim.uncover, std::nullopt) && stage_.shown()) reading_.build();
}

void CameraControl::take(Aim aim, bool fly, double now) {
    const Document& document = stage_.document;
    aim.fits = false;  // the scale fits all sides
    for (std::optional<Selection>* selection :
         {&aim.lookAt, &aim.zoomTo, &aim.uncover, &aim.orientBy, &aim.left, &aim.clip})
        if (*selection && document.view.input.several()) nameInputs(inputNames(makeInput(document.view)), **selection);
    try {
        const PixelSize size = frames_.freeSize();
        Camera from = stage_.motion.camera();
        if (aim.zoomTo || aim.principal) from.zoom = 1;
        const Aimed to = aimed(from, aim, *document.placed, {document.drawing.scene(), document.drawing.radius()},
                               {size.width, size.height});
        stage_.remember();
        if (fly)
            stage_.motion.fly(to.camera, now);
        else
            stage_.motion.set(to.camera);
        double& near = stage_.wanted().effects.clip.near;
        if (to.clipNear || (aim.zoomTo && clipped_)) near = to.clipNear.value_or(-Clip::kNone);
        if (to.clipBefore) near = std::max(*to.clipBefore, to.clipNear.value_or(-Clip::kNone));
        if (to.clipNear && !clipped_)
            stage_.messages.say("Atoms in front are cut away; F shows the whole molecule", now);
        clipped_ = to.clipNear.has_value();
        stage_.changed(now);
    } catch (const Error& error) {
        stage_.messages.say(error.what(), now);
    }
}

}  // namespace nacre::app
