// TIFF 6.0 with deflated strips, and BigTIFF. Does not use libtiff, which links otherwise unneeded libraries, one of
// them under the GPL.

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "app/images/image_writers.h"
#include "app/images/srgb_profile.h"

namespace nacre::app {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are written as they are in memory");

enum class FieldType : std::uint16_t { ascii = 2, words = 3, longs = 4, rational = 5, bytes = 7, longs8 = 16 };

struct Field {
    std::uint16_t tag;
    FieldType type;
    std::uint64_t count;
    std::vector<std::uint8_t> value;
};

void put(std::vector<std::uint8_t>& out, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

Field field(std::uint16_t tag, FieldType type, const std::vector<std::uint64_t>& values) {
    Field f{tag, type, values.size(), {}};
    const int bytes = type == FieldType::words ? 2 : type == FieldType::longs8 ? 8 : 4;
    for (const std::uint64_t value : values) put(f.value, value, bytes);
    if (type == FieldType::rational) f.count /= 2;
    return f;
}

Field fieldOfBytes(std::uint16_t tag, FieldType type, std::vector<std::uint8_t> bytes) {
    const std::uint64_t count = bytes.size();
    return {tag, type, count, std::move(bytes)};
}

/// Replaces each sample by its difference from its left neighbour, which compresses better.
template <typename Sample>
void takeDifferences(Sample* samples, std::size_t rows, std::size_t width, std::size_t channels) {
    for (std::size_t y = 0; y < rows; ++y) {
        Sample* const row = samples + y * width * channels;
        for (std::size_t i = width * channels; i-- > channels;)
            row[i] = static_cast<Sample>(row[i] - row[i - channels]);
    }
}

std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::uint8_t> out(size);
    if (compress2(out.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK)
        throw std::runtime_error("zlib fails");
    out.resize(size);
    return out;
}

/// Writes the fields at the end of the file. @param big  offsets of 8 bytes @returns their position
std::uint64_t writeFields(const std::vector<Field>& fields, bool big, CheckedFile& file) {
    const int wide = big ? 8 : 4;
    std::vector<std::uint8_t> list;
    put(list, fields.size(), big ? 8 : 2);
    for (const Field& f : fields) {
        put(list, f.tag, 2);
        put(list, static_cast<std::uint64_t>(f.type), 2);
        put(list, f.count, wide);
        std::vector<std::uint8_t> value = f.value;
        if (value.size() > static_cast<std::size_t>(wide)) {
            if (file.place() % 2) file.write("", 1);  // values begin at even positions
            const std::uint64_t place = file.place();
            file.write(f.value.data(), f.value.size());
            value.clear();
            put(value, place, wide);
        }
        value.resize(static_cast<std::size_t>(wide));
        list.insert(list.end(), value.begin(), value.end());
    }
    put(list, 0, wide);  // no further picture
    if (file.place() % 2) file.write("", 1);
    const std::uint64_t place = file.place();
    file.write(list.data(), list.size());
    return place;
}

std::vector<std::uint8_t> makeHeader(bool big, std::uint64_t fields) {
    std::vector<std::uint8_t> header = {'I', 'I', static_cast<std::uint8_t>(big ? 43 : 42), 0};
    if (big) put(header, 8, 4);
    put(header, fields, big ? 8 : 4);
    return header;
}

}  // namespace

void writeTiff(const ImageRequest& request, CheckedFile& file) {
    const std::size_t sample = request.samples == Samples::words ? 2 : 1, channels = request.channels;
    const std::size_t row = std::size_t{request.width} * channels * sample;
    constexpr std::uint64_t kMostOfTiff = 4'000'000'000;
    const bool big = std::uint64_t{row} * request.height > kMostOfTiff;
    const std::vector<std::uint8_t> placeholder = makeHeader(big, 0);
    file.write(placeholder.data(), placeholder.size());
    std::vector<std::uint64_t> places, sizes;
    for (std::uint32_t first = 0; first < request.height; first += kRowsAtOnce) {
        const std::uint32_t count = std::min(kRowsAtOnce, request.height - first);
        std::vector<std::uint8_t> strip(row * count);
        std::memcpy(strip.data(), request.rows(request.context, first, count), strip.size());
        if (sample == 2)
            takeDifferences(reinterpret_cast<std::uint16_t*>(strip.data()), count, request.width, channels);
        else
            takeDifferences(strip.data(), count, request.width, channels);
        strip = deflated(strip);
        places.push_back(file.place());
        sizes.push_back(strip.size());
        if (!file.write(strip.data(), strip.size())) return;
    }
    using enum FieldType;
    constexpr std::uint64_t kDeflate = 8, kRgb = 2, kTopLeft = 1, kTogether = 1, kInch = 2, kDifferences = 2,
                            kStraight = 2;
    const FieldType offsets = big ? longs8 : longs;
    std::vector<Field> fields = {field(256, longs, {request.width}),
                                 field(257, longs, {request.height}),
                                 field(258, words, std::vector<std::uint64_t>(channels, 8 * sample)),
                                 field(259, words, {kDeflate}),
                                 field(262, words, {kRgb}),
                                 field(273, offsets, places),
                                 field(274, words, {kTopLeft}),
                                 field(277, words, {channels}),
                                 field(278, longs, {kRowsAtOnce}),
                                 field(279, offsets, sizes)};
    if (request.dotsPerInch > 0) {
        constexpr double kParts = 1000;
        const auto parts = static_cast<std::uint64_t>(request.dotsPerInch * kParts + 0.5);
        for (const std::uint16_t tag : {std::uint16_t{282}, std::uint16_t{283}})
            fields.push_back(field(tag, rational, {parts, static_cast<std::uint64_t>(kParts)}));
    }
    fields.push_back(field(284, words, {kTogether}));
    if (request.dotsPerInch > 0) fields.push_back(field(296, words, {kInch}));
    static constexpr char kSoftware[] = "nacre";  // with its terminating zero
    fields.push_back(fieldOfBytes(305, ascii, std::vector<std::uint8_t>(kSoftware, kSoftware + sizeof kSoftware)));
    fields.push_back(field(317, words, {kDifferences}));
    if (channels == 4) fields.push_back(field(338, words, {kStraight}));
    fields.push_back(fieldOfBytes(34675, bytes, srgbProfile()));
    const std::uint64_t at = writeFields(fields, big, file);
    const std::vector<std::uint8_t> header = makeHeader(big, at);
    file.seek(0);
    file.write(header.data(), header.size());
}

}  // namespace nacre::app
