#include "app/images/image_file.h"

#include <algorithm>
#include <array>
#include <vector>

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

bool isExr(const std::string& path) { return extensionOf(path) == ".exr"; }
bool isPng(const std::string& path) { return extensionOf(path) == ".png"; }
bool isJpeg(const std::string& path) { return extensionOf(path) == ".jpg" || extensionOf(path) == ".jpeg"; }

[[noreturn]] void fail(const OutputFile& file, std::string why) {
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw Error("cannot write file", file.path(), why);
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

WriteImage* codec(const OutputFile& file) {
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
    if (!loaded) fail(file, "image formats cannot be loaded: " + why);
    return loaded;
}
#else
WriteImage* codec(const OutputFile&) { return nacreWriteImage; }
#endif

/// Writes rows from `convert(first, count)`, which returns a pointer to interleaved channels.
template <class Convert>
void write(OutputFile& file, ImageRequest request, Convert& convert) {
    request.path = file.temporary().c_str();
    request.context = &convert;
    request.rows = [](void* context, std::uint32_t first, std::uint32_t count) -> const void* {
        return (*static_cast<Convert*>(context))(first, count);
    };
    if (isPng(file.temporary())) {
        try {
            writePng(request);
        } catch (const Error&) {  // from the function that makes the rows
            throw;
        } catch (const std::runtime_error& error) {
            fail(file, error.what());
        }
        return file.commit();
    }
    std::array<char, 1000> why{};
    if (!codec(file)(&request, why.data(), why.size())) fail(file, why.data());
    file.commit();
}

ImageRequest requestOf(std::uint32_t width, std::uint32_t height, std::uint32_t channels, Samples samples) {
    return {nullptr, width, height, channels, samples, nullptr, -1, -1, 0, nullptr, nullptr};
}

}  // namespace

PictureFormat formatOf(const PictureDescription& picture) {
    return {picture.background[3] < 1.0f, picture.bits, picture.dpi.value_or(0)};
}

bool hasAlpha(const PictureFormat& format, const std::string& path) { return format.alpha && !isJpeg(path); }

void writePicture(OutputFile& file, const Picture& picture, const PictureFormat& format) {
    const PictureRows rows = [&](std::size_t first, std::size_t) {
        return picture.rgba.data() + first * picture.width * 4;
    };
    writePicture(file, picture.width, picture.height, rows, format);
}

namespace {

template <typename Code>
void writeCoded(OutputFile& file, ImageRequest request, const PictureRows& source) {
    std::vector<Code> codes(std::size_t{request.width} * kRowsAtOnce * request.channels);
    auto rows = [&](std::uint32_t first, std::uint32_t count) {
        const float* pixels = source(first, count);
        for (std::size_t i = 0; i < std::size_t{count} * request.width; ++i)
            codePixel(pixels + i * 4, request.channels == 4, codes.data() + i * request.channels);
        return codes.data();
    };
    write(file, request, rows);
}

}  // namespace

void writePicture(OutputFile& file, std::uint32_t width, std::uint32_t height, const PictureRows& source,
                  const PictureFormat& format) {
    const std::string& path = file.temporary();
    if (isExr(path)) {
        ImageRequest request = requestOf(width, height, 4, Samples::halves);
        constexpr const char* kNames[] = {"R", "G", "B", "A"};
        request.channelNames = kNames;
        request.alphaChannel = 3;
        auto rows = [&](std::uint32_t first, std::uint32_t count) { return source(first, count); };
        return write(file, request, rows);
    }
    const bool words = format.bits == 16;
    ImageRequest request =
        requestOf(width, height, hasAlpha(format, path) ? 4 : 3, words ? Samples::words : Samples::bytes);
    request.dotsPerInch = static_cast<float>(format.dpi);
    if (words)
        writeCoded<std::uint16_t>(file, request, source);
    else
        writeCoded<std::uint8_t>(file, request, source);
}

void writePicture(OutputFile& file, const CodedPicture& picture, double dpi) {
    const auto channels = static_cast<std::uint32_t>(picture.channels());
    ImageRequest request = requestOf(picture.width, picture.height, channels, Samples::bytes);
    request.dotsPerInch = static_cast<float>(dpi);
    auto rows = [&](std::size_t first, std::size_t) { return picture.bytes.data() + first * picture.width * channels; };
    write(file, request, rows);
}

void writeLayers(OutputFile& file, const LayerPicture& layers) {
    constexpr std::uint32_t kChannels = 10;
    constexpr const char* kNames[kChannels] = {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "id.Y", "occlusion.Y"};
    ImageRequest request = requestOf(layers.width, layers.height, kChannels, Samples::floats);
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
    write(file, request, rows);
}

}  // namespace nacre::app
