#pragma once
// Draws a molecule by a description. Keeps the scene, and the renderer keeps its bake: a new description repeats only
// the work affected by its changes.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/annotation/layout.h"
#include "app/drawing/map_layers.h"
#include "app/drawing/run_stats.h"
#include "app/picture/description.h"
#include "engine/molecule/residue_facts.h"
#include "engine/renderer.h"

namespace nacre::app {

/// A renderer, and the scene that it has.
struct Canvas {
    explicit Canvas(const DeviceOptions& options) : renderer(options) {}
    /// Whether it should be made anew. The renderer keeps each pipeline, of which lavapipe takes megabytes for some.
    bool isFull() const { return renderer.stats().pipelines > kMostPipelines; }

    static constexpr std::uint64_t kMostPipelines = 48;
    Renderer renderer;
    std::uint64_t scene = 0;  ///< a Drawing's scene number; 0: none
};

class Drawing {
public:
    /// Updates everything to a description. Needs no device.
    /// @param molecule  the same as before, unless forget() was called
    /// @param frame  shared by all models of its file (shared_frame.h), if known; else computed if possible
    /// @throws Error if nothing of the molecule is drawn, or a selection has no drawn atom
    void prepare(const Molecule& molecule, const PictureDescription& description,
                 const std::optional<Bounds>& frame = {});
    /// Call before the molecule or its positions change.
    void forget() {
        scene_.reset();
        facts_.reset();
    }

    /// Puts the scene on a canvas, if it is not there. Keeps the scene's bake.
    void show(Canvas& canvas);
    /// As above for the last time: moves the scene to the canvas.
    void handOver(Canvas& canvas);
    /// A picture in full size, with its words. @param said  gets warnings of these, if given
    Picture draw(Canvas& canvas, std::vector<std::string>* said = nullptr);
    /// As above, in 8 bits per channel.
    CodedPicture drawCoded(Canvas& canvas, bool alpha, std::vector<std::string>* said = nullptr);
    /// Whether startCoded() serves: no words are drawn, and 8 bits per channel hold the picture.
    bool startsCoded() const { return !words.any() && !settings.fine; }
    /// Starts a picture of drawCoded(), which the renderer's finishCoded() returns.
    void startCoded(Canvas& canvas, bool alpha);
    /// Layers of the scene on the renderer. Depths of all frames of a trajectory have one origin.
    LayerPicture layers(Renderer& renderer) const;
    /// Draws the words into a picture. @returns warnings of them
    /// @param settings  of the picture @param memory  of a sequence of pictures
    std::vector<std::string> addWords(const RenderSettings& settings, Picture& picture,
                                      WordMemory* memory = nullptr) const;

    /// Places words in another scene of the molecule, about the same centre; and adds maps and primitives to a scene.
    void placeWordsIn(const Representation& scene, const ResidueFacts& facts,
                      WordsOfHidden hidden = WordsOfHidden::refused);
    Representation withBeside(Representation scene) const { return withMaps(std::move(scene), maps_); }

    /// Colours a scene anew once it is built, before its legend is laid out. Who changes it calls forget().
    std::function<void(Representation&)> recolor;
    /// Without what is beside the molecule. Not after handOver().
    const Representation& scene() const { return *scene_; }
    const PictureDescription& description() const { return description_; }
    RenderSettings settings;
    PlacedWords words;
    RunStats run;                       ///< as far as known
    std::vector<std::string> warnings;  ///< of the scene: differences from the request

    /// Counts of expensive steps.
    struct Counts {
        int scenes = 0;   ///< built
        int uploads = 0;  ///< to a canvas
        int colors = 0;   ///< of these, colours alone; the others drop its bake
    };
    const Counts& counts() const { return counts_; }

private:
    void bringUpTo(const ResidueFacts& facts, const PictureDescription& description,
                   const std::optional<Bounds>& frame);
    void putWords(const ResidueFacts& facts);
    void viewScene(const Molecule& molecule);
    void makeRoom();

    PictureDescription description_;
    std::optional<ResidueFacts> facts_;  ///< of the molecule
    std::optional<Representation> scene_;
    MapLayers maps_;
    std::uint64_t number_ = 0;  ///< of scene_ with maps_
    bool seenByScene_ = false;  ///< from where a scene file's camera stands
    bool cutsScene_ = false;    ///< scene_ lacks what that camera's planes cut away
    double radius_ = 0;         ///< that the camera goes by, Å
    /// How far the plane or the eye that depths count from stands behind that of the trajectory's first frame, Å.
    double depthShift_ = 0;
    Counts counts_;
};

}  // namespace nacre::app
