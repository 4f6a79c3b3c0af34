#include "app/movie/palette.h"

#include <algorithm>
#include <limits>
#include <span>

namespace nacre::app {
namespace {

std::uint32_t keyOf(int r, int g, int b) { return static_cast<std::uint32_t>(r << 16 | g << 8 | b); }

struct Counted {
    Rgb color;
    double weight;
};

/// Sums over colours: enough for their mean and squared error.
struct Sums {
    double weight = 0, squares = 0;
    std::array<double, 3> first{};
    void add(const Counted& c) {
        weight += c.weight;
        for (std::size_t k = 0; k < 3; ++k) {
            first[k] += c.weight * c.color[k];
            squares += c.weight * c.color[k] * c.color[k];
        }
    }
    void remove(const Sums& s) {
        weight -= s.weight;
        squares -= s.squares;
        for (std::size_t k = 0; k < 3; ++k) first[k] -= s.first[k];
    }
    double error() const {
        if (weight <= 0) return 0;
        return squares - (first[0] * first[0] + first[1] * first[1] + first[2] * first[2]) / weight;
    }
};

struct ColorBox {
    std::span<Counted> colors;
    Sums sums;
};

ColorBox boxOf(std::span<Counted> colors) {
    ColorBox box{colors, {}};
    for (const Counted& c : colors) box.sums.add(c);
    return box;
}

/// Splits a box where the sum of both errors is least. Its colours stay sorted along the cut.
std::array<ColorBox, 2> cut(const ColorBox& box) {
    std::size_t bestAxis = 0, bestAt = 1;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto before = [axis](const Counted& a, const Counted& b) {
            return a.color[axis] != b.color[axis] ? a.color[axis] < b.color[axis] : a.color < b.color;
        };
        std::sort(box.colors.begin(), box.colors.end(), before);
        Sums left;
        for (std::size_t i = 0; i + 1 < box.colors.size(); ++i) {
            left.add(box.colors[i]);
            Sums right = box.sums;
            right.remove(left);
            const double error = left.error() + right.error();
            if (error < best) {
                best = error;
                bestAxis = axis;
                bestAt = i + 1;
            }
        }
    }
    std::sort(box.colors.begin(), box.colors.end(), [axis = bestAxis](const Counted& a, const Counted& b) {
        return a.color[axis] != b.color[axis] ? a.color[axis] < b.color[axis] : a.color < b.color;
    });
    return {boxOf(box.colors.first(bestAt)), boxOf(box.colors.subspan(bestAt))};
}

Rgb meanOf(const Sums& sums) {
    Rgb mean{};
    for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<std::uint8_t>(sums.first[k] / sums.weight + 0.5);
    return mean;
}

/// The pattern that Bayer (1973) found: thresholds of 8 x 8 pixels, -0.5 to 0.5.
double threshold(std::uint32_t x, std::uint32_t y) {
    std::uint32_t value = 0;
    for (std::uint32_t bit = 0; bit < 3; ++bit) {
        const std::uint32_t across = x >> bit & 1, down = y >> bit & 1;
        value |= ((across ^ down) << 1 | down) << (4 - 2 * bit);
    }
    return (value + 0.5) / 64.0 - 0.5;
}

}  // namespace

void Palette::count(const std::vector<std::uint8_t>& rgb) {
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) ++counts_[keyOf(rgb[i], rgb[i + 1], rgb[i + 2])];
}

void Palette::settle() {
    std::vector<Counted> all;
    all.reserve(counts_.size());
    for (const auto& [key, n] : counts_)
        all.push_back({{static_cast<std::uint8_t>(key >> 16), static_cast<std::uint8_t>(key >> 8 & 0xff),
                        static_cast<std::uint8_t>(key & 0xff)},
                       static_cast<double>(n)});
    counts_.clear();
    std::sort(all.begin(), all.end(), [](const Counted& a, const Counted& b) { return a.color < b.color; });
    const auto common = std::max_element(all.begin(), all.end(),
                                         [](const Counted& a, const Counted& b) { return a.weight < b.weight; });
    if (common == all.end()) return;
    const Rgb background = common->color;
    all.erase(common);

    std::vector<ColorBox> boxes;
    if (!all.empty()) boxes.push_back(boxOf(all));
    while (!boxes.empty() && boxes.size() + 1 < kMost) {
        const auto worst = std::max_element(boxes.begin(), boxes.end(), [](const ColorBox& a, const ColorBox& b) {
            return (a.colors.size() > 1 ? a.sums.error() : 0) < (b.colors.size() > 1 ? b.sums.error() : 0);
        });
        if (worst->colors.size() < 2) break;
        const auto [low, high] = cut(*worst);
        *worst = low;
        boxes.push_back(high);
    }
    colors_ = {background};
    for (const ColorBox& box : boxes) colors_.push_back(meanOf(box.sums));

    for (int round = 0; round < 3; ++round) {
        std::vector<Sums> sums(colors_.size());
        for (const Counted& c : all) sums[nearest(c.color[0], c.color[1], c.color[2])].add(c);
        for (std::size_t i = 1; i < colors_.size(); ++i)
            if (sums[i].weight > 0) colors_[i] = meanOf(sums[i]);
        known_.clear();
    }
    for (std::size_t i = colors_.size(); i-- > 0;)
        exact_[keyOf(colors_[i][0], colors_[i][1], colors_[i][2])] = static_cast<std::uint8_t>(i);
}

std::uint8_t Palette::nearest(int r, int g, int b) {
    const auto [at, added] = known_.try_emplace(keyOf(r, g, b), std::uint8_t{0});
    if (!added) return at->second;
    int best = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < colors_.size(); ++i) {
        const int dr = r - colors_[i][0], dg = g - colors_[i][1], db = b - colors_[i][2];
        const int distance = dr * dr + dg * dg + db * db;
        if (distance >= best) continue;
        best = distance;
        at->second = static_cast<std::uint8_t>(i);
    }
    return at->second;
}

std::uint8_t Palette::place(const std::uint8_t* rgb, std::uint32_t x, std::uint32_t y) {
    const auto exact = exact_.find(keyOf(rgb[0], rgb[1], rgb[2]));
    if (exact != exact_.end()) return exact->second;
    constexpr double kSpread = 8;  // code values: typical distance of 255 colours of a shaded molecule
    const int shift = static_cast<int>(threshold(x, y) * kSpread);
    const auto moved = [&](std::uint8_t value) { return std::clamp(value + shift, 0, 255); };
    return nearest(moved(rgb[0]), moved(rgb[1]), moved(rgb[2]));
}

}  // namespace nacre::app
