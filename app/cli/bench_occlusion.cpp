#include "app/cli/bench_occlusion.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <ostream>

namespace nacre::app {
namespace {

constexpr OcclusionMaps kMaps[] = {OcclusionMaps::encoded, OcclusionMaps::fragdepth, OcclusionMaps::tiles};
// Rounds at most, and milliseconds after which no further round begins.
constexpr int kRounds = 5;
constexpr double kEnoughBaking = 3'000;

}  // namespace

Json timesJson(std::vector<double> samples) {
    std::sort(samples.begin(), samples.end());
    return {{"min", samples.front()},
            {"median", samples[samples.size() / 2]},
            {"p99", samples[(samples.size() * 99 + 99) / 100 - 1]}};
}

Json compareMaps(RenderSettings settings, Renderer& renderer) {
    Json rows = Json::array();
    if (settings.occlusion.directions == 0) return rows;
    std::array<std::vector<double>, std::size(kMaps)> samples;
    std::array<OcclusionStats, std::size(kMaps)> stats;
    double spent = 0;
    for (int round = 0; round < kRounds && spent < kEnoughBaking; ++round)
        for (std::size_t i = 0; i < std::size(kMaps); ++i) {
            settings.occlusion.maps = kMaps[i];  // another path than the last one's: baked anew
            renderer.render(settings);
            stats[i] = renderer.stats().occlusion;
            samples[i].push_back(renderer.stats().bakeMilliseconds);
            spent += samples[i].back();
        }
    for (std::size_t i = 0; i < std::size(kMaps); ++i) {
        const double best = *std::min_element(samples[i].begin(), samples[i].end());
        rows.push_back({{"maps", stats[i].maps},
                        {"directions", settings.occlusion.directions},
                        {"bake", timesJson(samples[i])},
                        {"patch_texels", stats[i].patchTexels},
                        {"texels", stats[i].texels},
                        {"map_pixels", stats[i].mapPixels},
                        {"maps_per_batch", stats[i].mapsPerBatch},
                        {"texel_directions", stats[i].asked},
                        {"ns_per_texel_direction", best * 1e6 / static_cast<double>(stats[i].asked)}});
    }
    return rows;
}

void printOcclusion(const Json& rows, std::ostream& out) {
    if (rows.empty()) return;
    out << "\nocclusion, " << rows[0]["directions"]
        << " directions\nmaps         bake ms min   median    texels  map px  ns per texel x direction\n";
    for (const Json& row : rows)
        out << std::left << std::setw(13) << row["maps"].get<std::string>() << std::right << std::setw(11)
            << row["bake"]["min"].get<double>() << std::setw(9) << row["bake"]["median"].get<double>() << std::setw(10)
            << row["texels"].get<std::uint64_t>() << std::setw(8) << row["map_pixels"].get<std::uint32_t>()
            << std::setw(26) << row["ns_per_texel_direction"].get<double>() << "\n";
}

}  // namespace nacre::app
