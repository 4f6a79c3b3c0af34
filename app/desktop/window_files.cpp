// Files of the window: pictures, views, captures, the list of recent files, statistics.

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "app/desktop/processes.h"
#include "app/desktop/state_files.h"
#include "app/desktop/window_session.h"
#include "app/drawing/drawing.h"
#include "app/drawing/map_layers.h"
#include "app/files/capture_file.h"
#include "app/files/json_text.h"
#include "app/images/image_file.h"
#include "app/input/input_files.h"
#include "app/mvs/write_scene.h"
#include "app/picture/picture_names.h"
#include "engine/error.h"
#include "engine/molecule/read.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app {

/// Moves the document to the top of the recent files, with its current picture.
void WindowSession::rememberFile() {
    const Document* document = viewer().document();
    if (!document || document->view.input.path == "-" || document->view.input.path.starts_with("sample:")) return;
    try {
        constexpr PixelSize kSize = RecentFiles::kPicture;
        RenderSettings settings = viewer().frames().pictureSettings(kSize);
        settings.supersample = 2;
        settings.debug = DebugView::none;
        settings.effects.contours.width = settings.effects.halos.width = 0;
        const PictureDescription& view = document->view;
        const std::string& input = view.view.empty() ? view.input.path : view.view;
        recent_.add(input, std::filesystem::path(input).filename().string(), renderer().render(settings));
    } catch (const Error&) {
        // A missing picture must not prevent quitting.
    }
}

std::vector<RecentFile> WindowSession::sampleFiles() const {
    std::vector<RecentFile> files;
    for (const auto& [name, input] : kSampleNames) {
        RecentFile file{input, name, 0, 0, {}};
        const std::uint32_t width = files.empty() ? RecentFiles::kBanner.width : RecentFiles::kPicture.width;
        for (const RecentFile& drawn : samples_.files())
            if (drawn.input == file.input && drawn.width == width) file = drawn;
        files.push_back(std::move(file));
    }
    return files;
}

/// Draws a sample that has no picture yet, if nothing is open and no other work is pending. @returns whether it did
bool WindowSession::drawSample() {
    if (viewer().document() || viewer().reading().loader().busy()) return false;
    while (triedSamples_ < shownSamples_.size()) {
        const RecentFile sample = shownSamples_[triedSamples_++];
        if (sample.width > 0) continue;
        try {
            PictureDescription picture;
            picture.input.path = sample.input;
            const PixelSize size = triedSamples_ == 1 ? RecentFiles::kBanner : RecentFiles::kPicture;
            picture.size = {size.width, size.height};
            picture.supersample = 2;
            picture.aim.principal = true;
            const Molecule molecule = sampleMolecule(sample.input.substr(sample.input.find(':') + 1));
            Drawing drawing;
            drawing.prepare(molecule, picture);
            renderer().setScene(drawing.joinedScene());
            samples_.add(sample.input, sample.name, drawing.drawAs(drawing.settings, renderer()));
            shownSamples_ = sampleFiles();
        } catch (const std::exception&) {
            // The sample stays without a picture.
        }
        try {
            renderer().setScene({});
        } catch (const Error&) {
            // The next frame notices a lost device.
        }
        viewer().schedule().overlayChanged();
        return true;
    }
    return false;
}

std::string WindowSession::pictureName(const char* extension) {
    return freeName(viewer().document() ? viewer().document()->view.input.path : "nacre", extension);
}

void WindowSession::savePicture(const PictureWish& wish) {
    try {
        writePictureTo(wish);
        viewer().messages().say(savedMessage(wish.path), now());
    } catch (const std::exception& error) {
        viewer().messages().fail(error.what(), now());
    }
}

void WindowSession::writePictureTo(const PictureWish& wish) {
    const auto& [size, transparent, path, dpi, marked] = wish;
    if (!isPictureName(path))
        throw Error("cannot save the picture", path, "its name must end in .png, .tif, .jpg, .webp or .exr");
    OutputFile file(path);
    const double shorter = std::min(window_.size().width, window_.size().height);
    const bool asShown = size.width == window_.size().width && size.height == window_.size().height;
    const double textSize =
        viewer().words().size() * (asShown ? 1 : std::min(size.width, size.height) / std::max(shorter, 1.0));
    PictureDescription picture = viewer().picking().measuredView();
    picture.size = {size.width, size.height};
    picture.output = path;
    picture.words.size = textSize;
    // The window's own size uses the window's anti-aliasing; other sizes use that of pictures.
    picture.supersample = asShown ? viewer().frames().mostSamples() : RenderSettings::kEdges;
    if (transparent) picture.background = {0, 0, 0, 0};
    PictureFormat format{.alpha = transparent, .dpi = static_cast<double>(dpi)};
    writePicture(file, viewer().frames().draw(renderer(), std::move(picture), marked), format);
}

void WindowSession::copyPicture() {
    if (!viewer().document()) return;
    try {
        const std::string path =
            (std::filesystem::temp_directory_path() / ("nacre-" + std::to_string(getpid()) + ".png")).string();
        writePictureTo({window_.size(), false, path});
        const bool copied = copyPng(path);
        std::filesystem::remove(path);
        if (!copied) throw Error("cannot copy the picture", "", kCopyNeeds);
        viewer().messages().say("copied the picture", now());
    } catch (const std::exception& error) {
        viewer().messages().fail(error.what(), now());
    }
}

void WindowSession::record(const RecordingWish& wish, const std::vector<PictureDescription>& keys) {
    try {
        const PictureDescription shown = viewer().picking().savedView();
        if (shown.input.path == "-") throw Error("cannot record", "-", "movies need a file, not standard input");
        std::vector<std::string> fixed;
        if (!options_.first.device.device.empty())
            fixed.insert(fixed.end(), {"--device", options_.first.device.device});
        if (options_.first.input.cache) fixed.insert(fixed.end(), {"--cache", *options_.first.input.cache});
        if (options_.first.input.offline) fixed.push_back("--offline");
        recorder_.start(wish, shown, keys, fixed);
        wasRecording_ = true;
    } catch (const Error& error) {
        viewer().messages().fail(error.what(), now());
    }
}

/// Updates the panel during a recording, and reports its result.
void WindowSession::tellRecording() {
    if (!wasRecording_) return;
    const RecordingState state = recorder_.state();
    const std::string told = std::to_string(state.frame) + (state.stopping ? "stopping" : "");
    if (std::exchange(told_, told) != told) viewer().schedule().overlayChanged();
    if (state.running) return;
    wasRecording_ = false;
    if (state.failed)
        viewer().messages().fail(state.message, now());
    else
        viewer().messages().say(state.message, now());
}

/// Asks where to write a file. Adds the extension to names without it.
void WindowSession::askWhere(const char* title, const char* extension,
                             void (WindowSession::*write)(const std::string& path)) {
    if (!viewer().document()) return;
    viewer().schedule().overlayChanged();
    panel_->askWhere(title, freeName(viewer().document()->view.input.path, extension), [=, this](std::string path) {
        if (!path.ends_with(extension)) path += extension;
        try {
            (this->*write)(path);
            if (quitsOnceSaved_) window_.close();
        } catch (const std::exception& error) {
            viewer().messages().fail(error.what(), now());
        }
    });
}

/// @throws Error
void WindowSession::writeView(const std::string& path) {
    OutputFile file(path);
    writeText(file, savedViewJson(withPathsIn(path, viewer().picking().savedView())));
    viewer().noteSaved();
    viewer().messages().say(savedMessage(path), now());
}

/// As MolViewSpec. Reports what the format cannot express. @throws Error
void WindowSession::writeScene(const std::string& path) {
    const Document& document = *viewer().document();
    OutputFile file(path);
    PictureDescription view = viewer().picking().savedView();
    const RenderSettings shown = viewer().frames().settings();
    view.background = shown.background;
    const mvs::WrittenScene written =
        mvs::writeScene(*document.placed, view, sceneVolumes(view),
                        makeCamera(shown.view, document.drawing.scene().center, !document.molecule->guide), path);
    writeText(file, written.json);
    std::string told = savedMessage(path);
    for (const std::string& note : written.notes) told += "; " + note;
    viewer().messages().say(told, now());
}

/// Captures the next frame, drawn at once, in the current folder under an unused name; in RenderDoc's folder if that
/// started us.
void WindowSession::captureFrame() {
    if (!renderer().captures())
        return viewer().messages().say(capturesBuilt() ? "F12 needs RenderDoc from the start: nacre view --capture"
                                                       : "this program was built without RenderDoc's header",
                                       now());
    if (!viewer().document()) return;
    try {
        std::optional<OutputFile> file;
        if (!renderer().startedByRenderDoc()) file.emplace(freeName(viewer().document()->view.input.path, ".rdc"));
        renderer().beginCapture(file ? captureStem(*file) : "");
        WindowFrame frame{.overlay = panel_->draw(viewer(), window_.size(), now())};
        const bool shown = renderer().present(viewer().frames().settings(), frame) == FrameOutcome::shown;
        const std::string written = renderer().endCapture();
        if (!shown) throw Error("cannot capture", "", "the window is changing");
        if (file) keepCapture(written, *file);
        viewer().messages().say("captured to " + (file ? file->path() : written), now());
    } catch (const Error& error) {
        viewer().messages().say(error.what(), now());
    }
}

void WindowSession::writeStats() {
    nlohmann::ordered_json json;
    json["window_frames"] = renderer().stats().windowFrames;
    json["pace"] = paceName(renderer().stats().windowPace.state);
    json["display_ms"] = renderer().stats().windowPace.displayMilliseconds;
    json["seconds_since_last_frame"] = now() - lastShown_;
    if (sceneShown_ > 0)
        json["start_ms"] = {{"before_device", 1000 * (opening_ - kStarted)},
                            {"device", 1000 * (open_ - opening_)},
                            {"first_picture", 1000 * (sceneShown_ - kStarted)}};
    json["occlusion"] = viewer().frames().occlusion();
    json["occlusion_cached"] = renderer().stats().occlusion.cached;
    json["occlusion_bytes"] = renderer().stats().occlusion.bytes;
    if (!latencies_.empty()) {
        std::sort(latencies_.begin(), latencies_.end());
        json["input_to_present"] = {{"min", latencies_.front()}, {"median", latencies_[latencies_.size() / 2]}};
    }
    const MotionFrames& moved = viewer().schedule().motionFrames();
    if (moved.frames > 0)
        json["motion"] = {{"frames", moved.frames},
                          {"reduced", moved.reduced},
                          {"smallest_scale", moved.smallestScale},
                          {"frame_ms", renderer().stats().windowMilliseconds}};
    json["picked"] = nlohmann::ordered_json::array();
    for (const std::uint32_t pick : viewer().picking().picks()) json["picked"].push_back(pick + 1);
    json["device"] = renderer().stats().device.name;
    OutputFile file(options_.first.stats, ".json");
    writeText(file, jsonText(json));
}

}  // namespace nacre::app
