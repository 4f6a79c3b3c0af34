#pragma once
// What the viewer draws on: the engine's renderer, or a stand-in in tests.

#include "engine/renderer.h"

namespace nacre::app {

class Screen {
public:
    virtual ~Screen() = default;
    virtual void setScene(const Representation& scene) = 0;
    virtual double advanceOcclusion(const RenderSettings& settings, double milliseconds) = 0;
    virtual FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame) = 0;
    virtual PixelSize windowSize() const = 0;
    virtual std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach) = 0;
    /// What is known of the device's loss; empty: it is there.
    virtual std::string deviceLoss() const { return {}; }
};

/// Draws by a renderer that lives longer.
class RendererScreen : public Screen {
public:
    explicit RendererScreen(Renderer& renderer) : renderer_(&renderer) {}
    void setRenderer(Renderer& renderer) { renderer_ = &renderer; }
    void setScene(const Representation& scene) override { renderer_->setScene(scene); }
    double advanceOcclusion(const RenderSettings& settings, double milliseconds) override {
        return renderer_->advanceOcclusion(settings, milliseconds);
    }
    FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame) override {
        return renderer_->present(settings, frame);
    }
    PixelSize windowSize() const override { return renderer_->windowSize(); }
    std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach) override {
        return renderer_->atomAt(settings, x, y, reach);
    }
    std::string deviceLoss() const override { return renderer_->deviceLoss(); }

private:
    Renderer* renderer_;
};

}  // namespace nacre::app
