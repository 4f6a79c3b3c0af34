#pragma once
// The viewer's output: the session's renderer, or a test double.

#include "engine/renderer.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {

/// The atom in each pixel of a view, and the time to find them.
struct SeenAtoms {
    std::vector<std::uint32_t> atoms;
    double milliseconds = 0;
};

class Screen {
public:
    virtual ~Screen() = default;
    virtual void setScene(Representation scene) = 0;
    /// See Renderer::moveScene.
    virtual void moveScene(Representation scene) { setScene(std::move(scene)); }
    /// See Renderer::expectScene.
    virtual void expectScene(Representation, const RenderSettings&, const WindowFrame&) {}
    virtual double advanceOcclusion(const RenderSettings& settings, const OcclusionPace& pace) = 0;
    /// See Renderer::awaitFrame.
    virtual void awaitFrame() {}
    /// Recent GPU time per frame, milliseconds; 0: unknown.
    virtual double frameMilliseconds() const { return 0; }
    virtual FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame) = 0;
    virtual PixelSize windowSize() const = 0;
    virtual std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach) = 0;
    /// See Renderer::atoms.
    virtual SeenAtoms atoms(const RenderSettings&) { return {}; }
    /// Description of the device's loss; empty: not lost.
    virtual std::string deviceLoss() const { return {}; }
};

}  // namespace nacre::app
