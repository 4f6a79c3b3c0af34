// Recording of movies: motion, duration, size, and progress.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kRecordPoints = 460;
constexpr std::array kMotions = {"Full turn", "Rock", "Models", "Keyframes"};
constexpr std::array kMovieSizes = {"Screen size", "Wide, 1920 x 1080", "Wide, 1280 x 720", "Square, 1080"};
constexpr std::array kMovieFormats = {"MP4", "WebM", "GIF", "Animated PNG"};
constexpr std::array kMovieExtensions = {".mp4", ".webm", ".gif", ".png"};
constexpr int kLongestSeconds = 120;
constexpr double kSecondsAView = 2;
constexpr float kFramesPerSecond = 30, kFramesPerSecondOfGif = 25;

std::string timeText(double seconds) {
    const bool few = seconds < 90;
    return std::to_string(std::lround(std::ceil(few ? seconds : seconds / 60))) + (few ? " s left" : " min left");
}

/// H.264 needs even sides.
PixelSize even(PixelSize size) { return {std::max(size.width & ~1u, 2u), std::max(size.height & ~1u, 2u)}; }

void drawKeyViews(PanelFrame& f) {
    std::vector<PictureDescription>& keys = f.s.movie.keys;
    if (keys.size() < 2) f.ui.caption("Add two keyframes or more: the movie goes smoothly from one to the next.");
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string number = std::to_string(i + 1);
        const float signs = 2 * (f.ui.rowHeight() + ImGui::GetStyle().ItemSpacing.x);
        if (f.ui.button(Icon::eye, ("View " + number).c_str(), ImGui::GetContentRegionAvail().x - signs))
            f.viewer.show(keys[i], f.now);
        ImGui::SameLine();
        if (f.ui.sign(Icon::up, ("Move view " + number + " up").c_str(), i > 0)) std::swap(keys[i], keys[i - 1]);
        ImGui::SameLine();
        const bool removed = f.ui.sign(Icon::close, ("Remove view " + number).c_str());
        ImGui::PopID();
        if (!removed) continue;
        keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(i));
        break;
    }
    if (f.ui.button(Icon::eye, "Add keyframe", -1)) keepView(f.s, f.viewer);
    if (keys.size() < 2) return;
    f.ui.toggle("Back to the first", f.s.movie.loop);
    if (!f.ui.button(Icon::play, "Preview", -1)) return;
    f.s.recording = false;
    f.s.movie.previewed = 1;
    f.s.movie.previewDue = f.now;
}

void drawFilmLength(PanelFrame& f) {
    if (f.s.movie.seconds <= 0) {
        const PlayClock& clock = f.viewer.playback().clock();
        const double stretches = static_cast<double>(f.s.movie.keys.size()) - (f.s.movie.loop ? 0 : 1);
        const double usual[] = {6, 4, static_cast<double>(clock.frames()) / clock.rate(),
                                kSecondsAView * std::max(stretches, 1.0)};
        f.s.movie.seconds = static_cast<float>(std::clamp(usual[f.s.movie.motion], 0.5, double{kLongestSeconds}));
    }
    f.ui.slide("Length", f.s.movie.seconds, 0.5f, kLongestSeconds, "Length %.1f s", true);
}

}  // namespace

void drawRecord(PanelFrame& f) {
    if (beginCard(f, "Record", "Record movie", kRecordPoints)) f.s.recording = false;
    f.ui.heading("Type of motion");
    const bool moves = f.viewer.playback().clock().frames() > 1;
    if (f.s.movie.motion == 2 && !moves) f.s.movie.motion = 0;
    std::vector<const char*> motions(kMotions.begin(), kMotions.end());
    if (f.viewer.playback().hasTrajectory()) motions[2] = "Frames";
    if (f.viewer.playback().morphs()) motions[2] = "Morph";
    if (!moves) motions.erase(motions.begin() + 2);
    int motion = f.s.movie.motion - (f.s.movie.motion == 3 && !moves ? 1 : 0);
    if (f.ui.choose("Motion", motions, motion)) {
        f.s.movie.motion = motion + (motion == 2 && !moves ? 1 : 0);
        f.s.movie.seconds = 0;
    }
    const bool views = f.s.movie.motion == 3;
    if (views) drawKeyViews(f);
    drawFilmLength(f);
    f.ui.heading("Size");
    f.ui.choose("Movie size", kMovieSizes, f.s.movie.size);
    f.ui.heading("Format");
    const auto rename = [&] {
        const char* extension = kMovieExtensions[static_cast<std::size_t>(f.s.movie.format)];
        if (f.host.freeName) f.s.movie.path = f.host.freeName(extension);
    };
    if (f.ui.choose("Movie format", kMovieFormats, f.s.movie.format) || f.s.movie.path.empty()) rename();
    const bool video = f.s.movie.format < 2;
    if (video && !f.host.videos) f.ui.caption("MP4 and WebM need the program ffmpeg, which is not installed.");
    if (f.s.movie.format > 0) f.ui.toggle("Transparent background", f.s.movie.transparent);
    const bool entered = fieldOfPath(f, {"Movie path", "movie.mp4", "Record movie"}, f.s.movie.path,
                                     [&movie = f.s.movie](const std::string& path) {
                                         movie.path = path;
                                         for (std::size_t i = 0; i < kMovieExtensions.size(); ++i)
                                             if (path.ends_with(kMovieExtensions[i]))
                                                 movie.format = static_cast<int>(i);
                                     });
    ImGui::Spacing();
    const bool can = !f.s.movie.path.empty() && (!views || f.s.movie.keys.size() > 1) && (!video || f.host.videos);
    const Answer answers[] = {{"Cancel"}, {"Record", Icon::record, can}};
    const auto pressed = f.ui.answers(answers);
    if (pressed == 0u) f.s.recording = false;
    if (pressed == 1u || (entered && can)) {
        const PixelSize sizes[] = {even(f.viewer.frames().size()), {1920, 1080}, {1280, 720}, {1080, 1080}};
        RecordingWish wish;
        wish.motion = static_cast<RecordingWish::Motion>(f.s.movie.motion);
        if (wish.motion == RecordingWish::Motion::models && f.viewer.playback().morphs())
            wish.motion = RecordingWish::Motion::morph;
        wish.seconds = static_cast<double>(f.s.movie.seconds);
        wish.framesPerSecond = f.s.movie.format == 2 ? kFramesPerSecondOfGif : kFramesPerSecond;
        wish.size = sizes[f.s.movie.size];
        wish.loop = f.s.movie.loop;
        wish.transparent = f.s.movie.transparent && f.s.movie.format > 0;
        wish.path = f.s.movie.path;
        f.s.recording = false;
        f.s.movie.path.clear();
        f.host.record(wish, f.s.movie.keys);
        f.s.movie.keysRecorded |= views;
        f.s.restless = 3;
    }
    endGrown(f);
}

void previewMovie(PanelFrame& f) {
    PanelState& s = f.s;
    if (s.movie.previewed == 0) return;
    const std::size_t stops = s.movie.keys.size() + (s.movie.loop ? 1 : 0);
    const bool stopped = s.over() || s.movie.keys.size() < 2;
    if (stopped || (f.now >= s.movie.previewDue && s.movie.previewed > stops)) {
        s.movie.previewed = 0;
        if (!stopped) s.recording = true, s.restless = 2;
        return;
    }
    s.restless = std::max(s.restless, 1);
    if (f.now < s.movie.previewDue) return;
    const double stretch = std::max(static_cast<double>(s.movie.seconds), 0.5) / static_cast<double>(stops - 1);
    const double flight = s.movie.previewed == 1 ? CameraMotion::kFlightSeconds : stretch;
    f.viewer.show(s.movie.keys[(s.movie.previewed - 1) % s.movie.keys.size()], f.now, flight);
    s.movie.previewDue = f.now + flight;
    ++s.movie.previewed;
}

void keepView(PanelState& s, const Viewer& viewer) {
    if (!viewer.document()) return;
    // Views of another molecule cannot be combined with this one.
    const PictureDescription& view = viewer.view();
    std::erase_if(s.movie.keys, [&](const PictureDescription& key) { return key.input.path != view.input.path; });
    s.movie.keys.push_back(viewer.picking().savedView());
    s.movie.keysRecorded = false;
    s.movie.seconds = 0;
    s.restless = 2;
}

/// A running recording, or the error of the last one.
void drawRecording(PanelFrame& f) {
    if (!f.host.recording) return;
    const RecordingState recording = f.host.recording();
    if (!recording.running) return;
    beginProgress(f, "Recording");
    f.ui.name("Recording " + recording.path);
    std::string text = recording.stopping ? "stopping"
                       : recording.frames == 0
                           ? "preparing"
                           : "frame " + std::to_string(recording.frame) + " of " + std::to_string(recording.frames);
    if (recording.left >= 0 && !recording.stopping) text += ", " + timeText(recording.left);
    f.ui.progress(recording.share, text);
    if (f.ui.button(Icon::close, "Stop")) f.host.stopRecording();
    ImGui::SameLine();
    f.ui.caption("Finished frames are kept.");
    endGrown(f);
}

}  // namespace nacre::app
