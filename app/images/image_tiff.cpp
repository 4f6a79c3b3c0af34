#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/images/image_writers.h"
#include "app/images/srgb_profile.h"

namespace nacre::app {
namespace {

CheckedFile& fileOf(thandle_t handle) { return *static_cast<CheckedFile*>(handle); }

toff_t seekTo(thandle_t handle, toff_t offset, int from) {
    CheckedFile& file = fileOf(handle);
    file.seek(from == SEEK_CUR ? file.place() + offset : from == SEEK_END ? file.size() + offset : offset);
    return file.place();
}

int keepReason(TIFF*, void* reason, const char*, const char* format, va_list arguments) {
    std::vector<char> text(1000);
    std::vsnprintf(text.data(), text.size(), format, arguments);
    *static_cast<std::string*>(reason) = text.data();
    return 1;  // no other handler is called
}

struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

std::unique_ptr<TIFF, Close> openTiff(const char* mode, CheckedFile& file, const char* path, std::string& why) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                   &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keepReason, &why);
    TIFF* const tiff = TIFFClientOpenExt(
        path, mode, &file,
        [](thandle_t h, void* bytes, tmsize_t size) {
            return static_cast<tmsize_t>(fileOf(h).read(bytes, static_cast<std::size_t>(size)));
        },
        [](thandle_t h, void* bytes, tmsize_t size) {
            return fileOf(h).write(bytes, static_cast<std::size_t>(size)) ? size : tmsize_t{-1};
        },
        seekTo, [](thandle_t) { return 0; }, [](thandle_t h) { return toff_t{fileOf(h).size()}; },
        [](thandle_t, void**, toff_t*) { return 0; }, [](thandle_t, void*, toff_t) {}, options.get());
    if (!tiff) throw std::runtime_error(why);
    return std::unique_ptr<TIFF, Close>(tiff);
}

void describe(TIFF* tiff, const ImageRequest& request) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, request.width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, request.height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, request.samples == Samples::words ? 16 : 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, static_cast<int>(request.channels));
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kRowsAtOnce);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    TIFFSetField(tiff, TIFFTAG_SOFTWARE, "nacre");
    if (request.channels == 4) {
        const std::uint16_t straight = EXTRASAMPLE_UNASSALPHA;
        TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &straight);
    }
    const std::vector<std::uint8_t> profile = srgbProfile();
    TIFFSetField(tiff, TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(profile.size()), profile.data());
    if (request.dotsPerInch > 0) {
        TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
        TIFFSetField(tiff, TIFFTAG_XRESOLUTION, static_cast<double>(request.dotsPerInch));
        TIFFSetField(tiff, TIFFTAG_YRESOLUTION, static_cast<double>(request.dotsPerInch));
    }
}

}  // namespace

void writeTiff(const ImageRequest& request, CheckedFile& file) {
    const std::uint64_t row =
        std::uint64_t{request.width} * request.channels * (request.samples == Samples::words ? 2u : 1u);
    constexpr std::uint64_t kMostOfTiff = std::uint64_t{4'000'000'000};
    std::string why;
    const auto tiff = openTiff(row * request.height > kMostOfTiff ? "w8" : "w", file, request.path, why);
    const auto check = [&](bool good) {
        if (!good) throw std::runtime_error(why);
    };
    describe(tiff.get(), request);
    for (std::uint32_t first = 0; first < request.height; first += kRowsAtOnce) {
        const std::uint32_t count = std::min(kRowsAtOnce, request.height - first);
        const void* const pixels = request.rows(request.context, first, count);
        // It makes a copy to take differences in.
        check(TIFFWriteEncodedStrip(tiff.get(), first / kRowsAtOnce, const_cast<void*>(pixels),
                                    static_cast<tmsize_t>(row * count)) >= 0);
    }
    check(TIFFFlush(tiff.get()) != 0);
}

}  // namespace nacre::app
