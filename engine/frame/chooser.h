#pragma once
// How choose() decides, step by step. Used by the sources choose*.cpp alone.

#include "engine/frame/choose.h"

namespace nacre {

inline constexpr const char* kAskedFor = "asked for";

/// Like choosePath(), without the reason, which would allocate.
Visibility pickPath(const graph::FrameCaps& device);
/// Like chooseMotionSamples(), without the reason, which would allocate.
std::uint32_t motionSamples(const graph::FrameCaps& device);

class GeometryWorks;

/// Makes one choice, step by step. Steps note their reasons on request.
class Chooser {
public:
    Chooser(const FrameRequest& request, const SceneFacts& scene, const graph::FrameCaps& device,
            std::vector<Decision>* reasons = nullptr)
        : request_(request), settings_(drawnSettings(request)), scene_(scene), device_(device), reasons_(reasons) {}

    FrameChoice choose() {
        choice_.part = request_.part;
        choice_.debug = settings_.debug;
        choice_.encoded = device_.encoded;
        chooseSamples();
        chooseEffects();
        chooseColor();
        choosePath();
        chooseGeometry();
        chooseEnding();
        chooseOverflow();
        chooseViews();
        chooseFoveation();
        chooseVertices();
        return choice_;
    }
    Samples samples() {
        chooseSamples();
        return choice_.samples;
    }

private:
    template <typename Why>
    void because(const char* what, const Why& why) {
        if (reasons_) reasons_->push_back({what, {}, why});
    }

    void replaceReason(const char* what, const char* why) {
        if (!reasons_) return;
        std::erase_if(*reasons_, [&](const Decision& d) { return d.what == what; });
        because(what, why);
    }

    bool debugs() const { return settings_.debug != DebugView::none; }
    bool rims() const { return settings_.effects.rims(); }

    /// Whether compute may shade pictures: on software devices always, on others if they draw by tiles.
    bool mayCompute() const {
        return device_.tiles.shade && (!device_.tiles.lists || pickPath(device_) == Visibility::tiles);
    }
    /// The device's path, or the path of frames that add samples or depth to a picture. Devices that shade by tiles
    /// always draw those by tiles: other paths draw each sample as a pixel.
    Visibility usual(bool adds) const { return adds && mayCompute() ? Visibility::tiles : pickPath(device_); }
    bool adds() const {
        switch (choice_.part) {
            case Part::edges:
            case Part::block:
            case Part::distances:
                return true;
            case Part::coarse:
                return rims();  // else only `deferred` draws them
            default:
                return false;
        }
    }

    void chooseEffects();
    void chooseColor();
    void choosePath();
    void chooseGeometry();
    HostWork hostWorkOfTiles() const;
    HostWork chooseHostWork(Visibility path) const;
    bool needsPrepass(Visibility path, PlateShape plates) const;
    void chooseEnding();
    void chooseOverflow();
    const char* lackOfViews() const;
    void chooseViews();
    const char* lackOfFoveation() const;
    void chooseFoveation();

    // In choose_samples.cpp:
    void chooseSamples();
    bool canDrawEdges(bool adds) const;
    bool hasFrontSpheres() const;
    bool hasSmallSpheres() const;
    bool isCrowd() const;
    const char* blind() const;
    void refine();

    // In choose_vertices.cpp:
    std::uint32_t renderPassesBeyond() const;
    std::uint64_t mostVertexBytes() const;
    Rounds planRounds(const passes::PassCost& cost, const passes::PrimitiveCounts& counts) const;
    GeometryWorks planGeometry(Visibility path, const passes::SphereShapes& shapes) const;
    VertexOutputs fitted(Visibility path) const;
    void chooseVertices();

    const FrameRequest& request_;
    const RenderSettings settings_;
    const SceneFacts& scene_;
    const graph::FrameCaps& device_;
    std::vector<Decision>* reasons_;
    FrameChoice choice_;
};

}  // namespace nacre
