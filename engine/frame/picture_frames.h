#pragma once
// Frames that the host waits for: pictures, layers, and picking.

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/frame/declared_frames.h"
#include "engine/frame/finer_places.h"
#include "engine/frame/picture.h"
#include "engine/frame/resolve.h"
#include "engine/frame/scene_frames.h"
#include "engine/gpu/submission.h"
#include "engine/passes/read_back.h"

namespace nacre {

class PictureFrames {
public:
    /// All arguments outlive this.
    PictureFrames(const gpu::Device& device, gpu::Executor& executor, SceneFrames& frames)
        : device_(device),
          executor_(executor),
          frames_(frames),
          timer_(device),
          sets_(device),
          declared_(device.caps().plan) {}

    /// @throws Error if the picture exceeds the device's limits, or memory runs out
    Picture picture(const RenderSettings& settings, const passes::Atlas& atlas);
    /// As Renderer::renderCoded.
    CodedPicture coded(RenderSettings settings, const passes::Atlas& atlas, bool alpha);
    /// As Renderer::renderPart.
    Picture part(const RenderSettings& settings, const passes::Atlas& atlas, const PictureRect& part);
    LayerPicture layers(const RenderSettings& settings, const passes::Atlas& atlas);
    /// As Renderer::renderEyes and layersOfEyes.
    std::array<Picture, 2> eyes(const RenderSettings& settings, const passes::Atlas& atlas);
    std::array<LayerPicture, 2> layersOfEyes(const RenderSettings& settings, const passes::Atlas& atlas);
    /// Draws a picture's frames without reading the last one back.
    void frame(const RenderSettings& settings, const passes::Atlas& atlas);
    /// As Renderer::atomAt.
    std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach);
    /// As Renderer::atoms.
    std::vector<std::uint32_t> atoms(const RenderSettings& settings);

    /// Starts a picture as coded() draws it. Pictures of one frame are drawn while earlier ones are, others at once.
    void start(RenderSettings settings, const passes::Atlas& atlas, bool alpha);
    /// The first picture that was started and not yet returned.
    CodedPicture finish();
    std::size_t started() const { return started_.size(); }
    /// Waits for started pictures. Call before what they read changes.
    void settle();
    /// Cancels started pictures.
    void drop();

    const PictureStats& stats() const { return stats_; }
    /// Counts of the last frame.
    const SceneCounts& counts() const { return counts_; }
    /// Plan of the last frame as text.
    const std::string& planText();
    /// How the last picture's first frame was drawn, and why.
    std::vector<Decision> decisions() const;

private:
    /// The view of a picture, and its wanted pixels.
    struct Wanted {
        View view;
        PictureRect inner;
    };
    /// Results of a frame.
    struct Drawn {
        std::vector<gpu::Buffer> pixels;                  ///< per target, if read back
        std::shared_ptr<const passes::TileFrame> colors;  ///< if not null, the picture, in memory that the host reads
    };
    static Wanted wholePicture(const RenderSettings& settings);
    static std::uint32_t samplesPerSide(const RenderSettings& settings);
    void checkSize(const View& view) const;
    /// Whether one frame draws both eyes of the view.
    bool drawsBoth(const FrameRequest& request) const;
    Drawn drawBoth(const FrameRequest& request, const passes::Atlas& atlas);

    Drawn identify(RenderSettings settings, const char* name);
    PreparedFrame prepare(const FrameRequest& request, FrameInputs inputs);
    Drawn run(PreparedFrame prepared, const RenderSettings& settings);
    const std::shared_ptr<DeclaredFrame>& declare(const PreparedFrame& prepared);
    void note(const PreparedFrame& prepared);

    Picture picture(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted);
    Drawn draw(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted, Ending ending);
    static std::pair<const std::byte*, std::uint32_t> pictureRows(const Drawn& drawn, const View& view,
                                                                  std::uint32_t n);

    // Pictures of several frames end in picture_.image.
    void endInPicture(PreparedFrame& prepared, const View& picture, std::uint32_t n);
    /// A copy of the picture's image for the host: of its own, or with the last frame.
    struct Reading {
        Drawn drawn;
        graph::Graph graph{"picture"};
        gpu::Imports imports;
    };
    Reading declareReading() const;
    Drawn readPicture();
    void refine(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted, PreparedFrame first,
                Ending ending);
    FinerPlaces drawCoarse(const RenderSettings& settings, const Wanted& wanted, PreparedFrame coarse);
    bool drawEdges(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                   const FinerPlaces& places, Ending ending);
    template <typename Drew>
    void drawBlocks(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted,
                    const FinerPlaces* places, std::uint32_t n, const Drew& drew);
    bool leaveBlurred(const RenderSettings& settings, const View& view, FinerPlaces& places);
    Drawn blur(const RenderSettings& settings, const Wanted& wanted);

    /// A picture that is drawn while the host continues.
    struct Started {
        std::array<float, 4> background{};
        bool alpha = false;
        Wanted wanted;
        PreparedFrame prepared;  ///< resources of its frame
        std::unique_ptr<gpu::Submission> submission;
        std::optional<CodedPicture> picture;  ///< set instead, if it was drawn at once
    };
    bool submit(const RenderSettings& settings, const passes::Atlas& atlas, bool alpha);

    /// Request and choice of the last picture, to explain it.
    struct Asked {
        RenderSettings settings;
        Part part{};
        Ending ending{};
        int quarterTurns = 0;
        bool counted = false, eyes = false;
        SceneFacts facts;
        FrameChoice drawn;  ///< the choice, after changes for long lists
    };

    const gpu::Device& device_;
    gpu::Executor& executor_;
    SceneFrames& frames_;
    PictureStats stats_;
    SceneCounts counts_;
    gpu::Timer timer_;
    gpu::DescriptorPool sets_;  // of copies, which take none
    DeclaredFrames declared_;
    PictureImage picture_;
    std::optional<passes::TextureUpload> upload_;  // recorded before the next frame
    std::optional<Reading> reading_;               // recorded after the next frame, then
    std::optional<Drawn> read_;
    std::shared_ptr<const DeclaredFrame> last_;
    std::optional<Asked> asked_;
    std::deque<Started> started_;
    std::vector<std::unique_ptr<gpu::Submission>> spare_;
    std::string planText_;  // of the last frame; made on demand
};

}  // namespace nacre
