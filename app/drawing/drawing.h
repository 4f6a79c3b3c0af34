#pragma once
// From a molecule and a description to a picture. It keeps the scene, and the renderer keeps what is baked for it: a
// description that differs from the last one has only those parts of the work done again that differ.

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

/// A renderer, and which scene it has.
struct Canvas {
    explicit Canvas(const DeviceOptions& options) : renderer(options) {}
    Renderer renderer;
    std::uint64_t scene = 0;  ///< a number of Drawing's; 0: none of one
};

class Drawing {
public:
    /// Brings everything up to a description. Needs no device.
    /// @param molecule  the same as before, unless forget() was called
    /// @param frame  that all models of its file share (shared_frame.h), if that is known; else it is found, if it can
    /// be
    /// @throws Error if nothing of the molecule is drawn, or a selection has no drawn atom
    void prepare(const Molecule& molecule, const PictureDescription& description,
                 const std::optional<Bounds>& frame = {});
    /// The molecule is going to be another one, or its atoms elsewhere.
    void forget() {
        scene_.reset();
        facts_.reset();
    }

    /// Puts the scene on a canvas, unless it is there. Occlusion that was baked for it stays.
    void show(Canvas& canvas);
    /// The same for the last time: the canvas takes the scene away.
    void handOver(Canvas& canvas);
    /// A picture in its full size, with its words. @returns labels that found no room in `crowded`
    Picture draw(Canvas& canvas, std::size_t* crowded = nullptr);
    /// Layers of the scene, which the renderer has. Depths of all frames of a trajectory have one origin.
    LayerPicture layers(Renderer& renderer) const;
    /// Writes the words into a picture. @returns the labels that found no room
    /// @param settings  that it was drawn with  @param memory  of pictures that follow each other
    std::size_t addWords(const RenderSettings& settings, Picture& picture, WordMemory* memory = nullptr) const;

    /// Of the molecule elsewhere, in a scene about the same centre: the words, and the scene with what is beside it.
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
    RunStats run;                       ///< as far as it is known by then
    std::vector<std::string> warnings;  ///< of the scene: what is not as it was asked for

    /// How often the expensive parts were done.
    struct Counts {
        int scenes = 0;   ///< built
        int uploads = 0;  ///< to a canvas, which drops its bake
    };
    const Counts& counts() const { return counts_; }

private:
    void bringUpTo(const ResidueFacts& facts, const PictureDescription& description,
                   const std::optional<Bounds>& frame);
    void putWords(const ResidueFacts& facts);
    void makeRoom();

    PictureDescription description_;
    std::optional<ResidueFacts> facts_;  ///< of the molecule
    std::optional<Representation> scene_;
    MapLayers maps_;
    std::uint64_t number_ = 0;  ///< of scene_ with maps_
    double radius_ = 0;         ///< that the camera goes by, Å
    /// How far the plane or the eye that depths count from stands behind that of the trajectory's first frame, Å.
    double depthShift_ = 0;
    Counts counts_;
};

}  // namespace nacre::app
