#pragma once
// A molecule's pictures. Read this and renderer.cpp first.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/baked_occlusion.h"
#include "engine/device_options.h"
#include "engine/devices.h"
#include "engine/results.h"
#include "engine/scene/representation.h"
#include "engine/settings.h"

namespace nacre {

/// After an Error the renderer is as good as before: the same call, or one that asks for less, may succeed. Only a
/// device that was lost stays so.
///
/// Threads. One thread at a time calls a renderer, const functions included; it need not be the same one. Several
/// renderers may be called by as many threads. Functions that a caller hands over (DeviceOptions, RenderSettings) are
/// called by the thread that called the renderer, before that call returns. References that are handed out are good
/// until the next call that is not const. A renderer starts threadsPerTask() - 1 threads for the time of a task
/// (threads.h: an embedder sets how many), one to prepare each bake and, from makePipelinesAhead() on, one that makes
/// pipelines; drivers start their own.
class Renderer {
public:
    /// @throws Error if no suitable device is there
    explicit Renderer(const DeviceOptions& options);
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    /// Uploads a scene. What was baked for the one before is dropped. @throws Error, and the scene before stays
    void setScene(Representation representation);
    /// The scene's primitives at other places, in the order that they were handed in, as a molecule moves; anything
    /// else is as setScene(). Never waits for the device. Frames go on with the occlusion that was baked for the places
    /// before until advanceOcclusion() has finished a newer one; pictures and layers never do.
    /// @throws Error, and the scene before stays
    void moveScene(Representation representation);

    /// Works on the scene's occlusion for about `milliseconds`: at least one direction, if any is left. Frames show
    /// what is done so far; pictures and layers finish it first.
    /// @returns the share that is done, 0..1
    double advanceOcclusion(const RenderSettings& settings, double milliseconds = 4.0);
    /// The same beside a window's frames: never waits, neither for the device nor for what the host must find out
    /// first. Call it for every frame, and every millisecond or so while there is none to draw: each call lets the
    /// device begin with the next part if it is done with the last.
    double advanceOcclusion(const RenderSettings& settings, const OcclusionPace& pace);
    /// For each sphere of the scene whether any direction of the bake saw any of it; empty before the bake is done.
    std::vector<bool> seenSpheres() const;

    /// From now on pipelines that the next passes of a picture are going to want are made on a thread of their own,
    /// while the first is made. What goes wrong there goes wrong again, and is told, where they are wanted.
    void makePipelinesAhead();

    /// @throws Error if the picture is larger than the device draws, or memory runs out
    Picture render(const RenderSettings& settings);
    /// A rectangle of the picture that render() draws, to the byte, which may be larger than the device draws.
    /// @param part  its x and y are multiples of PictureRect::kStep; View::quarterTurns is 0 @throws Error
    Picture renderPart(const RenderSettings& settings, const PictureRect& part);
    /// One sample a pixel, no antialiasing; supersample is ignored.
    LayerPicture layers(const RenderSettings& settings);

    /// One frame as an application would draw it: nothing is read back, and occlusion is shown as far as it is baked (1
    /// everywhere at first). Of several samples a pixel, all are drawn where one frame can. Returns milliseconds, from
    /// declaring the frame to the device being done.
    double drawFrame(const RenderSettings& settings);

    /// Waits until the next present() need not: for room in the queue and an image of the window. Look for input after
    /// it, so that the frame shows what is newest. Whatever goes wrong, present() tells.
    void awaitFrame();
    /// Draws a frame into the window that DeviceOptions::surface makes, with the occlusion that is there so far, and
    /// queues it for the display. Does not wait for the device unless two frames are in flight already.
    /// @param settings its view has the window's size; `supersample` and `countFragments` are not looked at
    FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame);
    /// A scene like this one is about to be set, as while a file is read: the pipelines of a window's frame of it are
    /// made on a thread of their own meanwhile. Nothing is drawn; what cannot be made is told when it is asked for.
    /// @param like  has primitives of the same kinds; how many, and how large, is all the same
    void expectScene(Representation like, const RenderSettings& settings, const WindowFrame& frame);
    PixelSize windowSize() const;
    /// Lets go of the window's surface, which is about to go; the next frame makes another.
    void releaseWindow();
    /// Glyphs of the overlays that follow. @throws Error if the texture is too large
    void setOverlayGlyphs(const OverlayGlyphs& glyphs);
    /// Bakes all of the occlusion that the settings ask for, and hands it out. @throws Error
    BakedOcclusion bakedOcclusion(const OcclusionSettings& settings);
    /// The atom that is seen at a place of the view or, if none is, nearest to it. @returns its 1-based position in the
    /// file; 0: none within reach. @param x, y, reach pixels, from the top left
    std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach);

    /// Whether frames can be captured: DeviceOptions::capture, or RenderDoc started this program.
    bool captures() const;
    /// RenderDoc started this program: its captures are for RenderDoc to keep.
    bool startedByRenderDoc() const;
    /// All that is drawn and baked from here on becomes one capture. @param stem of the file's name, to which RenderDoc
    /// adds; empty: as RenderDoc likes. @throws Error
    void beginCapture(const std::string& stem);
    /// @returns the file that RenderDoc wrote. @throws Error if there is none
    std::string endCapture();

    /// What the driver compiled so far, for DeviceOptions::pipelineCache of a later run.
    std::vector<std::byte> pipelineCache() const;

    /// What is known of the device's loss, in one line; empty: it is there.
    const std::string& deviceLoss() const;

    const FrameStats& stats() const;
    /// What the driver says of the render passes and images that are kept by now. Asks the driver.
    DriverFeedback driverFeedback() const;
    /// Plan of the last frame as text.
    const std::string& planText() const;
    /// What the validation layer said so far; empty is what is right.
    std::vector<std::string> validationMessages() const;
    /// Largest picture side of this device, in pixels.
    std::uint32_t maxSize() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace nacre
