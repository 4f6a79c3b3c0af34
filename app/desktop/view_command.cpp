// The desktop shell: window, panel and renderer about the viewer.

#include "app/desktop/view_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/saved_options.h"
#include "app/desktop/state_files.h"
#include "app/desktop/window.h"
#include "app/panel/panel.h"
#include "app/shared/capture_file.h"
#include "app/shared/image_file.h"
#include "app/shared/input.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

Sources sources(const InputOptions& input) {
    return {[input](const SavedView& view) { return loadMolecule(inputOf(view, input)); },
            [](const Molecule& molecule, const SavedView& view) {
                return sceneOf(molecule, view.input, view.drawn, lookOf(view));
            }};
}

/// A path that means the same from any folder.
std::string lasting(const std::string& input) {
    if (input.empty() || input.find(':') != std::string::npos || input == "-") return input;
    return std::filesystem::absolute(input).lexically_normal().string();
}

class Session {
public:
    explicit Session(const ViewOptions& options)
        : options_(options),
          window_({options.first.size.width, options.first.size.height}, events()),
          renderer_(makeRenderer()),
          screen_(*renderer_),
          viewer_(screen_, sources(options.first.input), firstView(), viewerOptions(), Window::wake),
          panel_(makePanel()) {
        scale_ = window_.pixelsPerPoint();
        renderer_->setScene({});
        renderer_->setOverlayGlyphs(panel_->glyphs());
        viewer_.setDebugView(options.first.debug, now());
        resized();
    }

    void loop() {
        while (!window_.closing()) {
            const double wake = viewer_.update(now(), [this] { return panel_->draw(viewer_, window_.size(), now()); });
            if (viewer_.deviceLost()) renew();
            if (renderer_->stats().windowFrames != shown_) {
                shown_ = renderer_->stats().windowFrames;
                lastShown_ = now();
                if (inputAt_ > 0) latencies_.push_back(1000 * (lastShown_ - inputAt_));
            }
            inputAt_ = 0;  // what is not answered by now changed nothing
            saveWarmCaches();
            window_.setTitle(viewer_.title());
            if (panel_->restless()) viewer_.overlayChanged();
            const double next = std::max(panel_->restless() ? now() : wake, lastFrame_ + 0.95 / window_.refreshRate());
            window_.handleEvents(std::isinf(wake) && !panel_->restless() ? wake : next - now());
            lastFrame_ = now();
        }
        saveState(viewer_.view());
        if (!options_.first.stats.empty()) writeStats();
        if (!renderer_->validationMessages().empty())
            throw Error("Vulkan validation", renderer_->stats().device.name,
                        std::to_string(renderer_->validationMessages().size()) +
                            " messages, the first: " + renderer_->validationMessages().front());
    }

private:
    static double now() {
        using Clock = std::chrono::steady_clock;
        return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    }

    std::unique_ptr<Panel> makePanel() {
        return std::make_unique<Panel>(window_.pixelsPerPoint(), [this](ViewerCommand command) { run(command); });
    }

    std::unique_ptr<Renderer> makeRenderer() const {
        DeviceOptions device = options_.first.device;
        device.surface = window_.surface();
        device.pipelineCache = loadPipelineCache();
        return std::make_unique<Renderer>(device);
    }

    SavedView firstView() const {
        SavedView view = savedViewOf(options_.first);
        if (options_.restore)
            if (const auto saved = loadState()) view = *saved;
        if (view.input.empty()) view.input = "sample:dna";
        view.input = lasting(view.input);
        return view;
    }

    ViewerOptions viewerOptions() const {
        ViewerOptions options;
        if (renderer_->stats().device.type == "software") options.mostSamples = 2;
        options.occlusionBytes = options_.first.occlusion.bytes();
        options.occlusionCache = occlusionCacheFolder(options_.first.input);
        return options;
    }

    /// Of what the next frame answers, the first.
    void noteInput() {
        if (inputAt_ == 0) inputAt_ = now();
    }

    WindowEvents events() {
        WindowEvents e;
        e.resized = [this] { resized(); };
        e.iconified = [this](bool iconified) {
            if (!iconified) return viewer_.resume(now());
            viewer_.pause();
            saveState(viewer_.view());
        };
        e.damaged = [this] { viewer_.overlayChanged(); };
        e.pointer = [this](glm::dvec2 at) {
            noteInput();
            pointer_ = at;
            panel_->pointer(at);
            if (!panelDrag_) viewer_.mouseMove(at / scale_, now());
        };
        e.button = [this](MouseButton button, bool down, Modifiers with) {
            noteInput();
            // Who got the press gets the release.
            if (down) panelDrag_ = panel_->ownsPointer();
            if (panelDrag_)
                panel_->button(button, down);
            else
                viewer_.mouseButton(button, down, pointer_ / scale_, with, now());
            if (!down) panelDrag_ = false;
        };
        e.wheel = [this](double steps) {
            noteInput();
            if (panel_->ownsPointer())
                panel_->wheel(steps);
            else
                viewer_.wheel(steps, pointer_ / scale_, now());
        };
        e.special = [this](SpecialKey key, bool down) {
            if (panel_->ownsKeys() || !down) panel_->key(key, down);
        };
        e.character = [this](char32_t c) {
            if (panel_->ownsKeys()) panel_->character(c);
        };
        e.key = [this](KeyEvent key) {
            noteInput();
            if (panel_->ownsKeys()) return;
            if (const auto command = commandOf(key)) run(*command);
        };
        e.dropped = [this](const std::string& path) { viewer_.open(lasting(path), now()); };
        return e;
    }

    /// The window came to a display of another density: text is drawn anew at its size.
    void rescaled() {
        scale_ = window_.pixelsPerPoint();
        panel_ = makePanel();
        renderer_->setOverlayGlyphs(panel_->glyphs());
    }

    void resized() {
        const PixelSize size = window_.size();
        if (size.width == 0 || size.height == 0) return viewer_.pause();
        if (window_.pixelsPerPoint() != scale_) rescaled();
        viewer_.resize(size, scale_, now());
        viewer_.resume(now());
    }

    void run(ViewerCommand command) {
        switch (command) {
            case ViewerCommand::panel:
                panel_->togglePanel();
                return viewer_.overlayChanged();
            case ViewerCommand::help:
                panel_->toggleHelp();
                return viewer_.overlayChanged();
            case ViewerCommand::clearPicks:
                panel_->closeHelp();
                break;
            case ViewerCommand::quit:
                return window_.close();
            case ViewerCommand::savePicture:
            case ViewerCommand::saveView:
                return save(command == ViewerCommand::savePicture);
            case ViewerCommand::captureFrame:
                return captureFrame();
            default:
                break;
        }
        viewer_.run(command, now());
    }

    /// The picture as PNG, or the view as JSON, in the current folder under a name that is free.
    void save(bool picture) {
        if (!viewer_.document()) return;
        try {
            const std::string path = freeName(viewer_.document()->view.input, picture ? ".png" : ".view.json");
            OutputFile file(path);
            if (picture) {
                RenderSettings settings = viewer_.settings();
                settings.supersample = viewerOptions().mostSamples;
                const Picture p = renderer_->render(settings);
                writePicture(file, {p.width, p.height, p.rgba}, false);
            } else {
                writeText(file, savedViewJson(viewer_.view()));
            }
            viewer_.say("saved " + path, now());
        } catch (const Error& error) {
            viewer_.say(error.what(), now());
        }
    }

    /// The next frame, drawn at once, in the current folder under a name that is free; in RenderDoc's own if that
    /// started us.
    void captureFrame() {
        if (!renderer_->captures())
            return viewer_.say(capturesBuilt() ? "F12 needs RenderDoc from the start: nacre view --capture"
                                               : "this program was built without RenderDoc's header",
                               now());
        if (!viewer_.document()) return;
        try {
            std::optional<OutputFile> file;
            if (!renderer_->startedByRenderDoc()) file.emplace(freeName(viewer_.document()->view.input, ".rdc"));
            renderer_->beginCapture(file ? captureStem(*file) : "");
            WindowFrame frame;
            frame.overlay = panel_->draw(viewer_, window_.size(), now());
            const bool shown = renderer_->present(viewer_.settings(), frame) == FrameOutcome::shown;
            const std::string written = renderer_->endCapture();
            if (!shown) throw Error("cannot capture", "", "the window is changing");
            if (file) keepCapture(written, *file);
            viewer_.say("captured to " + (file ? file->path() : written), now());
        } catch (const Error& error) {
            viewer_.say(error.what(), now());
        }
    }

    /// What the driver compiled for the first refined picture is all that later ones need.
    void saveWarmCaches() {
        if (cacheSaved_ || renderer_->stats().windowFrames < 3) return;
        cacheSaved_ = true;
        if (renderer_->captures())
            return;  // RenderDoc keeps the driver's data from us, and the file has what is better
        savePipelineCache(renderer_->pipelineCache());
    }

    void renew() {
        const std::string loss = renderer_->deviceLoss();
        if (now() - lostAt_ > 60) lost_ = 0;
        lostAt_ = now();
        if (++lost_ > 3) throw Error("drawing was given up", "4 times within minutes", loss);
        std::cerr << "nacre: warning: " << loss << std::endl;
        renderer_.reset();
        renderer_ = makeRenderer();
        screen_.setRenderer(*renderer_);
        renderer_->setScene({});
        renderer_->setOverlayGlyphs(panel_->glyphs());
        viewer_.screenLost(now());
    }

    void writeStats() {
        nlohmann::ordered_json json;
        json["window_frames"] = renderer_->stats().windowFrames;
        json["seconds_since_last_frame"] = now() - lastShown_;
        json["occlusion"] = viewer_.occlusion();
        json["occlusion_cached"] = renderer_->stats().occlusion.cached;
        json["occlusion_bytes"] = renderer_->stats().occlusion.bytes;
        if (!latencies_.empty()) {
            std::sort(latencies_.begin(), latencies_.end());
            json["input_to_present"] = {{"min", latencies_.front()}, {"median", latencies_[latencies_.size() / 2]}};
        }
        json["picked"] = nlohmann::ordered_json::array();
        for (const std::uint32_t pick : viewer_.picks()) json["picked"].push_back(pick + 1);
        json["device"] = renderer_->stats().device.name;
        OutputFile file(options_.first.stats);
        writeText(file, json.dump(2) + "\n");
    }

    ViewOptions options_;
    Window window_;
    std::unique_ptr<Renderer> renderer_;
    RendererScreen screen_;
    Viewer viewer_;
    std::unique_ptr<Panel> panel_;
    glm::dvec2 pointer_{};
    double scale_ = 0, lastFrame_ = 0, lastShown_ = 0;
    double inputAt_ = 0;             // when the first input came that no frame has answered; 0: none did
    std::vector<double> latencies_;  // of frames that answered some, milliseconds until they were handed to the display
    std::uint64_t shown_ = 0;        // frames, when lastShown_ was
    bool panelDrag_ = false, cacheSaved_ = false;
    int lost_ = 0;          // devices, of late
    double lostAt_ = -1e9;  // the last of them
};

}  // namespace

void viewCommand(const ViewOptions& options) { Session(options).loop(); }

}  // namespace nacre::app
