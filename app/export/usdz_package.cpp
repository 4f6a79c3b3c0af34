#include "app/export/usdz_package.h"

#include <zlib.h>

#include <cmath>

#include "app/images/image_file.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::size_t kAlignment = 64, kLocalHeader = 30, kExtraHeader = 4;
constexpr std::uint16_t kPadding = 0x1986;   // the extra field's kind in OpenUSD's own packages
constexpr std::uint16_t kFirstDay = 0x0021;  // 1980-01-01: the same scene gives the same bytes
constexpr std::uint32_t kBlock = 4;

void little(std::string& out, std::size_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(value >> 8 * i & 255));
}

std::size_t checksum(const std::string& bytes) {
    return crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

/// Fields shared by a local header and a directory entry.
std::string makeEntry(const PackedFile& file, std::size_t extra) {
    std::string out;
    little(out, 10, 2);  // version needed
    little(out, 0, 2);   // flags
    little(out, 0, 2);   // stored
    little(out, 0, 2);   // time
    little(out, kFirstDay, 2);
    little(out, checksum(file.bytes), 4);
    little(out, file.bytes.size(), 4);
    little(out, file.bytes.size(), 4);
    little(out, file.name.size(), 2);
    little(out, extra, 2);
    return out;
}

}  // namespace

std::string storedArchive(const std::vector<PackedFile>& files, std::size_t most) {
    std::string out, directory;
    for (const PackedFile& file : files) {
        const std::size_t at = out.size();
        std::size_t extra = kExtraHeader;
        extra += (kAlignment - (at + kLocalHeader + file.name.size() + extra) % kAlignment) % kAlignment;
        if (at + kLocalHeader + file.name.size() + extra + file.bytes.size() > most)
            throw Error("cannot export molecule", "", "a .usdz file is limited to 4 GiB (fewer --sides, or .glb)");
        out += "PK\x03\x04" + makeEntry(file, extra) + file.name;
        little(out, kPadding, 2);
        little(out, extra - kExtraHeader, 2);
        out.append(extra - kExtraHeader, '\0');
        out += file.bytes;
        directory += "PK\x01\x02";
        little(directory, 10, 2);  // made by
        directory += makeEntry(file, 0);
        directory.append(10, '\0');  // comment, disk, attributes
        little(directory, at, 4);
        directory += file.name;
    }
    const std::size_t at = out.size();
    out += directory + "PK\x05\x06";
    little(out, 0, 4);  // disks
    little(out, files.size(), 2);
    little(out, files.size(), 2);
    little(out, directory.size(), 4);
    little(out, at, 4);
    little(out, 0, 2);
    return out;
}

std::uint32_t sheetSide(std::size_t colors) {
    return static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(colors))));
}

std::string colorSheet(const std::vector<std::uint32_t>& colors) {
    const std::uint32_t side = sheetSide(colors.size()), pixels = side * kBlock;
    CodedPicture sheet{pixels, pixels, false, {}};
    sheet.bytes.reserve(std::size_t{pixels} * pixels * 3);
    for (std::uint32_t y = 0; y < pixels; ++y)
        for (std::uint32_t x = 0; x < pixels; ++x) {
            const std::size_t i = std::size_t{y / kBlock} * side + x / kBlock;
            const std::uint32_t color = i < colors.size() ? colors[i] : 0;
            for (const int shift : {0, 8, 16}) sheet.bytes.push_back(static_cast<std::uint8_t>(color >> shift));
        }
    return encodePicture(".png", sheet);
}

}  // namespace nacre::app
