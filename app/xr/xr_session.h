#pragma once
// The headset's shell: poses and hands around the viewer.

#include <functional>
#include <optional>

#include "app/viewer/session.h"
#include "app/xr/headset.h"

namespace nacre::app {

class HeadsetSession {
public:
    /// The molecule is put so far ahead of where the head is at first, and its picture's shorter side is so long.
    static constexpr double kMetresAhead = 0.8, kMetresAcross = 0.5;
    static constexpr int kMostLosses = 3;

    /// @throws Error, also that of a molecule that cannot be read, if known by then
    explicit HeadsetSession(const PictureDescription& first);
    ~HeadsetSession();

    /// Until user or runtime end it, or somebody asks.
    void loop(const std::function<bool()>& asked = {});
    /// One frame of the headset, or a rest where it wants none. @returns whether there is more to come. @throws Error
    bool step();

    Viewer& viewer() { return session_.viewer(); }
    const Renderer* renderer() const { return session_.renderer(); }

private:
    SessionHost host();
    static double now();
    void open();
    void drawFrame();
    void follow(const std::optional<Hand>& hand, const std::array<EyePose, 2>& eyes);
    FrameOutcome present(Renderer& renderer, const RenderSettings& settings);
    void tell();

    PictureDescription first_;
    Headset headset_;
    Session session_;
    Placement placement_;
    std::optional<Grip> grip_;
    std::optional<std::array<EyePose, 2>> eyes_;   // of the frame that is drawn
    std::optional<std::array<EyePose, 2>> shown_;  // by its image
    std::string told_;
    int losses_ = 0;  // since a frame was shown
};

}  // namespace nacre::app
