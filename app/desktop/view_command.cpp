// The desktop shell: window, panel and renderer about the viewer.

#include "app/desktop/view_command.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "app/desktop/state_files.h"
#include "app/desktop/window.h"
#include "app/download/load_molecule.h"
#include "app/panel/panel.h"
#include "app/shared/cache_folder.h"
#include "app/shared/capture_file.h"
#include "app/shared/image_file.h"
#include "app/shared/json_text.h"
#include "app/shared/messages.h"
#include "app/shared/printable.h"
#include "app/shared/view_input.h"
#include "app/shared/word_painter.h"
#include "app/viewer/session.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::uint32_t kSoftwareSamples = 2;  // a side of a pixel, of a refinement that a CPU draws

/// A path that means the same from any folder.
std::string lasting(const std::string& input) {
    if (input.empty() || input.find(':') != std::string::npos || input == "-") return input;
    return std::filesystem::absolute(input).lexically_normal().string();
}

/// What a saved view names is downloaded if the user says so.
Sources sources(const InputOptions& first) {
    const auto allowed = std::make_shared<std::atomic<bool>>(first.allowDownload);
    return {[first, allowed](const SavedView& view) {
                InputOptions input = inputOf(view, first);
                if (view.input != lasting(first.path)) input.namedBy.clear();  // opened by hand
                input.allowDownload = *allowed;
                try {
                    return loadMolecule(input);
                } catch (const DownloadForbidden&) {
                    throw Question("This view downloads " + printable(input.path), "Download",
                                   [allowed] { *allowed = true; });
                }
            },
            sceneOfView};
}

class WindowSession {
public:
    explicit WindowSession(const ViewOptions& options)
        : options_(options),
          window_({options.size.width, options.size.height}, events()),
          panel_(makePanel()),
          session_(host(), sources(options.input), firstView(), viewerOptions(), Window::wake) {
        scale_ = window_.pixelsPerPoint();
        session_.open(now());
        if (renderer().stats().device.type == "software") viewer().setMostSamples(kSoftwareSamples);
        viewer().setDebugView(options.debug, now());
        viewer().aim(options.aim, now());
        resized();
    }

    void loop() {
        while (!window_.closing()) {
            // The newest input goes into the frame, not what was there before it had to wait.
            viewer().awaitFrame(now());
            window_.handleEvents(0);
            viewer().setDisplayInterval(1 / window_.refreshRate());
            const double wake = session_.step(now(), [this] { return panel_->draw(viewer(), window_.size(), now()); });
            const bool shown = renderer().stats().windowFrames != shown_;
            if (shown) {
                shown_ = renderer().stats().windowFrames;
                lastShown_ = now();
                if (inputAt_ > 0) latencies_.push_back(1000 * (lastShown_ - inputAt_));
            }
            inputAt_ = 0;  // what is not answered by now changed nothing
            window_.setTitle(printable(viewer().title()));
            if (panel_->restless()) viewer().overlayChanged();
            // Frames come as often as the display's; looks at what is baked beside them may come more often.
            const double soonest = shown ? lastFrame_ + 0.95 / window_.refreshRate() : now();
            const double next = std::max(panel_->restless() ? now() : wake, soonest);
            window_.handleEvents(std::isinf(wake) && !panel_->restless() ? wake : next - now());
            lastFrame_ = now();
        }
        saveState(viewer().view());
        if (!options_.stats.empty()) writeStats();
        if (!renderer().validationMessages().empty())
            throw Error("Vulkan validation", renderer().stats().device.name,
                        std::to_string(renderer().validationMessages().size()) +
                            " messages, the first: " + renderer().validationMessages().front());
    }

private:
    static double now() {
        using Clock = std::chrono::steady_clock;
        return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    }

    std::unique_ptr<Panel> makePanel() {
        return std::make_unique<Panel>(window_.pixelsPerPoint(), [this](ViewerCommand command) { run(command); });
    }

    SessionHost host() {
        SessionHost host;
        host.device = [this] {
            DeviceOptions device = options_.device;
            device.selfTests = cacheFolder(options_.input.cache, "devices");
            device.surface = window_.surface();
            return device;
        };
        host.loadPipelines = [] { return loadPipelineCache(); };
        host.keepPipelines = savePipelineCache;
        host.prepare = [this](Renderer& renderer) { renderer.setOverlayGlyphs(panel_->glyphs()); };
        host.lost = sayWarning;
        return host;
    }

    Viewer& viewer() { return session_.viewer(); }
    Renderer& renderer() { return *session_.renderer(); }

    SavedView firstView() const {
        SavedView view = options_.first;
        if (options_.restore)
            if (const auto saved = loadState()) view = *saved;
        if (view.input.empty()) view.input = "sample:dna";
        view.input = lasting(view.input);
        return view;
    }

    ViewerOptions viewerOptions() const {
        ViewerOptions options;
        options.occlusionBytes = options_.occlusionBytes;
        options.occlusionCache = cacheFolder(options_.input.cache, "occlusion");
        options.tuning = options_.tuning;
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
            if (!iconified) return viewer().resume(now());
            viewer().pause();
            saveState(viewer().view());
        };
        e.damaged = [this] { viewer().overlayChanged(); };
        e.pointer = [this](glm::dvec2 at) {
            noteInput();
            pointer_ = at;
            panel_->pointer(at);
            if (!panelDrag_) viewer().mouseMove(at / scale_, now());
        };
        e.button = [this](MouseButton button, bool down, Modifiers with) {
            noteInput();
            // Who got the press gets the release.
            if (down) panelDrag_ = panel_->ownsPointer();
            if (panelDrag_)
                panel_->button(button, down);
            else
                viewer().mouseButton(button, down, pointer_ / scale_, with, now());
            if (!down) panelDrag_ = false;
        };
        e.wheel = [this](double steps) {
            noteInput();
            if (panel_->ownsPointer())
                panel_->wheel(steps);
            else
                viewer().wheel(steps, pointer_ / scale_, now());
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
        e.dropped = [this](const std::string& path) { viewer().open(lasting(path), now()); };
        return e;
    }

    /// The window came to a display of another density: text is drawn anew at its size.
    void rescaled() {
        scale_ = window_.pixelsPerPoint();
        panel_ = makePanel();
        renderer().setOverlayGlyphs(panel_->glyphs());
    }

    void resized() {
        const PixelSize size = window_.size();
        if (size.width == 0 || size.height == 0) return viewer().pause();
        if (window_.pixelsPerPoint() != scale_) rescaled();
        viewer().resize(size, scale_, now());
        viewer().resume(now());
    }

    void run(ViewerCommand command) {
        switch (command) {
            case ViewerCommand::panel:
                panel_->togglePanel();
                return viewer().overlayChanged();
            case ViewerCommand::help:
                panel_->toggleHelp();
                return viewer().overlayChanged();
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
        viewer().run(command, now());
    }

    /// The picture as PNG, or the view as JSON, in the current folder under a name that is free.
    void save(bool picture) {
        if (!viewer().document()) return;
        try {
            const std::string path = freeName(viewer().document()->view.input, picture ? ".png" : ".view.json");
            OutputFile file(path);
            if (picture) {
                RenderSettings settings = viewer().settings();
                settings.supersample = viewer().mostSamples();
                const SavedView view = viewer().savedView();
                const Document& document = *viewer().document();
                Picture drawn = renderer().render(settings);
                WordPainter().paint(placeWords(view.words, *document.molecule, document.scene), settings.view,
                                    viewer().textSize(), view.words.color, view.background, drawn);
                writePicture(file, drawn, {});
            } else {
                SavedView view = viewer().savedView();
                view.hash = fileHash(view.input);
                writeText(file, savedViewJson(view));
            }
            viewer().say("saved " + path, now());
        } catch (const Error& error) {
            viewer().say(error.what(), now());
        }
    }

    /// The next frame, drawn at once, in the current folder under a name that is free; in RenderDoc's own if that
    /// started us.
    void captureFrame() {
        if (!renderer().captures())
            return viewer().say(capturesBuilt() ? "F12 needs RenderDoc from the start: nacre view --capture"
                                                : "this program was built without RenderDoc's header",
                                now());
        if (!viewer().document()) return;
        try {
            std::optional<OutputFile> file;
            if (!renderer().startedByRenderDoc()) file.emplace(freeName(viewer().document()->view.input, ".rdc"));
            renderer().beginCapture(file ? captureStem(*file) : "");
            WindowFrame frame;
            frame.overlay = panel_->draw(viewer(), window_.size(), now());
            const bool shown = renderer().present(viewer().settings(), frame) == FrameOutcome::shown;
            const std::string written = renderer().endCapture();
            if (!shown) throw Error("cannot capture", "", "the window is changing");
            if (file) keepCapture(written, *file);
            viewer().say("captured to " + (file ? file->path() : written), now());
        } catch (const Error& error) {
            viewer().say(error.what(), now());
        }
    }

    void writeStats() {
        nlohmann::ordered_json json;
        json["window_frames"] = renderer().stats().windowFrames;
        json["seconds_since_last_frame"] = now() - lastShown_;
        json["occlusion"] = viewer().occlusion();
        json["occlusion_cached"] = renderer().stats().occlusion.cached;
        json["occlusion_bytes"] = renderer().stats().occlusion.bytes;
        if (!latencies_.empty()) {
            std::sort(latencies_.begin(), latencies_.end());
            json["input_to_present"] = {{"min", latencies_.front()}, {"median", latencies_[latencies_.size() / 2]}};
        }
        json["picked"] = nlohmann::ordered_json::array();
        for (const std::uint32_t pick : viewer().picks()) json["picked"].push_back(pick + 1);
        json["device"] = renderer().stats().device.name;
        OutputFile file(options_.stats, ".json");
        writeText(file, jsonText(json));
    }

    ViewOptions options_;
    Window window_;
    std::unique_ptr<Panel> panel_;
    Session session_;
    glm::dvec2 pointer_{};
    double scale_ = 0, lastFrame_ = 0, lastShown_ = 0;
    double inputAt_ = 0;             // when the first input came that no frame has answered; 0: none did
    std::vector<double> latencies_;  // of frames that answered some, milliseconds until they were handed to the display
    std::uint64_t shown_ = 0;        // frames, when lastShown_ was
    bool panelDrag_ = false;
};

}  // namespace

void viewCommand(const ViewOptions& options) { WindowSession(options).loop(); }

}  // namespace nacre::app
