// Animated PNG (APNG 1.0, the third edition of the PNG specification): libpng compresses each frame, and its data goes
// into animation chunks. Debian's libpng does not write these chunks, and skips them when reading.

#include <png.h>
#include <zlib.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <new>
#include <numeric>

#include "app/movie/movie_file.h"
#include "engine/coded_picture.h"

namespace nacre::app {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append32(Bytes& bytes, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}
void append16(Bytes& bytes, std::uint32_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value));
}

Bytes chunk(const char (&name)[5], const Bytes& data) {
    Bytes bytes;
    bytes.reserve(data.size() + 12);
    append32(bytes, static_cast<std::uint32_t>(data.size()));
    bytes.insert(bytes.end(), name, name + 4);
    bytes.insert(bytes.end(), data.begin(), data.end());
    append32(bytes, static_cast<std::uint32_t>(crc32(0, bytes.data() + 4, static_cast<uInt>(data.size() + 4))));
    return bytes;
}

/// A frame's duration as a fraction of seconds with 16 bits each: 1/30, 100/2997.
std::array<std::uint32_t, 2> toDelay(double framesPerSecond) {
    const auto hundredths = static_cast<std::uint32_t>(std::lround(framesPerSecond * 100));
    const std::uint32_t common = std::gcd(100u, hundredths);
    return {100 / common, hundredths / common};
}

extern "C" void appendPng(png_structp png, png_bytep data, std::size_t count) {
    try {
        auto* bytes = static_cast<Bytes*>(png_get_io_ptr(png));
        bytes->insert(bytes->end(), data, data + count);
    } catch (const std::bad_alloc&) {
        png_error(png, "out of memory");
    }
}
extern "C" void flushPng(png_structp) {}

/// Rows of pixels, and the distance between them in bytes.
struct Rows {
    const std::uint8_t* pixels;
    std::size_t apart;
    std::uint32_t width, height;
    bool alpha;
};

/// libpng fails by longjmp: no object of this function may have a destructor.
bool writeRows(png_structp png, png_infop info, const Rows& rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_IHDR(png, info, rows.width, rows.height, 8, rows.alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_filter(png, 0, PNG_FILTER_SUB | PNG_FILTER_UP | PNG_FILTER_PAETH);
    png_set_compression_buffer_size(png, 1 << 20);
    png_write_info(png, info);
    for (std::uint32_t y = 0; y < rows.height; ++y) png_write_row(png, rows.pixels + y * rows.apart);
    png_write_end(png, info);
    return true;
}

/// Compresses rows to a PNG.
Bytes packed(const Rows& rows) {
    Bytes bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (info) png_set_write_fn(png, &bytes, appendPng, flushPng);
    const bool whole = info && writeRows(png, info, rows);
    png_destroy_write_struct(&png, &info);
    if (!whole) throw std::bad_alloc();  // its only cause of failure
    return bytes;
}

/// The contents of a PNG's IDAT chunks, joined.
Bytes joinData(const Bytes& png) {
    Bytes data;
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t size = png[at] << 24 | png[at + 1] << 16 | png[at + 2] << 8 | png[at + 3];
        const auto begin = png.begin() + static_cast<std::ptrdiff_t>(at + 4);
        if (std::string(begin, begin + 4) == "IDAT")
            data.insert(data.end(), begin + 4, begin + 4 + static_cast<std::ptrdiff_t>(size));
        at += size + 12;
    }
    return data;
}

class AnimatedPng : public MovieFile {
public:
    AnimatedPng(const std::string& path, const MovieShape& shape) : stream_(path, ".png"), shape_(shape) {
        static constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
        stream_.write(kSignature, sizeof kSignature);
        Bytes header;
        append32(header, shape.size.width);
        append32(header, shape.size.height);
        header.insert(header.end(), {8, static_cast<std::uint8_t>(shape.alpha ? 6 : 2), 0, 0, 0});
        put(chunk("IHDR", header));
        put(chunk("acTL", control(0)));
        put(chunk("sRGB", {0}));
    }

    void add(const Picture& picture) override {
        now_ = coded(picture, shape_.alpha).bytes;
        const std::size_t channels = shape_.alpha ? 4 : 3;
        const PixelBox box = frames_ == 0 ? PixelBox{0, 0, shape_.size.width, shape_.size.height}
                                          : changedBox(before_, now_, shape_.size, channels);
        put(chunk("fcTL", frameControl(box)));
        const std::size_t row = shape_.size.width * channels;
        Bytes data =
            joinData(packed({now_.data() + box.y * row + box.x * channels, row, box.width, box.height, shape_.alpha}));
        if (frames_ == 0) {
            put(chunk("IDAT", data));
        } else {
            Bytes number;
            append32(number, sequence_++);
            data.insert(data.begin(), number.begin(), number.end());
            put(chunk("fdAT", data));
        }
        ++frames_;
        before_.swap(now_);
    }

    void finish() override {
        put(chunk("IEND", {}));
        constexpr std::uint64_t kControl = 8 + 25;  // after the signature and IHDR
        const Bytes known = chunk("acTL", control(frames_));
        stream_.writeAt(kControl, known.data(), known.size());
        stream_.commit();
    }

private:
    void put(const Bytes& bytes) { stream_.write(bytes.data(), bytes.size()); }

    static Bytes control(std::uint32_t frames) {
        Bytes data;
        append32(data, frames);
        append32(data, 0);  // plays; 0: endless
        return data;
    }

    /// The frame stays, and the next one is drawn over it.
    Bytes frameControl(const PixelBox& box) {
        Bytes data;
        for (const std::uint32_t value : {sequence_++, box.width, box.height, box.x, box.y}) append32(data, value);
        for (const std::uint32_t value : toDelay(shape_.framesPerSecond)) append16(data, value);
        data.insert(data.end(), {0, 0});
        return data;
    }

    CheckedStream stream_;
    MovieShape shape_;
    Bytes before_, now_;
    std::uint32_t frames_ = 0, sequence_ = 0;
};

}  // namespace

std::unique_ptr<MovieFile> makeAnimatedPng(const std::string& path, const MovieShape& shape) {
    return std::make_unique<AnimatedPng>(path, shape);
}

}  // namespace nacre::app
