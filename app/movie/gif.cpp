// GIF by giflib: one palette for the whole movie, and only the changed part of each frame.

#include "app/movie/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "app/movie/movie_file.h"
#include "engine/coded_picture.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr int kColors = 256;
constexpr std::uint8_t kNothing = Palette::kMost;  ///< transparent, or unchanged from the previous frame

extern "C" int writeGif(GifFileType* gif, const GifByteType* bytes, int count) {
    try {
        static_cast<CheckedStream*>(gif->UserData)->write(bytes, static_cast<std::size_t>(count));
        return count;
    } catch (const std::exception&) {
        return 0;
    }
}

class Gif : public MovieFile {
public:
    Gif(const std::string& path, const MovieShape& shape) : stream_(path), shape_(shape) {
        if (shape.framesPerSecond > kFastestGif)
            throw Error("cannot write file", path, "a GIF has at most 50 frames per second: --fps");
        int error = 0;
        gif_ = EGifOpen(&stream_, writeGif, &error);
        if (!gif_) fail(error);
        EGifSetGifVersion(gif_, true);
    }
    ~Gif() override {
        int error = 0;
        if (gif_) EGifCloseFile(gif_, &error);
    }
    Gif(const Gif&) = delete;
    Gif& operator=(const Gif&) = delete;

    bool wantsSamples() const override { return true; }
    void sample(const Picture& picture) override {
        coded_ = coded(picture, false).bytes;
        palette_.count(coded_);
    }

    void add(const Picture& picture) override {
        if (frames_ == 0) begin(picture);
        place(picture);
        const bool whole = frames_ == 0 || shape_.alpha;
        const PixelBox box =
            whole ? PixelBox{0, 0, shape_.size.width, shape_.size.height} : changedBox(before_, now_, shape_.size, 1);
        putControl();
        check(EGifPutImageDesc(gif_, static_cast<int>(box.x), static_cast<int>(box.y), static_cast<int>(box.width),
                               static_cast<int>(box.height), false, nullptr));
        std::vector<std::uint8_t> row(box.width);
        for (std::uint32_t y = box.y; y < box.y + box.height; ++y) {
            const std::size_t at = std::size_t{y} * shape_.size.width + box.x;
            for (std::uint32_t x = 0; x < box.width; ++x)
                row[x] = !whole && now_[at + x] == before_[at + x] ? kNothing : now_[at + x];
            check(EGifPutLine(gif_, row.data(), static_cast<int>(box.width)));
        }
        ++frames_;
        before_.swap(now_);
    }

    void finish() override {
        int error = 0;
        GifFileType* gif = gif_;
        gif_ = nullptr;
        if (EGifCloseFile(gif, &error) == GIF_ERROR) fail(error);
        stream_.commit();
    }

private:
    [[noreturn]] void fail(int error) const {
        const char* why = GifErrorString(error);
        throw Error("cannot write file", stream_.path(), why ? why : "giflib gives no reason");
    }
    void check(int result) const {
        if (result == GIF_ERROR) fail(gif_->Error);
    }

    void begin(const Picture& first) {
        if (shape_.size.width > 65535 || shape_.size.height > 65535)
            throw Error("cannot write file", stream_.path(), "a GIF has at most 65535 pixels per side");
        coded_ = coded(first, false).bytes;
        palette_.count(coded_);
        palette_.settle();
        GifColorType colors[kColors] = {};
        for (std::size_t i = 0; i < palette_.colors().size(); ++i) {
            const Rgb& c = palette_.colors()[i];
            colors[i] = {c[0], c[1], c[2]};
        }
        ColorMapObject* map = GifMakeMapObject(kColors, colors);
        if (!map) throw std::bad_alloc();
        const int result = EGifPutScreenDesc(gif_, static_cast<int>(shape_.size.width),
                                             static_cast<int>(shape_.size.height), 8, 0, map);
        GifFreeMapObject(map);
        check(result);
        // Endless: the extension that Netscape introduced.
        constexpr std::uint8_t kForever[] = {1, 0, 0};
        check(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(gif_, sizeof kForever, kForever));
        check(EGifPutExtensionTrailer(gif_));
    }

    /// Fills now_ with the frame's palette indices.
    void place(const Picture& picture) {
        coded_ = coded(picture, shape_.alpha).bytes;
        const std::size_t channels = shape_.alpha ? 4 : 3;
        now_.resize(std::size_t{picture.width} * picture.height);
        std::size_t i = 0;
        for (std::uint32_t y = 0; y < picture.height; ++y)
            for (std::uint32_t x = 0; x < picture.width; ++x, ++i) {
                const std::uint8_t* pixel = coded_.data() + i * channels;
                now_[i] = shape_.alpha && pixel[3] < 128 ? kNothing : palette_.place(pixel, x, y);
            }
    }

    /// Delays are in 1/100 s: at 30 frames per second, two frames last 3 and one lasts 4.
    void putControl() {
        const auto at = [&](std::uint64_t frame) {
            return std::llround(static_cast<double>(frame) * 100 / shape_.framesPerSecond);
        };
        GraphicsControlBlock control{};
        control.DisposalMode = shape_.alpha ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT;
        control.DelayTime = static_cast<int>(std::min<long long>(at(frames_ + 1) - at(frames_), 65535));
        control.TransparentColor = kNothing;
        GifByteType bytes[4];
        EGifGCBToExtension(&control, bytes);
        check(EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, sizeof bytes, bytes));
    }

    CheckedStream stream_;
    MovieShape shape_;
    GifFileType* gif_ = nullptr;
    Palette palette_;
    std::vector<std::uint8_t> coded_, before_, now_;
    std::uint64_t frames_ = 0;
};

std::uint32_t packColor(int r, int g, int b) { return static_cast<std::uint32_t>(r << 16 | g << 8 | b); }

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

ColorBox makeBox(std::span<Counted> colors) {
    ColorBox box{colors, {}};
    for (const Counted& c : colors) box.sums.add(c);
    return box;
}

/// Splits a box where the sum of both errors is smallest. Its colours stay sorted along the cut.
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
    return {makeBox(box.colors.first(bestAt)), makeBox(box.colors.subspan(bestAt))};
}

Rgb computeMean(const Sums& sums) {
    Rgb mean{};
    for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<std::uint8_t>(sums.first[k] / sums.weight + 0.5);
    return mean;
}

/// Bayer's pattern (1973): thresholds of 8 x 8 pixels, -0.5 to 0.5.
double threshold(std::uint32_t x, std::uint32_t y) {
    std::uint32_t value = 0;
    for (std::uint32_t bit = 0; bit < 3; ++bit) {
        const std::uint32_t across = x >> bit & 1, down = y >> bit & 1;
        value |= ((across ^ down) << 1 | down) << (4 - 2 * bit);
    }
    return (value + 0.5) / 64.0 - 0.5;
}

}  // namespace

std::unique_ptr<MovieFile> makeGif(const std::string& path, const MovieShape& shape) {
    return std::make_unique<Gif>(path, shape);
}

void Palette::count(const std::vector<std::uint8_t>& rgb) {
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) ++counts_[packColor(rgb[i], rgb[i + 1], rgb[i + 2])];
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
    if (!all.empty()) boxes.push_back(makeBox(all));
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
    for (const ColorBox& box : boxes) colors_.push_back(computeMean(box.sums));

    for (int round = 0; round < 3; ++round) {
        std::vector<Sums> sums(colors_.size());
        for (const Counted& c : all) sums[nearest(c.color[0], c.color[1], c.color[2])].add(c);
        for (std::size_t i = 1; i < colors_.size(); ++i)
            if (sums[i].weight > 0) colors_[i] = computeMean(sums[i]);
        known_.clear();
    }
    for (std::size_t i = colors_.size(); i-- > 0;)
        exact_[packColor(colors_[i][0], colors_[i][1], colors_[i][2])] = static_cast<std::uint8_t>(i);
}

std::uint8_t Palette::nearest(int r, int g, int b) {
    const auto [at, added] = known_.try_emplace(packColor(r, g, b), std::uint8_t{0});
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
    const auto exact = exact_.find(packColor(rgb[0], rgb[1], rgb[2]));
    if (exact != exact_.end()) return exact->second;
    constexpr double kSpread = 8;  // code values: typical distance of 255 colours of a shaded molecule
    const int shift = static_cast<int>(threshold(x, y) * kSpread);
    const auto moved = [&](std::uint8_t value) { return std::clamp(value + shift, 0, 255); };
    return nearest(moved(rgb[0]), moved(rgb[1]), moved(rgb[2]));
}

}  // namespace nacre::app
