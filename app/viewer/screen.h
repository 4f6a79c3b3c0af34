#pragma once
// What the viewer draws on: the session's renderer, or a stand-in in tests.

#include "engine/renderer.h"

namespace nacre::app {

class Screen {
public:
    virtual ~Screen() = default;
    virtual void setScene(const Representation& scene) = 0;
    /// As Renderer::moveScene.
    virtual void moveScene(const Representation& scene) { setScene(scene); }
    /// As Renderer::expectScene.
    virtual void expectScene(Representation, const RenderSettings&, const WindowFrame&) {}
    virtual double advanceOcclusion(const RenderSettings& settings, const OcclusionPace& pace) = 0;
    /// As Renderer::awaitFrame.
    virtual void awaitFrame() {}
    /// What the device took for a frame lately, milliseconds; 0: nobody knows.
    virtual double frameMilliseconds() const { return 0; }
    virtual FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame) = 0;
    virtual PixelSize windowSize() const = 0;
    virtual std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach) = 0;
    /// What is known of the device's loss; empty: it is there.
    virtual std::string deviceLoss() const { return {}; }
};

}  // namespace nacre::app
