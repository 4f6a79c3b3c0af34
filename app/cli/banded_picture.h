#pragma once
// A picture that is too large to be held, or for the device to draw at once: drawn in parts, while it is written.

#include <functional>
#include <vector>

#include "app/annotation/layout.h"
#include "app/annotation/painter.h"
#include "engine/renderer.h"

namespace nacre::app {

/// How much of a picture is in memory at a time.
struct BandLimits {
    std::uint64_t bandPixels = std::uint64_t{1} << 23;  ///< 16 bytes each
    std::uint32_t partSamples = 4096;                   ///< a side of what the device draws at once
};

/// Whether a picture is drawn so.
bool isBanded(const Renderer& renderer, const RenderSettings& settings);

class BandedPicture {
public:
    /// All of them outlive this. @param onProgress  called with the share that is done
    BandedPicture(Renderer& renderer, const RenderSettings& settings, std::function<void(double)> onProgress,
                  const BandLimits& limits = {})
        : renderer_(renderer), settings_(settings), onProgress_(std::move(onProgress)), limits_(limits) {}

    /// What stands over the molecule. @param marks  of the whole picture
    void setMarks(const WordPainter& painter, Marks marks);

    /// Rows of the picture, as Picture has them, from `first` on; good until the next call. They are asked for from the
    /// top on, kRowsAtOnce at a time. @throws Error
    const float* rows(std::uint32_t first);

    std::uint64_t parts() const { return parts_; }
    /// Of the whole as far as it is drawn; passes are not told apart.
    FrameStats stats() const;

private:
    void draw(std::uint32_t top);
    std::uint32_t partSide() const;
    void drawPart(const PictureRect& rect);

    Renderer& renderer_;
    const RenderSettings& settings_;
    std::function<void(double)> onProgress_;
    BandLimits limits_;
    const WordPainter* painter_ = nullptr;
    Marks marks_;
    std::uint32_t top_ = 0, count_ = 0;  // rows that are held
    std::vector<float> band_;
    std::uint64_t parts_ = 0, covered_ = 0;
    double milliseconds_ = 0;
};

}  // namespace nacre::app
