#include "engine/volume/read_map.h"

#include <algorithm>

#include "engine/molecule/byte_file.h"
#include "engine/molecule/formats/decompress.h"
#include "engine/volume/ccp4_reader.h"

namespace nacre {
namespace {

constexpr std::size_t kStart = 4096;  // bytes needed to detect a format
constexpr std::size_t kPiece = 1 << 20;
// decompress.h refuses compressed files that announce more.
constexpr std::uint64_t kMostRatio = 100, kAnyRatio = std::uint64_t{64} << 20;

enum class MapFormat { none, ccp4, dx, cube, dsn6, densityServer };

/// Whether a name ends in one of these, before the extension of a compression.
bool endsIn(std::string_view name, std::initializer_list<std::string_view> endings) {
    std::string lower = lowerCase(name);
    for (const char* packed : {".gz", ".bz2", ".xz", ".zst"})
        if (lower.ends_with(packed)) lower.erase(lower.size() - std::string_view(packed).size());
    return std::any_of(endings.begin(), endings.end(),
                       [&](std::string_view ending) { return lower.ends_with(ending); });
}

bool isDx(std::string_view start) {
    LineReader lines(start);
    while (lines.next()) {
        const std::string_view line = trim(lines.line());
        if (line.empty() || line.front() == '#') continue;
        const Words words = splitWords(line);
        return words[0] == "object" && words[2] == "class" && words[3] == "gridpositions";
    }
    return false;
}

/// Two title lines (in XYZ the first is a number), then the number of atoms with the origin, then three lines with a
/// number of nodes and a step.
bool isCube(std::string_view start) {
    LineReader lines(start);
    for (int i = 0; i < 2; ++i) {
        if (!lines.next()) return false;
        if (i == 0 && parseInteger(trim(lines.line()))) return false;
    }
    for (int i = 0; i < 4; ++i) {
        if (!lines.next()) return false;
        std::string apart;
        const Words words = splitWordsApart(lines.line(), 1, apart);
        if (words.count < 4 || words.count > 5 || !parseInteger(words[0])) return false;
        for (std::size_t j = 1; j < 4; ++j)
            if (!parseNumber(words[j])) return false;
    }
    return true;
}

bool isBinaryCif(std::string_view start) {
    return start.substr(0, 512).find("dataBlocks") != std::string_view::npos ||
           start.substr(0, 512).find("encoder") != std::string_view::npos;
}

MapFormat detectFormat(std::string_view name, std::string_view start) {
    if (Ccp4Reader::recognises(start)) return MapFormat::ccp4;
    if (isDx(start)) return MapFormat::dx;
    if (startsWith(start, ":-)")) return MapFormat::dsn6;
    const bool binary = start.substr(0, 512).find('\0') != std::string_view::npos;
    if (!binary && isCube(start)) return MapFormat::cube;
    if (isBinaryCif(start) &&
        (start.find("volume_data_3d") != std::string_view::npos ||
         start.find("DensityServer") != std::string_view::npos || start.find("VolumeServer") != std::string_view::npos))
        return MapFormat::densityServer;
    // Old files have no magic number.
    if (binary && endsIn(name, {".ccp4", ".map", ".mrc", ".mrcs"})) return MapFormat::ccp4;
    if (binary && endsIn(name, {".dsn6", ".omap", ".brix"})) return MapFormat::dsn6;
    return MapFormat::none;
}

DensityMap readText(const std::string& name, MapFormat format, std::string_view text, const MapLimits& limits) {
    switch (format) {
        case MapFormat::dx:
            return readDx(name, text, limits);
        case MapFormat::cube:
            return readCube(name, text, limits);
        case MapFormat::dsn6:
            return readDsn6(name, text, limits);
        case MapFormat::densityServer:
            return readDensityServer(name, text, limits);
        case MapFormat::ccp4: {
            Ccp4Reader reader(name, limits, text.size());
            reader.take(text);
            return reader.finish();
        }
        case MapFormat::none:
            break;
    }
    cannotReadMap(name,
                  "not a density map: read are CCP4 and MRC, OpenDX, Gaussian cube, DSN6, BRIX and the BinaryCIF "
                  "of density servers");
}

/// Inflates only as much as detection needs. @param cut  the data is truncated: ignore what cannot be inflated
std::string inflatedStart(const std::string& name, std::string_view packed, bool cut = false) {
    struct Enough {};
    std::string start;
    try {
        decompress(name, packed, std::size_t{1} << 40, [&](std::string_view piece) {
            start.append(piece.substr(0, kStart - std::min(kStart, start.size())));
            if (start.size() >= kStart) throw Enough{};
        });
    } catch (const Enough&) {
    } catch (const Error&) {
        if (!cut) throw;
    }
    return start;
}

DensityMap readPacked(const std::string& name, std::string_view packed, const MapLimits& limits) {
    const MapFormat format = detectFormat(name, inflatedStart(name, packed));
    if (format != MapFormat::ccp4) return readText(name, format, decompress(name, packed, limits.maxBytes), limits);
    Ccp4Reader reader(name, limits, std::max(kAnyRatio, kMostRatio * packed.size()));
    decompress(name, packed, limits.maxBytes + kPiece, [&](std::string_view piece) { reader.take(piece); });
    return reader.finish();
}

std::string readBytes(const ByteFile& file, std::uint64_t first, std::uint64_t count) {
    std::string bytes(static_cast<std::size_t>(count), '\0');
    file.read(first, bytes.data(), bytes.size());
    return bytes;
}

}  // namespace

bool looksLikeMap(std::string_view name, std::string_view start) {
    return detectFormat(name, start) != MapFormat::none;
}

bool isMapFile(const std::string& path, const std::string& given) try {
    const std::string& name = given.empty() ? path : given;
    const auto file = ByteFile::open(path);
    if (!file) return false;
    const std::string start = readBytes(*file, 0, std::min<std::uint64_t>(file->size(), kStart));
    if (detectCompression(start).empty()) return looksLikeMap(name, start);
    // The beginning of a compressed file is enough, even if truncated.
    return looksLikeMap(
        name, inflatedStart(name, readBytes(*file, 0, std::min<std::uint64_t>(file->size(), 64 * kStart)), true));
} catch (const Error&) {
    return false;
}

DensityMap readMap(const std::string& name, std::string bytes, const MapLimits& limits) {
    if (!detectCompression(bytes).empty()) return readPacked(name, bytes, limits);
    return readText(name, detectFormat(name, std::string_view(bytes).substr(0, kStart)), bytes, limits);
}

DensityMap readMapFile(const std::string& path, const MapLimits& limits, const std::string& given) {
    const std::string& name = given.empty() ? path : given;
    const auto file = ByteFile::open(path);
    if (!file) cannotReadMap(name, ByteFile::whyNotOpened(path));
    if (file->size() == 0) cannotReadMap(name, "it is empty");
    const std::string start = readBytes(*file, 0, std::min<std::uint64_t>(file->size(), kStart));
    const bool packed = !detectCompression(start).empty();
    if (packed || detectFormat(name, start) != MapFormat::ccp4) {
        if (file->size() > limits.maxBytes)
            cannotReadMap(name, "the file has " + std::to_string(file->size() >> 20) + " MB, more than the limit of " +
                                    std::to_string(limits.maxBytes >> 20) + " MB");
        return readMap(name, readBytes(*file, 0, file->size()), limits);
    }
    Ccp4Reader reader(name, limits, file->size());
    for (std::uint64_t at = 0; at < file->size(); at += kPiece)
        reader.take(readBytes(*file, at, std::min<std::uint64_t>(kPiece, file->size() - at)));
    return reader.finish();
}

}  // namespace nacre
