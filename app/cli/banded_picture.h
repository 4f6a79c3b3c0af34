#pragma once
// A picture too large for memory, or for the device to draw at once: drawn in parts while it is written.

#include <functional>
#include <vector>

#include "app/annotation/layout.h"
#include "app/annotation/painter.h"
#include "engine/renderer.h"

namespace nacre::app {

/// Memory limits of such a picture.
struct BandLimits {
    std::uint64_t bandPixels = std::uint64_t{1} << 23;  ///< 16 bytes each
    std::uint32_t partSamples = 4096;                   ///< side of the largest part that the device draws at once
};

/// Whether a picture is drawn in parts.
bool isBanded(const Renderer& renderer, const RenderSettings& settings);

class BandedPicture {
public:
    /// All arguments outlive this. @param onProgress  called with the finished share
    BandedPicture(Renderer& renderer, const RenderSettings& settings, std::function<void(double)> onProgress,
                  const BandLimits& limits = {})
        : renderer_(renderer), settings_(settings), onProgress_(std::move(onProgress)), limits_(limits) {}

    /// Sets the overlay. @param marks  of the whole picture
    void setMarks(const WordPainter& painter, Marks marks);

    /// Rows of the picture (layout as in Picture), from `first` on; valid until the next call. Call it from the top
    /// down, kRowsAtOnce at a time. @throws Error
    const float* rows(std::uint32_t first);

    std::uint64_t parts() const { return parts_; }
    /// Statistics of the picture so far; passes are not separated.
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
    std::uint32_t top_ = 0, count_ = 0;  // rows in memory
    std::vector<float> band_;
    std::uint64_t parts_ = 0, covered_ = 0;
    double milliseconds_ = 0;
};

}  // namespace nacre::app
