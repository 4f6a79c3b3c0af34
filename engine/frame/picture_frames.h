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

namespace nacre {

/// The target of pictures with more than 8 bits per channel.
constexpr ScreenTarget kFineTargets[] = {
    {"colour", VK_FORMAT_R32G32B32A32_SFLOAT, passes::Output::color, "impostor colour"}};

class PictureFrames {
public:
    /// All arguments outlive this.
    PictureFrames(const gpu::Device& device, gpu::Executor& executor, SceneFrames& frames)
        : device_(device), executor_(executor), frames_(frames), timer_(device), declared_(device.caps().plan) {}

    /// @throws Error if the picture exceeds the device's limits, or memory runs out
    Picture picture(const RenderSettings& settings, const passes::Atlas& atlas);
    /// As Renderer::renderCoded.
    CodedPicture coded(RenderSettings settings, const passes::Atlas& atlas, bool alpha);
    /// Starts a picture as coded() draws it: pictures of one frame while earlier ones are drawn, others at once.
    void start(RenderSettings settings, const passes::Atlas& atlas, bool alpha);
    /// The picture that was started first, of those that finish() has not returned.
    CodedPicture finish();
    std::size_t started() const { return started_.size(); }
    /// Waits for what is started: what it reads may change then.
    void settle();
    /// Gives up what is started.
    void drop();
    /// As Renderer::renderPart.
    Picture part(const RenderSettings& settings, const passes::Atlas& atlas, const PictureRect& part);
    LayerPicture layers(const RenderSettings& settings, const passes::Atlas& atlas);
    /// Draws one frame without reading it back. With RenderSettings::kEdges: one that draws edges if supported, else
    /// the blocks of a picture; for a picture averaged from several frames, one of those.
    void frame(const RenderSettings& settings, const passes::Atlas& atlas);
    /// As Renderer::atomAt.
    std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach);

    const PictureStats& stats() const { return stats_; }
    /// Counts of the last frame.
    const SceneCounts& counts() const { return counts_; }
    /// Plan of the last frame as text.
    const std::string& planText();

private:
    /// The view that a frame draws, and the pixels of it that the picture keeps.
    struct Wanted {
        View view;
        PictureRect inner;
    };
    /// Results of a frame.
    struct Drawn {
        std::vector<gpu::Buffer> pixels;                  ///< per target, if read back
        std::shared_ptr<const passes::TileFrame> colors;  ///< not null: the picture, in memory that the host reads
        bool edges = false;                               ///< drawn with kEdgeSamples
        double smallestPixels = 0;                        ///< as SceneView has it
    };
    /// Samples in each pixel of a frame.
    enum class Samples : std::uint8_t {
        one,
        edges,     ///< kEdgeSamples where edges run
        block,     ///< kBlockSamples x kBlockSamples pixels are one of the picture
        resolved,  ///< kMultisamples, which the render pass averages
    };
    /// What becomes of a frame's result.
    struct Ending {
        FrameEnd end = FrameEnd::left;
        PictureEnd picture{};
        passes::ResolvePlace place{};
        bool finer = false;  ///< as FrameRequest has it
    };
    static bool wantsEdges(const RenderSettings& settings);
    static bool isFine(const RenderSettings& settings);
    static bool averagesOnHost(const RenderSettings& settings);
    std::span<const ScreenTarget> pictureTargets(const RenderSettings& settings, Samples samples = Samples::one) const;
    Drawn draw(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
               std::span<const ScreenTarget> targets, const Ending& ending, const char* name,
               Samples samples = Samples::one, const TileMask* mask = nullptr,
               const passes::EdgePlaces* places = nullptr);
    Samples singleOrResolved(const RenderSettings& settings) const;
    bool drawsEdges(const RenderSettings& settings) const;  ///< in the frame itself
    void checkSize(const View& view) const;
    Picture picture(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted);
    std::uint64_t resolve(const Drawn& drawn, const RenderSettings& settings, const View& view, ResolvedPart part,
                          Picture& to);
    Picture resolved(const Drawn& drawn, const RenderSettings& settings, const Wanted& wanted, std::uint32_t n);
    static Wanted wantedOf(const RenderSettings& settings);
    static std::pair<const std::byte*, std::uint32_t> rowsOf(const Drawn& drawn, const View& view, std::uint32_t n);
    Drawn inOnePixelEach(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted);
    Drawn inOneFrame(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted,
                     const Ending& ending);
    Picture inSeveral(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted);

    // Pictures that take several frames end in picture_.image.
    void makePicture(const graph::ImageDesc& desc);
    Ending inImage(const RenderSettings& settings, const View& shown, Samples samples);
    Drawn readPicture();
    std::optional<FinerPlaces> coarsePicture(const RenderSettings& settings, const passes::Atlas& atlas,
                                             const View& view);
    bool leaveBlurred(const RenderSettings& settings, const View& view, FinerPlaces& places);
    bool addEdges(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                  const FinerPlaces& places);
    template <typename Drew>
    void drawBlocks(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted,
                    const FinerPlaces* places, const Drew& drew);
    void finerPicture(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted);
    void sharp(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted);
    Drawn throughLens(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted);

    /// A picture that is drawn while the host goes on.
    struct Started {
        std::array<float, 4> background{};
        bool alpha = false;
        Wanted wanted;
        SeenFrame seen;  ///< what its frame uses
        std::unique_ptr<gpu::Submission> submission;
        std::optional<CodedPicture> picture;  ///< instead, if it was drawn at once
    };
    bool overlaps(const RenderSettings& settings) const;
    bool submit(const RenderSettings& settings, const passes::Atlas& atlas, bool alpha);

    const std::shared_ptr<DeclaredFrame>& declare(const SeenFrame& seen);
    void tell(const SeenFrame& seen, const FrameTuning& tuning);

    const gpu::Device& device_;
    gpu::Executor& executor_;
    SceneFrames& frames_;
    PictureStats stats_;
    SceneCounts counts_;
    gpu::Timer timer_;
    DeclaredFrames declared_;
    PictureImage picture_;
    std::shared_ptr<const DeclaredFrame> last_;
    std::deque<Started> started_;
    std::vector<std::unique_ptr<gpu::Submission>> spare_;
    std::string planText_;  // of the last frame; made on demand
};

}  // namespace nacre
