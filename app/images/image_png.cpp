#include "app/images/image_png.h"

#include <libdeflate.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "app/images/checked_file.h"

namespace nacre::app {
namespace {

/// libpng's message, for the code after its longjmp.
struct PngState {
    CheckedFile file;
    std::array<char, 200> why{};
};

extern "C" {
void writePngBytes(png_structp png, png_bytep bytes, std::size_t size) {
    auto* state = static_cast<PngState*>(png_get_io_ptr(png));
    if (!state->file.write(bytes, size)) png_error(png, "the file cannot be written");
}
void flushPngBytes(png_structp) {}
void failPng(png_structp png, png_const_charp why) {
    auto* state = static_cast<PngState*>(png_get_error_ptr(png));
    std::strncpy(state->why.data(), why, state->why.size() - 1);
    png_longjmp(png, 1);
}
void warnPng(png_structp, png_const_charp) {}
}

// On failure libpng leaves by longjmp, so these functions have no objects with destructors.

bool beginPng(png_structp png, png_infop info, const ImageRequest& request) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_IHDR(png, info, request.width, request.height, request.samples == Samples::words ? 16 : 8,
                 request.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // Suits streamed rows. For pictures of molecules it takes a third of the time of the default, which tries every
    // filter on each row; files are 5 % larger (docs/notes.md).
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_level(png, 4);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (request.dotsPerInch > 0) {
        const auto perMetre = static_cast<png_uint_32>(std::lround(request.dotsPerInch / 0.0254));
        png_set_pHYs(png, info, perMetre, perMetre, PNG_RESOLUTION_METER);
    }
    char key[] = "Software", text[] = "nacre";
    png_text software{};
    software.compression = PNG_TEXT_COMPRESSION_NONE;
    software.key = key;
    software.text = text;
    png_set_text(png, info, &software, 1);
    png_write_info(png, info);
    if (request.samples == Samples::words && std::endian::native == std::endian::little) png_set_swap(png);
    return true;
}

bool addPngRows(png_structp png, const unsigned char* rows, std::size_t rowBytes, std::uint32_t count) {
    if (setjmp(png_jmpbuf(png))) return false;
    for (std::uint32_t y = 0; y < count; ++y) png_write_row(png, rows + y * rowBytes);
    return true;
}

bool addPngChunk(png_structp png, const char* name, const unsigned char* bytes, std::size_t size) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), bytes, size);
    return true;
}

bool endPng(png_structp png, png_infop info) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_write_end(png, info);
    return true;
}

/// libpng's own memory.
class PngWriter {
public:
    explicit PngWriter(PngState& state)
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &state, failPng, warnPng)),
          info(png ? png_create_info_struct(png) : nullptr) {
        if (info) png_set_write_fn(png, &state, writePngBytes, flushPngBytes);
    }
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    png_structp png;
    png_infop info;
};

constexpr std::size_t kWholeBytes = std::size_t{64} << 20;  ///< largest picture that is compressed in one piece

std::size_t countRowBytes(const ImageRequest& request) {
    return std::size_t{request.width} * request.channels * (request.samples == Samples::words ? 2 : 1);
}

struct Bytes {
    explicit Bytes(std::size_t most) : data(std::make_unique_for_overwrite<unsigned char[]>(most)), size(most) {}
    std::unique_ptr<unsigned char[]> data;  // uninitialised, so that unused pages cost no memory
    std::size_t size;
};

/// The rows with PNG's filter "up": the difference from the row above.
Bytes filteredRows(const ImageRequest& request) {
    const std::size_t rowBytes = countRowBytes(request);
    Bytes filtered((rowBytes + 1) * request.height);
    std::vector<unsigned char> above(rowBytes);
    unsigned char* to = filtered.data.get();
    for (std::uint32_t first = 0; first < request.height; first += kRowsAtOnce) {
        const std::uint32_t count = std::min(kRowsAtOnce, request.height - first);
        const auto* row = static_cast<const unsigned char*>(request.rows(request.context, first, count));
        const unsigned char* before = above.data();
        for (std::uint32_t y = 0; y < count; ++y, before = row, row += rowBytes, to += rowBytes) {
            *to++ = PNG_FILTER_VALUE_UP;
            for (std::size_t i = 0; i < rowBytes; ++i) to[i] = static_cast<unsigned char>(row[i] - before[i]);
        }
        std::memcpy(above.data(), before, rowBytes);
    }
    return filtered;
}

/// zlib's format by libdeflate: half the time of zlib's level 4, and a file one percent smaller (docs/notes.md).
Bytes compressed(const Bytes& bytes) {
    struct Free {
        void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
    };
    constexpr int kLevel = 2;
    const std::unique_ptr<libdeflate_compressor, Free> compressor(libdeflate_alloc_compressor(kLevel));
    if (!compressor) throw std::bad_alloc();
    Bytes result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size));
    result.size =
        libdeflate_zlib_compress(compressor.get(), bytes.data.get(), bytes.size, result.data.get(), result.size);
    return result;
}

}  // namespace

void writePng(const ImageRequest& request) {
    PngState state{CheckedFile(request.file)};
    const auto check = [&](bool good) {
        if (state.file.failure() != 0) throw std::runtime_error(std::strerror(state.file.failure()));
        if (!good) throw std::runtime_error(state.why.data());
    };
    const PngWriter writer(state);
    if (!writer.info) throw std::runtime_error("libpng has no memory");
    check(beginPng(writer.png, writer.info, request));
    const std::size_t rowBytes = countRowBytes(request);
    bool good = false;
    if (request.samples == Samples::bytes && rowBytes * request.height <= kWholeBytes) {
        const Bytes data = compressed(filteredRows(request));
        check(addPngChunk(writer.png, "IDAT", data.data.get(), data.size));
        good = addPngChunk(writer.png, "IEND", nullptr, 0);
    } else {
        for (std::uint32_t row = 0; row < request.height; row += kRowsAtOnce) {
            const std::uint32_t count = std::min(kRowsAtOnce, request.height - row);
            const auto* rows = static_cast<const unsigned char*>(request.rows(request.context, row, count));
            check(addPngRows(writer.png, rows, rowBytes, count));
        }
        good = endPng(writer.png, writer.info);
    }
    state.file.finish();
    check(good);
}

}  // namespace nacre::app
