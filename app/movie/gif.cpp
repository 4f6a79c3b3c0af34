// GIF by giflib: one palette for the whole movie, and only the changed part of each frame.

#include <gif_lib.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/movie/checked_stream.h"
#include "app/movie/movie_file.h"
#include "app/movie/palette.h"
#include "engine/coded_picture.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr int kColors = 256;
constexpr std::uint8_t kNothing = Palette::kMost;  ///< transparent, or as in the frame before

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
        // Again and again: the extension that Netscape introduced.
        constexpr std::uint8_t kForever[] = {1, 0, 0};
        check(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(gif_, sizeof kForever, kForever));
        check(EGifPutExtensionTrailer(gif_));
    }

    /// The frame's pixels as numbers of colours, in now_.
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

    /// Times are in 1/100 s: at 30 frames per second two take 3 and one 4.
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

}  // namespace

std::unique_ptr<MovieFile> makeGif(const std::string& path, const MovieShape& shape) {
    return std::make_unique<Gif>(path, shape);
}

}  // namespace nacre::app
