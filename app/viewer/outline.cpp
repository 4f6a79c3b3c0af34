#include "app/viewer/outline.h"

#include <algorithm>
#include <cmath>

#include "engine/srgb.h"

namespace nacre::app {
namespace {

/// Opacity of a kind of mark: inside, and of the outline.
struct Strength {
    double inside, outline;
};
constexpr Strength kSelected{0.14, 1}, kHovered{0.08, 0.6};

/// A pixel near another one, with the outline's coverage there.
struct Beside {
    int right, down;
    std::uint8_t alpha;
};

std::uint8_t toAlpha(double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); }

/// Pixels within reach of an outline; its rim is anti-aliased.
std::vector<Beside> findReached(double width, double strength) {
    const int most = static_cast<int>(std::ceil(width + 0.5));
    std::vector<Beside> reach;
    for (int down = -most; down <= most; ++down)
        for (int right = -most; right <= most; ++right)
            if (const double covered = std::clamp(width + 1 - std::hypot(right, down), 0.0, 1.0); covered > 0)
                reach.push_back({right, down, toAlpha(covered * strength)});
    return reach;
}

/// Marks the pixels where `in` is true. @param alphas  by pixel: the strongest mark stays
void mark(const std::vector<bool>& in, PixelSize size, double width, Strength strength,
          std::vector<std::uint8_t>& alphas) {
    const std::vector<Beside> reach = findReached(width, strength.outline);
    const std::uint8_t inside = toAlpha(strength.inside);
    const int columns = static_cast<int>(size.width), rows = static_cast<int>(size.height);
    const auto pixelIndex = [&](int x, int y) {
        return static_cast<std::size_t>(y) * size.width + static_cast<std::size_t>(x);
    };
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const std::size_t here = pixelIndex(x, y);
            if (!in[here]) continue;
            alphas[here] = std::max(alphas[here], inside);
            const bool border = (x > 0 && !in[here - 1]) || (x + 1 < columns && !in[here + 1]) ||
                                (y > 0 && !in[here - size.width]) || (y + 1 < rows && !in[here + size.width]);
            if (!border) continue;
            for (const Beside& beside : reach) {
                const int right = x + beside.right, down = y + beside.down;
                if (right < 0 || right >= columns || down < 0 || down >= rows) continue;
                const std::size_t there = pixelIndex(right, down);
                if (!in[there]) alphas[there] = std::max(alphas[there], beside.alpha);
            }
        }
}

}  // namespace

std::vector<MarkSpan> makeOutline(std::span<const std::uint32_t> atoms, PixelSize size, const Highlights& marks,
                                  double width) {
    std::vector<MarkSpan> spans;
    const std::size_t count = std::size_t{size.width} * size.height;
    if (!marks.any() || atoms.size() != count) return spans;
    std::vector<bool> selected(count), hovered(count);
    bool anySelected = false, anyHovered = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (atoms[i] == 0) continue;
        const std::uint32_t atom = atoms[i] - 1;
        if (atom < marks.selected.size() && marks.selected[atom]) selected[i] = anySelected = true;
        if (atom - marks.firstHovered < marks.hovered) hovered[i] = anyHovered = true;
    }
    std::vector<std::uint8_t> alphas(count);
    if (anySelected) mark(selected, size, width, kSelected, alphas);
    if (anyHovered) mark(hovered, size, width, kHovered, alphas);
    if (!anySelected && !anyHovered) return spans;
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width;) {
            const std::uint8_t* row = &alphas[std::size_t{y} * size.width];
            const std::uint32_t from = x;
            while (x < size.width && row[x] == row[from]) ++x;
            if (row[from] > 0) spans.push_back({from, y, x - from, row[from]});
        }
    return spans;
}

void paintMarks(const std::vector<MarkSpan>& spans, Picture& picture) {
    float color[3];
    for (int channel = 0; channel < 3; ++channel)
        color[channel] = srgbToLinear(static_cast<float>(kMarkColor >> 8 * channel & 255) / 255);
    for (const MarkSpan& span : spans) {
        const float alpha = static_cast<float>(span.alpha) / 255;
        float* pixel = &picture.rgba[4 * (std::size_t{span.y} * picture.width + span.x)];
        for (std::uint32_t i = 0; i < span.width; ++i, pixel += 4) {
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] = alpha * color[channel] + (1 - alpha) * pixel[channel];
            pixel[3] = alpha + (1 - alpha) * pixel[3];
        }
    }
}

}  // namespace nacre::app
