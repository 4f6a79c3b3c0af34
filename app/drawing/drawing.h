#pragma once
// Turns a description into pixels. Keeps the scene, and the renderer keeps its bake: a new description repeats only the
// work that its changes affect.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/annotation/layout.h"
#include "app/drawing/map_layers.h"
#include "app/drawing/moving_picture.h"
#include "app/drawing/run_stats.h"
#include "app/drawing/stereo.h"
#include "app/picture/description.h"
#include "engine/molecule/residue_facts.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app {

/// A renderer, and its current scene.
struct Canvas {
    explicit Canvas(const DeviceOptions& options) : renderer(options) {}
    explicit Canvas(std::shared_ptr<SharedDevice> device) : renderer(std::move(device)) {}
    bool isLost() const { return !renderer.deviceLoss().empty(); }
    /// Whether to replace the renderer: it is lost, or holds too many pipelines. The renderer keeps each pipeline; some
    /// take megabytes on lavapipe.
    bool isSpent() const { return renderer.stats().pipelines > kMostPipelines || isLost(); }

    static constexpr std::uint64_t kMostPipelines = 48;
    Renderer renderer;
    std::uint64_t scene = 0;  ///< a Drawing's scene number; 0: none
};

/// Who sets the camera.
enum class CameraBy {
    description,  ///< its aim is applied, and a scene file's own camera is used if the description has none
    hand          ///< a window: its description contains all of that, and moving the camera rebuilds nothing
};

/// The parts of a drawing that a new description invalidates.
struct Rebuild {
    bool molecule = false;  ///< read again, or another of its frames
    bool scene = false;     ///< spheres, sticks and meshes
    bool maps = false;      ///< maps and primitives drawn with the molecule
    bool any() const { return molecule || scene || maps; }
};
Rebuild rebuildFor(const PictureDescription& before, const PictureDescription& after, CameraBy by);

class Drawing {
public:
    explicit Drawing(CameraBy by = CameraBy::description) : by_(by) {}

    // --- The scene. Slow; needs no device.

    /// Updates everything to a description: build(), then settings and words of its picture.
    /// @param molecule  the same as before, unless forget() was called
    /// @param frame  shared by all models of its file (shared_frame.h), if known; else computed if possible
    /// @throws Error if nothing of the molecule is drawn, or a selection has no drawn atom
    void prepare(const Molecule& molecule, const PictureDescription& description,
                 const std::optional<Bounds>& frame = {});
    /// Updates the scene, and the maps and primitives with it. @throws Error
    void build(const Molecule& molecule, const PictureDescription& description,
               const std::optional<Bounds>& frame = {});
    /// As above for moving atoms: the scene shows the molecule's current positions. @throws Error
    void buildMoving(const Molecule& first, const Molecule& now, const PictureDescription& description);
    /// Settings and words of a picture of the current scene. Camera, size and shading are the picture's.
    /// @throws Error if it has words about atoms that the molecule lacks
    void compose(const PictureDescription& picture);
    /// Call before the molecule or its positions change.
    void forget() {
        scene_.reset();
        facts_.reset();
        moving_.reset();
    }

    // --- Atoms that move

    /// Prepares moveTo(). @param first  the positions that decide selections, colours and camera @throws Error
    void startMoving(const Molecule& first);
    /// Shows the atoms at their positions in `molecule`: scene, words, depth range. The camera stays. @throws Error
    void moveTo(const Molecule& molecule);
    /// As above, with a scene from moving(). Its words are those of placeWords().
    void takeMoved(const Molecule& molecule, Representation scene);
    /// Makes the scenes of other positions, on any single thread; null: atoms do not move.
    const std::shared_ptr<MovingPicture>& moving() const { return moving_; }

    // --- On a canvas

    /// Puts the scene on a canvas unless it is there. Keeps the scene's bake.
    void show(Canvas& canvas);
    /// As above, for the last time: moves the scene to the canvas.
    void handOver(Canvas& canvas);
    /// A picture in full size, with its words. @param said  receives warnings about them; may be null
    Picture draw(Canvas& canvas, std::vector<std::string>* said = nullptr);
    /// As above, in 8 bits per channel.
    CodedPicture drawCoded(Canvas& canvas, bool alpha, std::vector<std::string>* said = nullptr);
    /// Whether startCoded() is possible: no words, one frame, and 8 bits per channel are enough.
    bool startsCoded() const { return !words.any() && !settings.fine && !stereo().on(); }
    /// Starts a picture of drawCoded(), which the renderer's finishCoded() returns.
    void startCoded(Canvas& canvas, bool alpha);
    /// Layers of the scene on the renderer. Depths of all frames of a trajectory have one origin.
    LayerPicture layers(Renderer& renderer) const;
    /// A picture of the scene on the renderer with other settings: another view or clipping.
    /// @param memory  of a sequence of pictures @param said  receives warnings about words; may be null
    Picture drawAs(const RenderSettings& settings, Renderer& renderer, WordMemory* memory = nullptr,
                   std::vector<std::string>* said = nullptr) const;
    /// Of the last picture; its settings are those of a point midway between the eyes.
    const Stereo& stereo() const { return stereo_; }
    /// Draws the words into a picture. @param drawn  its settings @returns warnings about them
    std::vector<std::string> addWords(const RenderSettings& drawn, Picture& picture,
                                      WordMemory* memory = nullptr) const;

    // --- Parts, for windows

    /// Call before build(): the scene keeps this centre and radius, so that hiding and restyling keep the camera.
    void keepFrame(const Bounds& frame) { kept_ = frame; }
    /// Centre and radius of the scene without maps.
    Bounds frame() const { return {scene_->center, radius_}; }
    /// Whether keepFrame() changed the radius.
    bool reframed() const { return reframed_; }
    /// Makes a camera relative to the scene. A given eye distance sets the scene's radius for cameras.
    void takeCamera(Camera& camera);

    /// Settings of a picture of the scene from a camera. There may be no scene yet.
    RenderSettings settingsFor(const PictureDescription& picture, const Camera& camera, const Size& size) const;
    /// Positions of words in the scene. @throws Error
    PlacedWords placeWords(const Words& words, WordsOfHidden hidden) const;
    /// The scene joined with its maps and primitives.
    Representation joinedScene() const;
    /// The scene without maps and primitives. Not after handOver().
    const Representation& scene() const { return *scene_; }
    const ResidueFacts& facts() const { return *facts_; }
    const MapLayers& maps() const { return maps_; }
    /// Radius that the camera frames, Å; 1 without a scene.
    double radius() const { return scene_ ? std::max(radius_, maps_.frame) : 1; }
    /// Radius of everything drawn, Å.
    double reach() const { return scene_ ? std::max(scene_->radius, maps_.shown.radius) : 0; }
    /// Changes when scene() is built again.
    std::uint64_t sceneNumber() const { return sceneNumber_; }
    /// A copy for another thread, which builds it for another description of the same molecule.
    Drawing copy() const;

    /// Colours each scene that is built, before its legend is laid out. Call forget() after a change.
    MovingPicture::Recolor recolor;
    const PictureDescription& description() const { return description_; }
    /// The description with the camera of `settings`, for a saved view: aims are resolved, and the drawn scene no
    /// longer moves the camera.
    PictureDescription placed() const;
    RenderSettings settings;
    PlacedWords words;
    RunStats run;                       ///< as far as known
    Moment moment;                      ///< frame and time in the title
    std::vector<std::string> warnings;  ///< of the scene: differences from the request

    /// Counts of expensive steps.
    struct Counts {
        int scenes = 0;   ///< built
        int uploads = 0;  ///< to a canvas
        int colors = 0;   ///< uploads of colours alone; the others drop the bake
    };
    const Counts& counts() const { return counts_; }

private:
    bool update(const PictureDescription& description, const std::optional<Bounds>& frame, const Molecule* now);
    void rebuildScene(const std::optional<Bounds>& frame, const Molecule* now);
    void setView(const PictureDescription& picture, const Camera& camera);
    std::optional<SceneView> applySceneFile();
    void uncoverTarget(std::optional<double> plane);
    void finish(const PictureDescription& picture);
    void placePictureWords(const PictureDescription& picture);
    void makeRoom(const PictureDescription& picture);
    void spare(const Selection& spared);
    void setStats();

    CameraBy by_;
    PictureDescription description_;     ///< of the scene
    std::optional<ResidueFacts> facts_;  ///< of the molecule
    std::optional<Representation> scene_;
    MapLayers maps_;
    std::optional<Bounds> kept_;  ///< from keepFrame()
    bool reframed_ = false;
    Clip spareClip_;  ///< clipping planes with which spare() cut the scene
    std::shared_ptr<MovingPicture> moving_;
    std::uint64_t sceneNumber_ = 0;  ///< of scene_
    std::uint64_t number_ = 0;       ///< of scene_ with maps_
    bool seenByScene_ = false;       ///< the view is that of a scene file's camera
    Stereo stereo_;                  ///< of the last picture
    Size size_;                      ///< likewise, of both eyes
    bool cutsScene_ = false;         ///< that camera's planes have cut scene_
    double radius_ = 0;              ///< that the camera frames, Å, without maps
    /// Å by which the origin of depths moved back for atoms beyond the reach of the trajectory's first frame.
    double depthShift_ = 0;
    double wordSize_ = 0;  ///< of the last picture, as in Words
    std::optional<std::array<float, 3>> wordColor_;
    Counts counts_;
};

}  // namespace nacre::app
