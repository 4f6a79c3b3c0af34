#include "app/cli/banded_picture.h"

#include <algorithm>

#include "app/images/image_codec.h"

namespace nacre::app {
namespace {

constexpr std::uint64_t kWholeSamples = std::uint64_t{1} << 24;  ///< of a picture that is held in memory

std::uint32_t samplesAcross(const RenderSettings& settings) { return std::max(settings.supersample, 1u); }

/// The largest multiple of the step of bands and parts that is at most `most`.
std::uint32_t steps(std::uint64_t most) {
    constexpr std::uint32_t kStep = kRowsAtOnce;
    static_assert(kStep % PictureRect::kStep == 0);
    return static_cast<std::uint32_t>(std::max<std::uint64_t>(most / kStep, 1)) * kStep;
}

}  // namespace

bool isBanded(const Renderer& renderer, const RenderSettings& settings) {
    const View& view = settings.view;
    const std::uint64_t n = samplesAcross(settings);
    return settings.debug == DebugView::none && (std::max(view.width, view.height) * n > renderer.maxSize() ||
                                                 std::uint64_t{view.width} * view.height * n * n > kWholeSamples);
}

/// Side of a part in pixels, without the rim that is drawn around it.
std::uint32_t BandedPicture::partSide() const {
    const std::uint32_t most = std::min(limits_.partSamples, renderer_.maxSize()) / samplesAcross(settings_);
    return steps(most - std::min(most, 2 * PictureRect::kStep));
}

void BandedPicture::setMarks(const WordPainter& painter, Marks marks) {
    painter_ = &painter;
    marks_ = std::move(marks);
}

void BandedPicture::drawPart(const PictureRect& rect) {
    const std::uint32_t width = settings_.view.width;
    const Picture part = renderer_.renderPart(settings_, rect);
    for (std::uint32_t row = 0; row < rect.height; ++row)
        std::copy_n(part.rgba.data() + std::size_t{4} * row * rect.width, std::size_t{4} * rect.width,
                    band_.data() + std::size_t{4} * (std::size_t{row} * width + rect.x));
    ++parts_;
    const FrameStats stats = renderer_.stats();
    covered_ += stats.coveredPixels;
    milliseconds_ += stats.frameMilliseconds;
}

void BandedPicture::draw(std::uint32_t top) {
    const View& view = settings_.view;
    const std::uint32_t side = partSide();
    top_ = top;
    count_ = std::min({side, steps(limits_.bandPixels / view.width), view.height - top});
    band_.resize(std::size_t{4} * view.width * count_);
    for (std::uint32_t left = 0; left < view.width; left += side)
        drawPart({left, top, std::min(side, view.width - left), count_});
    if (painter_) painter_->paint(marks_, band_.data(), view.width, top_, count_);
    onProgress_(static_cast<double>(top + count_) / view.height);
}

const float* BandedPicture::rows(std::uint32_t first) {
    if (first < top_ || first >= top_ + count_) draw(first);
    return band_.data() + std::size_t{4} * settings_.view.width * (first - top_);
}

FrameStats BandedPicture::stats() const {
    FrameStats stats = renderer_.stats();
    stats.coveredPixels = covered_;
    stats.frameMilliseconds = milliseconds_;
    stats.passes.clear();
    stats.passTimes.clear();
    return stats;
}

}  // namespace nacre::app
