#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "app/images/image_writers.h"

namespace nacre::app {
namespace {

class Stream : public Imf::OStream {
public:
    Stream(const char* name, CheckedFile& file) : OStream(name), file_(file) {}
    void write(const char bytes[], int size) override {
        if (!file_.write(bytes, static_cast<std::size_t>(size)))
            throw std::runtime_error(std::strerror(file_.failure()));
    }
    std::uint64_t tellp() override { return file_.place(); }
    void seekp(std::uint64_t place) override { file_.seek(place); }

private:
    CheckedFile& file_;
};

}  // namespace

void writeExr(const ImageRequest& request, CheckedFile& file) {
    const bool halves = request.samples == Samples::halves;
    const Imf::PixelType type = halves ? Imf::HALF : Imf::FLOAT;
    Imf::Header header(static_cast<int>(request.width), static_cast<int>(request.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    header.insert("software", Imf::StringAttribute("nacre"));
    for (std::uint32_t i = 0; i < request.channels; ++i)
        header.channels().insert(request.channelNames[i], Imf::Channel(type));
    const int threads = static_cast<int>(std::thread::hardware_concurrency());
    if (Imf::globalThreadCount() < threads) Imf::setGlobalThreadCount(threads);
    Stream stream(request.path, file);
    Imf::OutputFile out(stream, header, threads);
    std::vector<Imath::half> rounded;
    for (std::uint32_t first = 0; first < request.height; first += kRowsAtOnce) {
        const std::uint32_t count = std::min(kRowsAtOnce, request.height - first);
        const auto* values = static_cast<const float*>(request.rows(request.context, first, count));
        if (halves) rounded.assign(values, values + std::size_t{count} * request.width * request.channels);
        const char* const bytes =
            halves ? reinterpret_cast<const char*>(rounded.data()) : reinterpret_cast<const char*>(values);
        const std::size_t sample = halves ? sizeof(Imath::half) : sizeof(float), pixel = sample * request.channels;
        Imf::FrameBuffer frame;
        for (std::uint32_t i = 0; i < request.channels; ++i)
            frame.insert(request.channelNames[i],
                         Imf::Slice::Make(type, bytes + i * sample, Imath::V2i(0, static_cast<int>(first)),
                                          static_cast<int>(request.width), static_cast<int>(count), pixel,
                                          pixel * request.width));
        out.setFrameBuffer(frame);
        out.writePixels(static_cast<int>(count));
    }
}

}  // namespace nacre::app
