#pragma once
// The viewer in a window that nobody sees, by a clock of its own: what a shell does, without one.

#include <chrono>
#include <cmath>
#include <thread>

#include "app/viewer/session.h"
#include "tests/faults/fault_run.h"
#include "tests/support/headless_surface.h"

namespace nacre::test {

class ViewerRun {
public:
    /// @param directions of the occlusion, which takes most of the time
    explicit ViewerRun(int directions = 0) : session_(host(), sources(), firstView(directions), quick(), {}) {
        session_.open(now_);
        viewer().reading().loader().wait();
        viewer().frames().resize({64, 64}, 1, now_);
    }

    app::Viewer& viewer() { return session_.viewer(); }
    int devices() const { return devices_; }
    /// Messages, each once in a row.
    const std::vector<std::string>& said() const { return said_; }
    void forgetSaid() { said_.clear(); }
    double now() const { return now_; }

    double secondsAfterALoss = 2 * app::Session::kForgottenAfter;  ///< a device is lost now and then

    /// As if the window had been covered.
    void redraw() { viewer().resume(now_); }
    void open() {
        viewer().reading().open("sample:glucose", now_);
        viewer().reading().loader().wait();
    }
    /// As if the window were new.
    void anew() { viewer().frames().replaced(now_); }
    /// The renderer's scene goes: the same one, put there again, would keep its occlusion.
    void forgetScene() { session_.renderer()->setScene({}); }

    /// Until nothing is left to be drawn. @returns whether that came
    bool rest(int mostUpdates = 5'000) {
        for (int i = 0; i < mostUpdates; ++i) {
            const int devices = devices_;
            const double wake = session_.step(now_, [this] { return &overlay_; });
            const std::string message = viewer().picking().annotations().message;
            if (!message.empty() && (said_.empty() || said_.back() != message)) said_.push_back(message);
            if (devices_ != devices) {
                now_ += secondsAfterALoss;
                continue;
            }
            if (std::isinf(wake)) return viewer().document() && viewer().frames().occlusion() == 1;
            // The device bakes beside the frames, in its own time.
            std::this_thread::sleep_for(std::chrono::microseconds(500));
            now_ = std::max(now_ + 1.0 / 60, wake);
        }
        return false;
    }

    /// What the viewer shows, small.
    std::vector<float> picture() {
        RenderSettings s = viewer().frames().settings();
        s.view = makeView(viewer().view().camera, viewer().document()->drawing.radius(), 64, 64);
        return session_.renderer()->render(s).rgba;
    }

    /// What a shell lays over the picture.
    static Overlay triangle() {
        Overlay overlay;
        overlay.vertices = {{5, 5, 0, 0, 0xff0000ff}, {60, 5, 0, 0, 0xff00ff00}, {5, 60, 0, 0, 0xffff0000}};
        overlay.indices = {0, 1, 2};
        overlay.batches = {{0, 0, 1000, 1000, 0, 3}};
        return overlay;
    }

private:
    app::SessionHost host() {
        app::SessionHost host;
        host.device = [this] {
            ++devices_;
            return options();
        };
        host.loadPipelines = [] { return std::vector<std::byte>(); };
        return host;
    }
    static DeviceOptions options() {
        DeviceOptions options{.validate = true, .visibility = Visibility::encoded, .surface = headlessSurface()};
        return options;
    }
    static app::Sources sources() {
        return {[](const app::PictureDescription& v) { return sampleMolecule(v.input.path.substr(7)); }};
    }
    static app::PictureDescription firstView(int directions) {
        app::PictureDescription view;
        view.input.path = "sample:glucose";
        view.look.style = Style::spacefill;
        view.occlusion.directions = directions;
        return view;
    }
    static app::ViewerOptions quick() {
        app::ViewerOptions options;
        options.mostSamples = 1;  // of a refinement that a software driver draws at the size of the window
        return options;
    }

    double now_ = 100;
    Overlay overlay_ = triangle();
    int devices_ = 0;
    app::Session session_;
    std::vector<std::string> said_;
};

}  // namespace nacre::test
