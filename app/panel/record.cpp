// A film for a file: what moves, how long, how large, and how far it is.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kRecordPoints = 460;
constexpr std::array kMotions = {"A whole turn", "To and fro", "Models", "Kept views"};
constexpr std::array kFilmSizes = {"As on the screen", "Wide, 1920 x 1080", "Wide, 1280 x 720", "Square, 1080"};
constexpr std::array kFilmFormats = {"MP4", "WebM", "GIF", "Animated PNG"};
constexpr std::array kFilmExtensions = {".mp4", ".webm", ".gif", ".png"};
constexpr int kLongestSeconds = 120;
constexpr double kSecondsAView = 2;
constexpr float kFramesPerSecond = 30, kFramesPerSecondOfGif = 25;

template <std::size_t count>
int indexOf(const std::array<const char*, count>& names, const std::string& name) {
    return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::string timeText(double seconds) {
    std::array<char, 40> text{};
    if (seconds < 90)
        std::snprintf(text.data(), text.size(), "%.0f s left", std::ceil(seconds));
    else
        std::snprintf(text.data(), text.size(), "%.0f min left", std::ceil(seconds / 60));
    return text.data();
}

/// H.264 wants even numbers.
PixelSize even(PixelSize size) { return {std::max(size.width & ~1u, 2u), std::max(size.height & ~1u, 2u)}; }

}  // namespace

void Panel::drawRecord(Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    State& s = *state_;
    if (beginCard("Record", "Record a film", kRecordPoints)) recording_ = false;
    ui.heading("What moves");
    std::vector<const char*> motions(kMotions.begin(), kMotions.end());
    motions[2] = viewer.hasTrajectory() ? "Frames" : "Models";
    if (viewer.playback().frames() < 2) motions.erase(motions.begin() + 2);
    std::string motion =
        s.motion == 2 && viewer.hasTrajectory() ? "Frames" : kMotions[static_cast<std::size_t>(s.motion)];
    if (ui.choose("Motion", motions, motion)) {
        s.motion = motion == "Frames" ? 2 : indexOf(kMotions, motion);
        s.filmSeconds = 0;
    }
    if (s.motion == 2 && viewer.playback().frames() < 2) s.motion = 0;
    const bool views = s.motion == 3;
    if (views) drawKeyViews(viewer, now);
    drawFilmLength(viewer);
    ui.heading("Size");
    std::string size = kFilmSizes[static_cast<std::size_t>(s.filmSize)];
    if (ui.choose("Film size", kFilmSizes, size)) s.filmSize = indexOf(kFilmSizes, size);
    ui.heading("Format");
    std::string format = kFilmFormats[static_cast<std::size_t>(s.filmFormat)];
    const auto rename = [&] {
        const char* extension = kFilmExtensions[static_cast<std::size_t>(s.filmFormat)];
        if (host_.freeName) std::snprintf(s.film, sizeof s.film, "%s", host_.freeName(extension).c_str());
    };
    if (ui.choose("Film format", kFilmFormats, format)) {
        s.filmFormat = indexOf(kFilmFormats, format);
        rename();
    }
    if (s.film[0] == '\0') rename();
    const bool video = s.filmFormat < 2;
    if (video && !host_.videos) ui.caption("MP4 and WebM need the program ffmpeg, which is not installed.");
    if (s.filmFormat > 0) ui.toggle("Transparent background", s.filmTransparent);
    ui.heading("Where to");
    ui.field("Film path", "film.mp4", s.film, sizeof s.film);
    ui.folderOf(s.film);
    ImGui::Spacing();
    const bool can = s.film[0] != '\0' && (!views || s.keys.size() > 1) && (!video || host_.videos);
    ImGui::BeginDisabled(!can);
    if (ui.button(Icon::record, "Record", 0, true)) {
        const PixelSize sizes[] = {even(viewer.size()), {1920, 1080}, {1280, 720}, {1080, 1080}};
        RecordingWish wish;
        wish.motion = static_cast<RecordingWish::Motion>(s.motion);
        wish.seconds = static_cast<double>(s.filmSeconds);
        wish.framesPerSecond = s.filmFormat == 2 ? kFramesPerSecondOfGif : kFramesPerSecond;
        wish.size = sizes[s.filmSize];
        wish.loop = s.filmLoop;
        wish.transparent = s.filmTransparent && s.filmFormat > 0;
        wish.path = s.film;
        recording_ = false;
        s.film[0] = '\0';
        host_.record(wish, s.keys);
        restless_ = 3;
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ui.button(Icon::none, "Cancel")) recording_ = false;
    endCard();
}

void Panel::drawKeyViews(Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    std::vector<SavedView>& keys = state_->keys;
    if (keys.size() < 2) ui.caption("Keep two views or more: a film goes smoothly from one to the next.");
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string number = std::to_string(i + 1);
        const float signs = 2 * (ui.rowHeight() + ImGui::GetStyle().ItemSpacing.x);
        if (ui.button(Icon::eye, ("View " + number).c_str(), ImGui::GetContentRegionAvail().x - signs))
            viewer.show(keys[i], now);
        ImGui::SameLine();
        if (ui.sign(Icon::up, ("Move view " + number + " up").c_str(), i > 0)) std::swap(keys[i], keys[i - 1]);
        ImGui::SameLine();
        const bool removed = ui.sign(Icon::close, ("Remove view " + number).c_str());
        ImGui::PopID();
        if (!removed) continue;
        keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(i));
        break;
    }
    if (ui.button(Icon::eye, "Keep this view", -1)) keepView(viewer, now);
    if (keys.size() < 2) return;
    ui.toggle("Back to the first", state_->filmLoop);
    if (!ui.button(Icon::play, "Preview", -1)) return;
    recording_ = false;
    state_->previewed = 1;
    state_->previewDue = now;
}

/// Flies from one kept view to the next, as long as the film takes, and comes back to the film.
void Panel::preview(Viewer& viewer, double now) {
    State& s = *state_;
    if (s.previewed == 0) return;
    const std::size_t stops = s.keys.size() + (s.filmLoop ? 1 : 0);
    const bool over = help_ || saving_ || recording_ || start_ || s.keys.size() < 2;
    if (over || (now >= s.previewDue && s.previewed > stops)) {
        s.previewed = 0;
        if (!over) showRecord();
        return;
    }
    restless_ = std::max(restless_, 1);
    if (now < s.previewDue) return;
    const double stretch = std::max(static_cast<double>(s.filmSeconds), 0.5) / static_cast<double>(stops - 1);
    const double flight = s.previewed == 1 ? CameraMotion::kFlightSeconds : stretch;
    viewer.show(s.keys[(s.previewed - 1) % s.keys.size()], now, flight);
    s.previewDue = now + flight;
    ++s.previewed;
}

void Panel::keepView(const Viewer& viewer, double) {
    std::vector<SavedView>& keys = state_->keys;
    if (!viewer.document()) return;
    // Views of another molecule are of no use beside this one.
    std::erase_if(keys, [&](const SavedView& key) { return key.input != viewer.view().input; });
    keys.push_back(viewer.savedView());
    state_->filmSeconds = 0;
    restless_ = 2;
}

std::size_t Panel::keptViews() const { return state_->keys.size(); }

void Panel::drawFilmLength(const Viewer& viewer) {
    Widgets& ui = state_->ui;
    State& s = *state_;
    if (s.filmSeconds <= 0) {
        const double stretches = static_cast<double>(s.keys.size()) - (s.filmLoop ? 0 : 1);
        const double usual[] = {6, 4, static_cast<double>(viewer.playback().frames()) / viewer.playback().rate(),
                                kSecondsAView * std::max(stretches, 1.0)};
        s.filmSeconds = static_cast<float>(std::clamp(usual[s.motion], 0.5, double{kLongestSeconds}));
    }
    ui.heading("Length");
    ImGui::SetNextItemWidth(-1);
    ui.slideRate("Length", s.filmSeconds, 0.5f, kLongestSeconds, "%.1f seconds");
}

/// A film that is being recorded, or how the last one ended if that was badly.
void Panel::drawRecording() {
    if (!host_.recording) return;
    const RecordingState recording = host_.recording();
    if (!recording.running) return;
    Widgets& ui = state_->ui;
    beginProgress("Recording");
    ui.name("Recording " + recording.path);
    std::string text = recording.stopping ? "stopping"
                       : recording.frames == 0
                           ? "preparing"
                           : "frame " + std::to_string(recording.frame) + " of " + std::to_string(recording.frames);
    if (recording.left >= 0 && !recording.stopping) text += ", " + timeText(recording.left);
    ui.progress(recording.share, text);
    if (ui.button(Icon::close, "Stop")) host_.stopRecording();
    ImGui::SameLine();
    ui.caption("What is done by then is kept.");
    endGrown();
}

}  // namespace nacre::app
