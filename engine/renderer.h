#pragma once
// Draws pictures of a molecule. Read this and renderer.cpp first.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/baked_occlusion.h"
#include "engine/coded_picture.h"
#include "engine/device_options.h"
#include "engine/devices.h"
#include "engine/results.h"
#include "engine/settings.h"

namespace nacre {

struct Representation;  // scene/build/representation.h
struct SharedDevice;    // renderer.cpp

/// After an Error the renderer works as before: the same call, or one that needs less memory, may succeed. Only a lost
/// device stays lost.
///
/// Threads: one thread at a time may call a renderer, const functions included. Several renderers may be called by as
/// many threads. Callbacks (DeviceOptions, RenderSettings) run on the calling thread, before the call returns. Returned
/// references are valid until the next non-const call. A renderer starts threadsPerTask() - 1 threads per task
/// (threads.h), one to prepare each bake and, after makePipelinesAhead(), one that compiles pipelines. Drivers start
/// their own.
class Renderer {
public:
    /// @throws Error if there is no suitable device
    explicit Renderer(const DeviceOptions& options);
    /// Draws on the device of another renderer, which has no window and no headset. A loss concerns both.
    explicit Renderer(std::shared_ptr<SharedDevice> device);
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    /// The device, for renderers of other threads.
    std::shared_ptr<SharedDevice> device() const;

    /// Uploads a scene and drops the occlusion of the previous one. Keeps both if only colours change.
    /// @returns whether it uploaded only colours @throws Error and keeps the previous scene
    bool setScene(Representation representation);
    /// Moves the primitives of the scene. If they are not the same ones in the same order, acts as setScene(). Does not
    /// wait for the device. Frames show the previous occlusion until advanceOcclusion() has finished the new one;
    /// pictures and layers always show the new one. @throws Error and keeps the previous scene
    void moveScene(Representation representation);

    /// Bakes occlusion for about `milliseconds`, at least one direction. Frames show the finished directions; pictures
    /// and layers finish all of them first. @returns the finished share, 0..1
    double advanceOcclusion(const RenderSettings& settings, double milliseconds = 4.0);
    /// As above beside a window's frames, without waiting for the device or for preparation on the host. Call it for
    /// every frame, and about every millisecond while there is none: each call submits the next part if the last is
    /// finished.
    double advanceOcclusion(const RenderSettings& settings, const OcclusionPace& pace);
    /// For each sphere, whether the bake saw it from any direction; empty before the bake is finished.
    std::vector<bool> seenSpheres() const;

    /// Compiles the pipelines of later passes of a picture on a worker thread from now on. Errors are reported when a
    /// pass needs the pipeline.
    void makePipelinesAhead();

    /// @throws Error if the view has no pixels, if a setting is not finite or out of range, if the picture exceeds the
    /// device's limits, or if memory runs out
    Picture render(const RenderSettings& settings);
    /// Equals coded(render(settings), alpha) with `fine` off; faster if one frame draws the picture. @throws Error
    CodedPicture renderCoded(const RenderSettings& settings, bool alpha);
    /// Starts a picture like renderCoded()'s while the device draws earlier ones; two at a time keep it busy. Until all
    /// are finished, call no other function that draws. After an Error nothing is started.
    void startCoded(const RenderSettings& settings, bool alpha);
    /// The oldest started picture. @throws Error, also if none is started
    CodedPicture finishCoded();
    /// Number of pictures started and not finished.
    std::size_t started() const;
    /// A rectangle of render()'s picture, byte for byte. The whole picture may exceed the device's limits.
    /// @param part  its x and y are multiples of PictureRect::kStep; View::quarterTurns is 0 @throws Error
    Picture renderPart(const RenderSettings& settings, const PictureRect& part);
    /// The pictures of both eyes, left and right: render() of the view and of View::other, byte for byte.
    std::array<Picture, 2> renderEyes(const RenderSettings& settings);
    /// layers() of both eyes, left and right.
    std::array<LayerPicture, 2> layersOfEyes(const RenderSettings& settings);
    /// One sample per pixel, without anti-aliasing; `supersample` is ignored.
    LayerPicture layers(const RenderSettings& settings);

    /// Draws one frame as an application would: nothing is read back, and occlusion is shown as far as it is baked (1
    /// everywhere at first). Draws all samples per pixel that fit in one frame. @returns milliseconds, from declaring
    /// the frame until the device is finished
    double drawFrame(const RenderSettings& settings);

    /// Waits for room in the queue and an image of the window, so that the next present() does not. Poll input after
    /// it, so that the frame shows the newest state. Errors are reported by present().
    void awaitFrame();
    /// Draws a frame into the window of DeviceOptions::surface, with the occlusion baked so far, and queues it for the
    /// display. Waits for the device only if two frames are in flight.
    /// @param settings its view has the window's size; `supersample` and `countFragments` are ignored
    /// @throws Error if there is no such window
    FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame);
    /// Draws both eyes, left and right, into the layers of a headset's image, with the occlusion baked so far, and
    /// submits them: in one frame if the eyes look in parallel. Waits for the device only if two frames are in flight.
    /// @param settings  their view is not used @param eyes  of the image's size
    FrameOutcome presentEyes(const RenderSettings& settings, const std::array<View, 2>& eyes, const HeadsetImage& into);
    /// Announces a scene, for example while its file is read: a worker thread compiles the pipelines of a window's
    /// frame. Nothing is drawn, and errors are reported when the scene is drawn.
    /// @param like  has primitives of the same kinds; their number and size do not matter
    void expectScene(Representation like, const RenderSettings& settings, const WindowFrame& frame);
    PixelSize windowSize() const;
    /// Releases the window's surface before the window goes away. The next frame creates another.
    void releaseWindow();
    /// Sets the glyphs for later overlays. @throws Error if the texture is too large
    void setOverlayGlyphs(const OverlayGlyphs& glyphs);
    /// Bakes the occlusion completely and returns it. @throws Error
    BakedOcclusion bakedOcclusion(const OcclusionSettings& settings);
    /// The atom that is visible at a point of the view, or the nearest one within `reach`. @returns its 1-based
    /// position in the file; 0: none. @param x, y, reach pixels, from the top left
    std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach);
    /// For each pixel of the view, row by row, the atom that is visible there, as atomAt() counts. @throws Error
    std::vector<std::uint32_t> atoms(const RenderSettings& settings);

    /// Whether frames can be captured: if DeviceOptions::capture is set, or RenderDoc started this program.
    bool captures() const;
    /// Whether RenderDoc started this program, and so decides where captures go.
    bool startedByRenderDoc() const;
    /// Begins a capture of everything that is drawn and baked. @param stem beginning of the file's name, which
    /// RenderDoc completes; empty: RenderDoc's choice. @throws Error
    void beginCapture(const std::string& stem);
    /// @returns the path of the capture. @throws Error if RenderDoc wrote none
    std::string endCapture();

    /// The driver's compiled pipelines, for DeviceOptions::pipelineCache of a later run.
    std::vector<std::byte> pipelineCache() const;

    /// Waits until the device has finished everything submitted, or the time is over. @returns whether it has finished
    bool awaitSubmitted(double seconds) const;

    /// One line about the loss of the device; empty while it works.
    const std::string& deviceLoss() const;

    const FrameStats& stats() const;
    /// The driver's feedback on current render passes and images. Queries the driver.
    DriverFeedback driverFeedback() const;
    /// Plan of the last frame as text.
    const std::string& planText() const;
    /// How the first frame of the last picture was drawn, and why; empty before the first picture.
    std::vector<Decision> decisions() const;
    /// Messages of the validation layer so far; there should be none.
    std::vector<std::string> validationMessages() const;
    /// Largest picture side of this device, in pixels.
    std::uint32_t maxSize() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace nacre
