#pragma once
// The headset's shell: passes poses and hands to the viewer.

#include <functional>
#include <optional>

#include "app/viewer/session.h"
#include "app/xr/headset.h"

namespace nacre::app {

class HeadsetSession {
public:
    /// The molecule's initial distance in front of the head, and the length of the shorter side of its picture.
    static constexpr double kMetresAhead = 0.8, kMetresAcross = 0.5;
    static constexpr int kMostLosses = 3;

    /// @throws Error, also for a molecule that cannot be read, if already known
    explicit HeadsetSession(const PictureDescription& first);
    ~HeadsetSession();

    /// Runs until the user or the runtime ends the session, or `asked` returns true.
    void loop(const std::function<bool()>& asked = {});
    /// Draws one frame, or sleeps briefly while the headset wants none. @returns whether to continue @throws Error
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
    std::optional<std::array<EyePose, 2>> eyes_;   // of the current frame
    std::optional<std::array<EyePose, 2>> shown_;  // in its image
    std::string told_;
    int losses_ = 0;  // since the last shown frame
};

}  // namespace nacre::app
