// DSN6 and BRIX, the maps of O and of the Electron Density Server: a header of 512 bytes, then bricks of 8 x 8 x 8
// bytes. DSN6 is described at uoxray.uoregon.edu/tnt/manual/node104.html, BRIX in the manual of O.
#include <cmath>
#include <cstring>

#include "engine/volume/map_grid.h"

namespace nacre {
namespace {

constexpr std::size_t kHeader = 512;
constexpr int kBrick = 8;

struct Bricks {
    MapBox box;
    double scale = 1, shift = 0;  // value = (byte - shift) / scale
    bool swapped = false;         // bytes are swapped in pairs
};

/// Numbers of a text header, by the keyword before them.
class BrixHeader {
public:
    BrixHeader(const std::string& name, std::string_view text) : name_(name), text_(lowerCase(text)) {}

    void numbers(const char* key, double* to, int count) const {
        std::size_t at = text_.find(key);
        if (at == std::string::npos) cannotReadMap(name_, std::string("its header has no ") + key);
        at += std::strlen(key);
        for (int i = 0; i < count; ++i) {
            while (at < text_.size() && isBlank(text_[at])) ++at;
            const std::size_t first = at;
            while (at < text_.size() && !isBlank(text_[at])) ++at;
            const auto value = parseNumber(std::string_view(text_).substr(first, at - first));
            if (!value || !(std::abs(*value) < 1e6)) cannotReadMap(name_, std::string("no number after ") + key);
            to[i] = *value;
        }
    }

private:
    const std::string& name_;
    std::string text_;
};

Bricks brixHeader(const std::string& name, std::string_view bytes) {
    const BrixHeader header(name, bytes.substr(0, kHeader));
    double origin[3], extent[3], grid[3], cell[6];
    header.numbers("origin", origin, 3);
    header.numbers("extent", extent, 3);
    header.numbers("grid", grid, 3);
    header.numbers("cell", cell, 6);
    Bricks bricks;
    header.numbers("prod", &bricks.scale, 1);
    header.numbers("plus", &bricks.shift, 1);
    for (int i = 0; i < 3; ++i) {
        bricks.box.start[i] = static_cast<int>(origin[i]);
        bricks.box.size[i] = static_cast<int>(extent[i]);
        bricks.box.intervals[i] = static_cast<int>(grid[i]);
        bricks.box.cell.lengths[i] = cell[i];
        bricks.box.cell.angles[i] = cell[i + 3];
    }
    return bricks;
}

Bricks dsn6Header(const std::string& name, std::string_view bytes) {
    constexpr int kScales = 18;
    const auto word = [&](int i, bool big) {
        const auto low = static_cast<unsigned char>(bytes[static_cast<std::size_t>(2 * i + (big ? 1 : 0))]),
                   high = static_cast<unsigned char>(bytes[static_cast<std::size_t>(2 * i + (big ? 0 : 1))]);
        return static_cast<std::int16_t>(low | high << 8);
    };
    Bricks bricks;
    bricks.swapped = word(kScales, false) != 100;
    if (bricks.swapped && word(kScales, true) != 100)
        cannotReadMap(name, "word 19 of its header is not 100: damaged, or not a DSN6 map");
    const auto at = [&](int i) { return static_cast<double>(word(i, bricks.swapped)); };
    if (at(17) == 0 || at(15) == 0) cannotReadMap(name, "a factor of its header is 0");
    for (int i = 0; i < 3; ++i) {
        bricks.box.start[i] = static_cast<int>(at(i));
        bricks.box.size[i] = static_cast<int>(at(3 + i));
        bricks.box.intervals[i] = static_cast<int>(at(6 + i));
        bricks.box.cell.lengths[i] = at(9 + i) / at(17);
        bricks.box.cell.angles[i] = at(12 + i) / at(17);
    }
    bricks.scale = at(15) / 100;
    bricks.shift = at(16);
    return bricks;
}

}  // namespace

DensityMap readDsn6(const std::string& name, std::string_view bytes, const MapLimits& limits) {
    if (bytes.size() < kHeader) cannotReadMap(name, "it is cut short in its header");
    Bricks bricks = startsWith(bytes, ":-)") ? brixHeader(name, bytes) : dsn6Header(name, bytes);
    MapBox& box = bricks.box;
    const std::size_t nodes = checkedNodes(name, box.size, limits);
    for (int i = 0; i < 3; ++i)
        if (box.intervals[i] < 1) cannotReadMap(name, "its cell is divided into no intervals");
    if (bricks.scale == 0) cannotReadMap(name, "the factor of its values is 0");
    const glm::ivec3 counts = (box.size + (kBrick - 1)) / kBrick;
    const std::size_t needed = kHeader + 512 * static_cast<std::size_t>(counts.x) * counts.y * counts.z;
    if (bytes.size() < needed)
        cannotReadMap(name, "it is cut short: its header announces " + std::to_string(needed) +
                                " bytes, and there are " + std::to_string(bytes.size()));
    box.values.resize(nodes);
    std::size_t at = kHeader;
    glm::ivec3 brick;
    for (brick.z = 0; brick.z < counts.z; ++brick.z)
        for (brick.y = 0; brick.y < counts.y; ++brick.y)
            for (brick.x = 0; brick.x < counts.x; ++brick.x)
                for (int i = 0; i < kBrick * kBrick * kBrick; ++i, ++at) {
                    const glm::ivec3 node = brick * kBrick + glm::ivec3(i % 8, i / 8 % 8, i / 64);
                    if (node.x >= box.size.x || node.y >= box.size.y || node.z >= box.size.z) continue;
                    const auto byte = static_cast<unsigned char>(bytes[bricks.swapped ? at ^ 1 : at]);
                    box.values[(static_cast<std::size_t>(node.z) * box.size.y + node.y) * box.size.x + node.x] =
                        static_cast<float>((byte - bricks.shift) / bricks.scale);
                }
    return completed(name, "dsn6", std::move(box), limits);
}

}  // namespace nacre
