// All calls to OpenImageIO. Together with image_webp.cpp a module of its own, loaded when a picture is written.

#include "app/images/image_codec.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/images/image_webp.h"
#include "app/images/srgb_profile.h"

namespace nacre::app {
namespace {

constexpr int kJpegQuality = 95;

struct Format {
    bool exr, tiff, jpeg;
};

Format formatOf(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return {extension == ".exr", extension == ".tif" || extension == ".tiff",
            extension == ".jpg" || extension == ".jpeg"};
}

OIIO::TypeDesc typeOf(Samples samples) {
    return samples == Samples::bytes    ? OIIO::TypeDesc::UINT8
           : samples == Samples::words  ? OIIO::TypeDesc::UINT16
           : samples == Samples::halves ? OIIO::TypeDesc::HALF
                                        : OIIO::TypeDesc::FLOAT;
}

OIIO::ImageSpec specOf(const ImageRequest& request, const Format& format) {
    OIIO::ImageSpec spec(static_cast<int>(request.width), static_cast<int>(request.height),
                         static_cast<int>(request.channels), typeOf(request.samples));
    spec.attribute("Software", "nacre");
    // Without it OpenImageIO writes the time of day; equal pictures should give equal files.
    if (format.exr || format.tiff) spec.attribute("DateTime", "1970:01:01 00:00:00");
    spec.attribute("oiio:ColorSpace", format.exr ? "Linear" : "sRGB");
    if (format.exr || format.tiff) spec.attribute("compression", "zip");
    if (!format.exr && request.channels == 4) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format.jpeg || format.tiff) {
        const std::vector<std::uint8_t> profile = srgbProfile();
        spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                       profile.data());
    }
    if (format.jpeg) {
        spec.attribute("Compression", "jpeg:" + std::to_string(kJpegQuality));
        spec.attribute("jpeg:subsampling", "4:4:4");  // subsampled red atoms bleed into white
    }
    if (request.dotsPerInch > 0) {
        spec.attribute("XResolution", request.dotsPerInch);
        spec.attribute("YResolution", request.dotsPerInch);
        spec.attribute("ResolutionUnit", "in");
    }
    if (request.channelNames) spec.channelnames.assign(request.channelNames, request.channelNames + request.channels);
    if (request.alphaChannel >= 0) spec.alpha_channel = request.alphaChannel;
    if (request.depthChannel >= 0) spec.z_channel = request.depthChannel;
    return spec;
}

/// A file that records the first failure. OpenImageIO's writers of PNG and JPEG do not check their last writes, and
/// accept half a picture on a full disk.
class CheckedFile : public OIIO::Filesystem::IOProxy {
public:
    explicit CheckedFile(const std::string& path)
        : IOProxy(path, Write), file_(::open(path.c_str(), O_RDWR | O_TRUNC | O_NOFOLLOW | O_CLOEXEC)) {
        if (file_ < 0) failure_ = errno;
    }
    ~CheckedFile() override { finish(); }

    /// Closes the file. @returns errno of the first failure, 0: none
    int finish() {
        if (file_ >= 0 && ::close(file_) != 0 && failure_ == 0) failure_ = errno;
        file_ = -1;
        return failure_;
    }

    const char* proxytype() const override { return "checked"; }  // "file" would require a FILE*
    std::size_t write(const void* bytes, std::size_t size) override {
        const std::size_t written = pwrite(bytes, size, m_pos);
        m_pos += static_cast<std::int64_t>(written);
        return written;
    }
    std::size_t pwrite(const void* bytes, std::size_t size, std::int64_t offset) override {
        std::size_t done = 0;
        while (done < size && failure_ == 0) {
            const auto at = offset + static_cast<std::int64_t>(done);
            const ssize_t n = ::pwrite(file_, static_cast<const char*>(bytes) + done, size - done, at);
            if (n > 0) done += static_cast<std::size_t>(n);
            if (n == 0) failure_ = ENOSPC;
            if (n < 0 && errno != EINTR) failure_ = errno;
        }
        return done;
    }
    std::size_t size() const override {
        const off_t end = ::lseek(file_, 0, SEEK_END);
        return end > 0 ? static_cast<std::size_t>(end) : 0;
    }

private:
    int file_ = -1;
    int failure_ = 0;
};

/// Whether a picture is complete. For TIFF, whose writer does not check either and needs a file of its own.
bool readsBack(const std::string& path, const OIIO::ImageSpec& spec) {
    const std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path);
    if (!in || in->spec().width != spec.width || in->spec().height != spec.height) return false;
    for (const char* text : {"Software", "DateTime"})
        if (in->spec().get_string_attribute(text) != spec.get_string_attribute(text)) return false;
    std::vector<std::uint8_t> row(spec.scanline_bytes());
    for (int y = 0; y < spec.height; ++y)
        if (!in->read_scanlines(0, 0, y, y + 1, 0, 0, spec.nchannels, spec.format, row.data())) return false;
    return true;
}

/// @throws std::runtime_error
void write(const ImageRequest& request) {
    const std::string path = request.path;
    const Format format = formatOf(path);
    const OIIO::ImageSpec spec = specOf(request, format);
    const OIIO::TypeDesc from = request.samples == Samples::bytes   ? OIIO::TypeDesc::UINT8
                                : request.samples == Samples::words ? OIIO::TypeDesc::UINT16
                                                                    : OIIO::TypeDesc::FLOAT;
    CheckedFile target(path);  // must outlive the writer
    if (std::filesystem::path(path).extension() == ".webp") {
        writeWebp(request, [&](const void* bytes, std::size_t size) { return target.write(bytes, size) == size; });
        if (const int failure = target.finish()) throw std::runtime_error(std::strerror(failure));
        return;
    }
    const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(path);
    if (!out) throw std::runtime_error(OIIO::geterror());
    const auto stop = [&] {
        const std::string why = out->geterror();
        const int failure = target.finish();
        throw std::runtime_error(failure ? std::strerror(failure) : why);
    };
    if (!format.tiff && !out->set_ioproxy(&target)) stop();
    if (!out->open(path, spec)) stop();
    for (std::uint32_t row = 0; row < request.height; row += kRowsAtOnce) {
        const std::uint32_t end = std::min(row + kRowsAtOnce, request.height);
        if (!out->write_scanlines(static_cast<int>(row), static_cast<int>(end), 0, from,
                                  request.rows(request.context, row, end - row)))
            stop();
    }
    if (!out->close() || target.finish() != 0) stop();
    if (format.tiff && !readsBack(path, spec))
        throw std::runtime_error("the data could not be written (is the disk full?)");
}

}  // namespace
}  // namespace nacre::app

extern "C" __attribute__((visibility("default"))) const char nacreImageCall[] = NACRE_IMAGE_CALL;

extern "C" __attribute__((visibility("default"))) bool nacreWriteImage(const nacre::app::ImageRequest* request,
                                                                       char* why, std::size_t whyBytes) {
    try {
        nacre::app::write(*request);
        return true;
    } catch (const std::exception& error) {
        std::snprintf(why, whyBytes, "%s", *error.what() ? error.what() : "OpenImageIO gives no reason");
        return false;
    }
}
