// Counts the work of `tiles` without subgroup operations for a frame of spheres: tile_counts FILE [WxH] (1170x2532).
// Repeats shaders/tile_bins.comp, tile_sort.comp and tile_numbers.comp on the host. Prints JSON:
// counts, the instructions that Mali-G610 takes for them, and bytes that go to memory and back.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"
#include "engine/tiles/device_lists.h"
#include "engine/tiles/tile_set.h"

namespace {

using namespace nacre;

struct Seen {
    float x, y, radius;  // pixels
    float z, near;       // in steps of the order: centre, nearest point
};

struct Counts {
    std::uint64_t spheres = 0, bins = 0, entries = 0, longest = 0;
    std::uint64_t shown = 0;        ///< bins with entries
    std::uint64_t comparisons = 0;  ///< of two entries, where short lists are sorted
    std::uint64_t longLists = 0, longEntries = 0;
    std::uint64_t chunks = 0;   ///< of 64 entries, fetched by a tile
    std::uint64_t passed = 0;   ///< entries that meet their tile: each of its pixels tests them
    std::uint64_t covered = 0;  ///< pixels
    std::uint64_t share = 1;    ///< invocations per sphere that find its bins
};

/// Instructions of each stage on Mali-G610, in millions: those of the blocks that PanVK 25.0.7 lists for spheres
/// (BIFROST_MESA_DEBUG=shaders, tools/tilers --pipelines tiles), times how often they run.
nlohmann::ordered_json instructions(const Counts& c) {
    constexpr std::uint64_t kTile = TileSet::kTilePixels * TileSet::kTilePixels, kSorters = 128;
    const auto millions = [](std::uint64_t all) { return std::round(static_cast<double>(all) / 1e5) / 10; };
    const std::uint64_t lists = c.spheres * c.share * 2 * 203 + c.entries * (84 + 105), place = c.bins * 361;
    const std::uint64_t merged = c.comparisons * 38 + (c.entries - c.longEntries) * 40;
    const std::uint64_t counted = c.longLists * kSorters * 418 + c.longEntries * 34;
    const std::uint64_t sort = kSorters * (c.bins * 24 + c.shown * 30) + merged + counted;
    const std::uint64_t nearest =
        4 * kTile * (c.bins * 63 + c.shown * 31) + c.chunks * kTile * 76 + c.passed * (21 + kTile * 49);
    const std::uint64_t shade = c.covered * 224;
    return {{"count, write", millions(lists)}, {"place", millions(place)},
            {"sort", millions(sort)},          {"nearest", millions(nearest)},
            {"shade", millions(shade)},        {"all", millions(lists + place + sort + nearest + shade)}};
}

/// Shapes, entries and lists, and 12 bytes per pixel: its number, written and read, and its colour.
std::uint64_t countBytes(const Counts& c, const View& view) {
    return 2 * c.spheres * c.share * sizeof(Sphere) + 36 * c.entries + c.chunks * 64 * (4 + sizeof(Sphere)) +
           std::uint64_t{12} * view.width * view.height;
}

std::vector<Seen> place(const Representation& scene, const View& view) {
    constexpr double kSteps = 2048;  // layout::kListSteps
    std::vector<Seen> all;
    const double scale = view.pixelsPerAngstrom, perStep = kSteps / (2 * view.radius);
    for (const Sphere& s : scene.spheres) {
        const glm::dvec3 p = view.rotation * glm::dvec3(s.center);
        const double z = (view.radius - p.z) * perStep;
        all.push_back({static_cast<float>(view.width / 2.0 + p.x * scale),
                       static_cast<float>(view.height / 2.0 - p.y * scale), static_cast<float>(s.radius * scale),
                       static_cast<float>(z), static_cast<float>(z - s.radius * perStep)});
    }
    return all;
}

/// A tile's pixels and its list, from near to far.
void drawTile(const std::vector<Seen>& all, const std::vector<std::uint32_t>& list, std::uint32_t left,
              std::uint32_t top, Counts& counts) {
    constexpr std::uint32_t kSide = TileSet::kTilePixels, kGroup = kSide * kSide;
    std::vector<float> nearest(kGroup, 1e9f);
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min<std::size_t>(at + kGroup, list.size());
        ++counts.chunks;
        for (; at < end; ++at) {
            const Seen& s = all[list[at]];
            const float middleX = static_cast<float>(left) + kSide / 2.0f,
                        middleY = static_cast<float>(top) + kSide / 2.0f;
            const float outX = std::max(std::abs(middleX - s.x) - kSide / 2.0f, 0.0f);
            const float outY = std::max(std::abs(middleY - s.y) - kSide / 2.0f, 0.0f);
            if (outX * outX + outY * outY > s.radius * s.radius) continue;
            ++counts.passed;
            for (std::uint32_t i = 0; i < kGroup; ++i) {
                const float x = static_cast<float>(left + i % kSide) + 0.5f - s.x;
                const float y = static_cast<float>(top + i / kSide) + 0.5f - s.y;
                const float h = s.radius * s.radius - x * x - y * y;
                if (h >= 0) nearest[i] = std::min(nearest[i], s.z - std::sqrt(h) / s.radius * (s.z - s.near));
            }
        }
        // The order has a step's tolerance.
        if (at < list.size() && *std::ranges::max_element(nearest) < all[list[at - 1]].near - 2) break;
    }
    counts.covered += static_cast<std::uint64_t>(std::ranges::count_if(nearest, [](float z) { return z < 1e9f; }));
}

Counts count(const std::vector<Seen>& all, const View& view) {
    constexpr std::size_t kShort = 128;  // shaders/tile_sort.comp
    constexpr std::uint32_t kBin = TileSet::kBinPixels;
    const std::uint32_t across = (view.width + kBin - 1) / kBin, down = (view.height + kBin - 1) / kBin;
    std::vector<std::vector<std::uint32_t>> lists(std::size_t{across} * down);
    Counts counts{.spheres = all.size(), .bins = lists.size()};
    const auto bin = [](float place, std::uint32_t most) {
        return static_cast<std::uint32_t>(std::clamp(place / kBin, 0.0f, static_cast<float>(most)));
    };
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        const Seen& s = all[i];
        for (std::uint32_t y = bin(s.y - s.radius, down); y < std::min(bin(s.y + s.radius, down) + 1, down); ++y)
            for (std::uint32_t x = bin(s.x - s.radius, across); x < std::min(bin(s.x + s.radius, across) + 1, across);
                 ++x)
                lists[std::size_t{y} * across + x].push_back(i);
    }
    for (std::size_t b = 0; b < lists.size(); ++b) {
        std::vector<std::uint32_t>& list = lists[b];
        counts.entries += list.size();
        counts.longest = std::max<std::uint64_t>(counts.longest, list.size());
        std::uint64_t size = 2, rounds = 1, log = 1;
        for (; size < list.size(); size *= 2) rounds += ++log;
        if (!list.empty()) ++counts.shown;
        if (list.size() > kShort)
            ++counts.longLists, counts.longEntries += list.size();
        else if (!list.empty())
            counts.comparisons += size / 2 * rounds;
        std::ranges::stable_sort(list, {}, [&](std::uint32_t i) { return std::floor(all[i].near); });
        const auto left = static_cast<std::uint32_t>(b % across) * kBin,
                   top = static_cast<std::uint32_t>(b / across) * kBin;
        for (std::uint32_t tile = 0; tile < 4; ++tile)
            drawTile(all, list, left + tile % 2 * TileSet::kTilePixels, top + tile / 2 * TileSet::kTilePixels, counts);
    }
    double radius = 0;
    for (const Seen& s : all) radius += s.radius / static_cast<double>(all.size());
    const double side = (2 * 1.005 * radius + 1) / kBin + 2;  // as in boundEntries()
    counts.share = passes::chooseShare(static_cast<std::uint64_t>(std::ceil(side * side)) * all.size(), all.size());
    return counts;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) throw std::runtime_error("tile_counts FILE [WxH]");
    const Molecule molecule = readMoleculeFile(argv[1]);
    const Representation scene = represent(molecule, drawnAtoms(molecule), {Style::spacefill});
    unsigned width = 1170, height = 2532;
    if (argc > 2 && std::sscanf(argv[2], "%ux%u", &width, &height) != 2) throw std::runtime_error("no WxH");
    const View view = makeView(Camera(), scene.radius, width, height);
    const Counts c = count(place(scene, view), view);
    const nlohmann::ordered_json report{{"spheres", c.spheres},
                                        {"bins", c.bins},
                                        {"shown_bins", c.shown},
                                        {"entries", c.entries},
                                        {"longest_list", c.longest},
                                        {"comparisons", c.comparisons},
                                        {"long_lists", c.longLists},
                                        {"long_entries", c.longEntries},
                                        {"chunks", c.chunks},
                                        {"passed", c.passed},
                                        {"covered", c.covered},
                                        {"share", c.share},
                                        {"million_instructions", instructions(c)},
                                        {"bytes", countBytes(c, view)}};
    std::puts(report.dump().c_str());
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "tile_counts: %s\n", error.what());
    return 1;
}
