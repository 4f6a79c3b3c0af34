#include "app/images/image_file.h"

#include <algorithm>
#include <array>
#include <vector>

#include "app/files/unnamed_file.h"
#include "app/images/image_codec.h"
#include "app/images/image_png.h"
#include "engine/error.h"
#include "engine/srgb.h"
#include "engine/storage/own_folder.h"
#ifdef NACRE_IMAGE_MODULE
#include <dlfcn.h>

#include <filesystem>
#include <mutex>
#include <string_view>
#endif

namespace nacre::app {
namespace {

/// Destination of a picture.
struct ImageTarget {
    std::string name;       ///< for messages
    std::string path;       ///< of the file
    std::string extension;  ///< in lower case, with the dot
    int file;               ///< open for reading and writing
};

ImageTarget makeTarget(const OutputFile& file) {
    return {file.path(), file.temporary(), fileExtension(file.temporary()), file.descriptor()};
}

bool isJpeg(const std::string& extension) { return extension == ".jpg" || extension == ".jpeg"; }

[[noreturn]] void fail(const ImageTarget& target, std::string why) {
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw Error("cannot write file", target.name, why);
}

#ifdef NACRE_IMAGE_MODULE
/// Folders that may hold the module: the program's own, and the installed one.
std::vector<std::string> moduleNames() {
    const std::filesystem::path program = ownFolder();
    if (program.empty()) return {};
    return {(program / NACRE_IMAGE_MODULE).string(), (program / NACRE_MODULE_FOLDER / NACRE_IMAGE_MODULE).string()};
}

/// The module's function, if it has the same interface. @param why  receives the reason of a failure
WriteImage* load(const std::string& name, std::string& why) {
    // Never unloaded: its libraries do not support that.
    void* library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) return why = std::filesystem::exists(name) ? dlerror() : "there is no " + name, nullptr;
    const auto* call = static_cast<const char*>(dlsym(library, "nacreImageCall"));
    if (call && std::string_view(call) == NACRE_IMAGE_CALL)
        return reinterpret_cast<WriteImage*>(dlsym(library, "nacreWriteImage"));
    why = name + " belongs to another build of nacre";
    return nullptr;
}

WriteImage* codec(const ImageTarget& target) {
    static std::mutex turn;
    static WriteImage* loaded = nullptr;
    const std::lock_guard lock(turn);
    std::string why = "the program's folder is not known";
    for (const std::string& name : moduleNames()) {
        if (loaded) break;
        std::string reason;
        loaded = load(name, reason);
        if (why.find("another build") == std::string::npos) why = reason;
    }
    if (!loaded) fail(target, "image formats cannot be loaded: " + why);
    return loaded;
}
#else
WriteImage* codec(const ImageTarget&) { return nacreWriteImage; }
#endif

/// Writes rows from `convert(first, count)`, which returns a pointer to interleaved channels.
template <class Convert>
void write(const ImageTarget& target, ImageRequest request, Convert& convert) {
    request.path = target.path.c_str();
    request.file = target.file;
    request.extension = target.extension.c_str();
    request.context = &convert;
    request.rows = [](void* context, std::uint32_t first, std::uint32_t count) -> const void* {
        return (*static_cast<Convert*>(context))(first, count);
    };
    if (target.extension == ".png") {
        try {
            return writePng(request);
        } catch (const Error&) {  // from the function that makes the rows
            throw;
        } catch (const std::runtime_error& error) {
            fail(target, error.what());
        }
    }
    std::array<char, 1000> why{};
    if (!codec(target)(&request, why.data(), why.size())) fail(target, why.data());
}

ImageRequest makeRequest(std::uint32_t width, std::uint32_t height, std::uint32_t channels, Samples samples) {
    return {nullptr, -1, nullptr, width, height, channels, samples, nullptr, -1, -1, 0, nullptr, nullptr};
}

}  // namespace

PictureFormat chooseFormat(const PictureDescription& picture) {
    return {picture.background[3] < 1.0f, picture.bits, picture.dpi.value_or(0)};
}

bool hasAlpha(const PictureFormat& format, const std::string& path) {
    return format.alpha && !isJpeg(fileExtension(path));
}

namespace {

template <typename Code>
void writeCoded(const ImageTarget& target, ImageRequest request, const PictureRows& source) {
    std::vector<Code> codes(std::size_t{request.width} * kRowsAtOnce * request.channels);
    auto rows = [&](std::uint32_t first, std::uint32_t count) {
        const float* pixels = source(first, count);
        for (std::size_t i = 0; i < std::size_t{count} * request.width; ++i)
            codePixel(pixels + i * 4, request.channels == 4, codes.data() + i * request.channels);
        return codes.data();
    };
    write(target, request, rows);
}

void writeRows(const ImageTarget& target, std::uint32_t width, std::uint32_t height, const PictureRows& source,
               const PictureFormat& format) {
    if (target.extension == ".exr") {
        ImageRequest request = makeRequest(width, height, 4, Samples::halves);
        constexpr const char* kNames[] = {"R", "G", "B", "A"};
        request.channelNames = kNames;
        request.alphaChannel = 3;
        auto rows = [&](std::uint32_t first, std::uint32_t count) { return source(first, count); };
        return write(target, request, rows);
    }
    const bool words = format.bits == 16;
    const bool alpha = format.alpha && !isJpeg(target.extension);
    ImageRequest request = makeRequest(width, height, alpha ? 4 : 3, words ? Samples::words : Samples::bytes);
    request.dotsPerInch = static_cast<float>(format.dpi);
    if (words)
        writeCoded<std::uint16_t>(target, request, source);
    else
        writeCoded<std::uint8_t>(target, request, source);
}

PictureRows toRows(const Picture& picture) {
    return [&](std::size_t first, std::size_t) { return picture.rgba.data() + first * picture.width * 4; };
}

}  // namespace

void writePicture(OutputFile& file, const Picture& picture, const PictureFormat& format) {
    writePicture(file, picture.width, picture.height, toRows(picture), format);
}

void writePicture(OutputFile& file, std::uint32_t width, std::uint32_t height, const PictureRows& source,
                  const PictureFormat& format) {
    writeRows(makeTarget(file), width, height, source, format);
    file.commit();
}

std::string encodePicture(const std::string& extension, const Picture& picture, const PictureFormat& format) {
    UnnamedFile file;
    writeRows({"the picture", file.path(), extension, file.descriptor()}, picture.width, picture.height,
              toRows(picture), format);
    return file.bytes();
}

namespace {

void writeCodes(const ImageTarget& target, const CodedPicture& picture, double dpi) {
    const auto channels = static_cast<std::uint32_t>(picture.channels());
    ImageRequest request = makeRequest(picture.width, picture.height, channels, Samples::bytes);
    request.dotsPerInch = static_cast<float>(dpi);
    auto rows = [&](std::size_t first, std::size_t) { return picture.bytes.data() + first * picture.width * channels; };
    write(target, request, rows);
}

}  // namespace

std::string encodePicture(const std::string& extension, const CodedPicture& picture) {
    UnnamedFile file;
    writeCodes({"the picture", file.path(), extension, file.descriptor()}, picture, 0);
    return file.bytes();
}

void writePicture(OutputFile& file, const CodedPicture& picture, double dpi) {
    writeCodes(makeTarget(file), picture, dpi);
    file.commit();
}

void writeLayers(OutputFile& file, const LayerPicture& layers) {
    constexpr std::uint32_t kChannels = 10;
    constexpr const char* kNames[kChannels] = {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "id.Y", "occlusion.Y"};
    ImageRequest request = makeRequest(layers.width, layers.height, kChannels, Samples::floats);
    request.channelNames = kNames;
    request.alphaChannel = 3;
    request.depthChannel = 4;
    const std::size_t width = layers.width;
    std::vector<float> values(width * kRowsAtOnce * kChannels);
    auto rows = [&](std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count * width; ++i) {
            const std::size_t pixel = first * width + i;
            float* out = values.data() + i * kChannels;
            std::copy_n(layers.rgba.data() + pixel * 4, 4, out);
            out[4] = layers.z[pixel];
            std::copy_n(layers.normal.data() + pixel * 3, 3, out + 5);
            out[8] = static_cast<float>(layers.id[pixel]);  // exact up to 2^24 atoms
            out[9] = layers.occlusion[pixel];
        }
        return values.data();
    };
    write(makeTarget(file), request, rows);
    file.commit();
}

}  // namespace nacre::app
