#include "app/shared/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "app/shared/srgb.h"
#include "engine/error.h"
#include "engine/storage/plain_file.h"

namespace nacre::app {
namespace {

constexpr int kJpegQuality = 95;
constexpr std::uint32_t kRowsAtOnce = 64;  // what is converted at a time, so that memory stays small

bool isExr(const std::string& path) { return extensionOf(path) == ".exr"; }
bool isTiff(const std::string& path) { return extensionOf(path) == ".tif" || extensionOf(path) == ".tiff"; }
bool isJpeg(const std::string& path) { return extensionOf(path) == ".jpg" || extensionOf(path) == ".jpeg"; }

[[noreturn]] void fail(const OutputFile& file, const std::string& why) {
    std::string line = why.empty() ? "OpenImageIO gives no reason" : why;
    std::replace(line.begin(), line.end(), '\n', ' ');
    throw Error("cannot write file", file.path(), line);
}

OIIO::ImageSpec specOf(const std::string& path, std::uint32_t width, std::uint32_t height, int channels,
                       const OIIO::TypeDesc& type) {
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), channels, type);
    spec.attribute("Software", "nacre");
    // OpenImageIO would put in the time of day; equal pictures shall be equal files.
    if (isExr(path) || isTiff(path)) spec.attribute("DateTime", "1970:01:01 00:00:00");
    return spec;
}

/// A file that remembers the first failure. OpenImageIO's writers of PNG and JPEG do not look whether what they wrote
/// last has come to the disk, and are content with half a picture on a full one.
class CheckedFile : public OIIO::Filesystem::IOProxy {
public:
    explicit CheckedFile(const std::string& path) : IOProxy(path, Write), file_(openPlain(path, O_RDWR | O_TRUNC)) {
        if (file_ < 0) failure_ = errno;
    }
    ~CheckedFile() override { finish(); }

    /// Closes the file. @returns errno of the first failure, 0 if there was none
    int finish() {
        if (file_ >= 0 && ::close(file_) != 0 && failure_ == 0) failure_ = errno;
        file_ = -1;
        return failure_;
    }

    const char* proxytype() const override { return "checked"; }  // "file" promises a FILE
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

/// Whether a picture is all there. For TIFF, whose writer does not look either, and needs a file of its own.
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

/// Writes rows as `convert(firstRow, rowCount)` gives them: a pointer to rowCount rows of interleaved channels.
template <class Convert>
void writeRows(OutputFile& file, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& from, Convert&& convert) {
    CheckedFile target(file.temporary());  // outlives the writer
    const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(file.temporary());
    if (!out) fail(file, OIIO::geterror());
    const auto stop = [&] {
        const std::string why = out->geterror();
        const int failure = target.finish();
        fail(file, failure ? std::strerror(failure) : why);
    };
    if (!isTiff(file.temporary()) && !out->set_ioproxy(&target)) stop();
    if (!out->open(file.temporary(), spec)) stop();
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(spec.height); row += kRowsAtOnce) {
        const std::uint32_t end = std::min(row + kRowsAtOnce, static_cast<std::uint32_t>(spec.height));
        if (!out->write_scanlines(static_cast<int>(row), static_cast<int>(end), 0, from, convert(row, end - row)))
            stop();
    }
    if (!out->close() || target.finish() != 0) stop();
    if (isTiff(file.temporary()) && !readsBack(file.temporary(), spec))
        fail(file, "the data could not be written (is the disk full?)");
    file.commit();
}

}  // namespace

bool isPictureName(const std::string& path) {
    return isStandardOutput(path) || isExr(path) || isTiff(path) || isJpeg(path) || extensionOf(path) == ".png";
}

void writePicture(OutputFile& file, const Picture& picture, bool alpha) {
    const std::string& path = file.temporary();
    const std::size_t width = picture.width;
    if (isExr(path)) {
        OIIO::ImageSpec spec = specOf(path, picture.width, picture.height, 4, OIIO::TypeDesc::HALF);
        spec.channelnames = {"R", "G", "B", "A"};
        spec.alpha_channel = 3;
        spec.attribute("compression", "zip");
        spec.attribute("oiio:ColorSpace", "Linear");
        writeRows(file, spec, OIIO::TypeDesc::FLOAT,
                  [&](std::size_t row, std::size_t) { return picture.rgba.data() + row * width * 4; });
        return;
    }
    const bool keepAlpha = alpha && !isJpeg(path);
    const int channels = keepAlpha ? 4 : 3;
    OIIO::ImageSpec spec = specOf(path, picture.width, picture.height, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (keepAlpha) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (isJpeg(path)) {
        spec.attribute("Compression", "jpeg:" + std::to_string(kJpegQuality));
        spec.attribute("jpeg:subsampling", "4:4:4");  // red atoms on white would bleed otherwise
    }
    if (isTiff(path)) spec.attribute("compression", "zip");
    std::vector<std::uint8_t> bytes(width * kRowsAtOnce * static_cast<std::size_t>(channels));
    writeRows(file, spec, OIIO::TypeDesc::UINT8, [&](std::size_t row, std::size_t count) {
        for (std::size_t i = 0; i < count * width; ++i)
            codePixel(picture.rgba.data() + (row * width + i) * 4, keepAlpha,
                      bytes.data() + i * static_cast<std::size_t>(channels));
        return bytes.data();
    });
}

void writeLayers(OutputFile& file, const LayerPicture& layers) {
    constexpr std::size_t kChannels = 10;
    OIIO::ImageSpec spec = specOf(file.temporary(), layers.width, layers.height, kChannels, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "id", "occlusion"};
    spec.alpha_channel = 3;
    spec.z_channel = 4;
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "Linear");
    const std::size_t width = layers.width;
    std::vector<float> values(width * kRowsAtOnce * kChannels);
    writeRows(file, spec, OIIO::TypeDesc::FLOAT, [&](std::size_t row, std::size_t count) {
        for (std::size_t i = 0; i < count * width; ++i) {
            const std::size_t pixel = row * width + i;
            float* out = values.data() + i * kChannels;
            std::copy_n(layers.rgba.data() + pixel * 4, 4, out);
            out[4] = layers.z[pixel];
            std::copy_n(layers.normal.data() + pixel * 3, 3, out + 5);
            out[8] = static_cast<float>(layers.id[pixel]);  // exact up to 2^24 atoms
            out[9] = layers.occlusion[pixel];
        }
        return values.data();
    });
}

}  // namespace nacre::app
