#pragma once
// The viewer in a window that nobody sees, by a clock of its own: what a shell does, without one.

#include <cmath>
#include <memory>

#include "app/viewer/viewer.h"
#include "tests/faults/fault_run.h"

namespace nacre::test {

class ViewerRun {
public:
    /// @param directions of the occlusion, which takes most of the time
    explicit ViewerRun(int directions = 0) : viewer_(screen_, sources(), firstView(directions), quick()) {
        viewer_.waitForLoading();
        viewer_.resize({64, 64}, 1, now_);
    }

    app::Viewer& viewer() { return viewer_; }
    int devices() const { return screen_.devices; }
    /// Messages, each once in a row.
    const std::vector<std::string>& said() const { return said_; }
    void forgetSaid() { said_.clear(); }

    /// As if the window had been covered.
    void redraw() { viewer_.resume(now_); }
    void open() {
        viewer_.open("sample:glucose", now_);
        viewer_.waitForLoading();
    }
    /// As if the window were new: scene and occlusion, too.
    void anew() { viewer_.screenLost(now_); }

    /// Until nothing is left to be drawn. @returns whether that came
    bool rest(int mostUpdates = 500) {
        for (int i = 0; i < mostUpdates; ++i) {
            const double wake = viewer_.update(now_, [this] { return &overlay_; });
            const std::string message = viewer_.annotations().message;
            if (!message.empty() && (said_.empty() || said_.back() != message)) said_.push_back(message);
            if (viewer_.deviceLost()) {
                screen_.makeRenderer();
                viewer_.screenLost(now_);
                continue;
            }
            if (std::isinf(wake)) return viewer_.document() && viewer_.occlusion() == 1;
            now_ = std::max(now_ + 1.0 / 60, wake);
        }
        return false;
    }

    /// What the viewer shows, small.
    std::vector<float> picture() {
        RenderSettings s = viewer_.settings();
        s.view = viewOf(viewer_.view().camera, viewer_.document()->scene.radius, 64, 64);
        return screen_.renderer->render(s).rgba;
    }

private:
    /// A screen whose renderer comes and goes.
    struct RenewedScreen : app::Screen {
        std::unique_ptr<Renderer> renderer;
        int devices = 0;
        RenewedScreen() { makeRenderer(); }
        void makeRenderer() {
            renderer.reset();
            renderer = std::make_unique<Renderer>(options());
            ++devices;
        }
        void setScene(const Representation& scene) override { renderer->setScene(scene); }
        double advanceOcclusion(const RenderSettings& settings, double) override {
            return renderer->advanceOcclusion(settings, 1e-3);
        }
        FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame) override {
            return renderer->present(settings, frame);
        }
        PixelSize windowSize() const override { return renderer->windowSize(); }
        std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach) override {
            return renderer->atomAt(settings, x, y, reach);
        }
        std::string deviceLoss() const override { return renderer->deviceLoss(); }
    };

    static DeviceOptions options() {
        DeviceOptions options;
        options.validate = true;
        options.visibility = Visibility::encoded;
        options.surface.instanceExtensions = {VK_KHR_SURFACE_EXTENSION_NAME, VK_EXT_HEADLESS_SURFACE_EXTENSION_NAME};
        options.surface.create = [](VkInstance instance) {
            const auto make = reinterpret_cast<PFN_vkCreateHeadlessSurfaceEXT>(
                vkGetInstanceProcAddr(instance, "vkCreateHeadlessSurfaceEXT"));
            const VkHeadlessSurfaceCreateInfoEXT info{VK_STRUCTURE_TYPE_HEADLESS_SURFACE_CREATE_INFO_EXT, nullptr, 0};
            VkSurfaceKHR surface = VK_NULL_HANDLE;
            const VkResult result = make(instance, &info, nullptr, &surface);
            if (result != VK_SUCCESS) throw Error("cannot make a surface", "", std::to_string(result));
            return surface;
        };
        return options;
    }
    static app::Sources sources() {
        return {[](const app::SavedView& v) { return sampleMolecule(v.input.substr(7)); },
                [](const Molecule& m, const app::SavedView& v) {
                    return represent(m, drawnAtoms(m, v.drawn), app::lookOf(v));
                }};
    }
    static app::SavedView firstView(int directions) {
        app::SavedView view;
        view.input = "sample:glucose";
        view.style = "spacefill";
        view.occlusionDirections = directions;
        return view;
    }
    static app::ViewerOptions quick() {
        app::ViewerOptions options;
        options.mostSamples = 1;  // of a refinement that a software driver draws at the size of the window
        return options;
    }
    static Overlay triangle() {
        Overlay overlay;
        overlay.vertices = {{5, 5, 0, 0, 0xff0000ff}, {60, 5, 0, 0, 0xff00ff00}, {5, 60, 0, 0, 0xffff0000}};
        overlay.indices = {0, 1, 2};
        overlay.batches = {{0, 0, 1000, 1000, 0, 3}};
        return overlay;
    }

    double now_ = 100;
    Overlay overlay_ = triangle();
    RenewedScreen screen_;
    app::Viewer viewer_;
    std::vector<std::string> said_;
};

}  // namespace nacre::test
