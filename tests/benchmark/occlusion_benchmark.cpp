// How long ambient occlusion takes to bake: occlusion_benchmark [Google Benchmark's options], on the device that
// VK_DRIVER_FILES names. The molecules are those of docs/measurements.md (tests/support/test_data.h says where they are
// looked for).
//   bake/NAME    the whole bake; `large/` before it is a million atoms, to be filtered out where there is no time
//   paths/NAME/  the same by every path of the depth maps
//   floor/NAME   reading each of its depth maps once and writing each texel once
// --benchmark_enable_random_interleaving=true lets the machine's moods meet all of them; minima are what counts. The
// column CPU and the counters are processor time of all cores, which other programs disturb least.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "engine/frame/choose.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/occlusion/bake.h"
#include "tests/benchmark/occlusion_floor.h"
#include "tests/support/test_data.h"

namespace {

using namespace nacre;

struct Subject {
    const char *name, *file;
    int directions;
    int repetitions;
};
constexpr Subject kSubjects[] = {{"1BNA", "1bna.pdb", 128, 7},
                                 {"4HHB", "4hhb.pdb", 128, 5},
                                 {"1AON", "1aon-groel.pdb.gz", 128, 3},
                                 {"large/3J6R capsid", "3j6r-capsid-expanded.cif.gz", 16, 1}};

/// Processor time of all threads, the software driver's among them.
double processorMs() { return static_cast<double>(std::clock()) * 1e3 / CLOCKS_PER_SEC; }

/// The engine's device with one molecule on it, made when first asked for: those that are filtered out cost nothing.
struct Stage {
    gpu::Device device{DeviceOptions{}};
    gpu::Executor executor{device};
    Representation scene;
    passes::SceneBuffers buffers;
    double floorMs = 0;

    explicit Stage(const std::string& file) {
        const Molecule molecule = readMoleculeFile(test::dataFile(file));
        scene = represent(molecule, drawnAtoms(molecule), {Style::spacefill});
        buffers = passes::makeSceneBuffers(device, scene);
    }
    OcclusionMaps deviceMaps() const { return chooseOcclusionMaps(device.caps()); }
    std::unique_ptr<occlusion::Bake> bake(int directions, OcclusionMaps maps) {
        const occlusion::BakeOptions options{directions, 64ull << 20, maps};
        return std::make_unique<occlusion::Bake>(device, buffers, scene, options);
    }
    test::OcclusionFloor floor(const occlusion::Bake& bake) const {
        const std::uint64_t pixels = bake.maps().pixels(), perBatch = bake.maps().perBatch();
        return {device, 4 * pixels * pixels * perBatch, static_cast<std::uint32_t>(perBatch), bake.texels()};
    }
};

Stage& findStage(const Subject& subject) {
    static std::map<std::string, std::unique_ptr<Stage>> stages;
    std::unique_ptr<Stage>& stage = stages[subject.file];
    if (!stage) stage = std::make_unique<Stage>(subject.file);
    return *stage;
}

/// Milliseconds of the floor under a bake, the best of five.
double measureFloor(Stage& stage, const occlusion::Bake& bake) {
    if (stage.floorMs > 0) return stage.floorMs;
    const test::OcclusionFloor floor = stage.floor(bake);
    for (int i = 0; i < 5; ++i) {
        const double start = processorMs();
        floor.run(static_cast<std::uint32_t>(bake.directions()));
        const double ms = processorMs() - start;
        if (i == 0 || ms < stage.floorMs) stage.floorMs = ms;
    }
    return stage.floorMs;
}

/// Counters: where the time goes, what was asked, and how it compares with the floor.
void bakeAll(benchmark::State& state, const Subject& subject, OcclusionMaps maps) {
    Stage& stage = findStage(subject);
    if (maps == OcclusionMaps::automatic) maps = stage.deviceMaps();
    for (auto _ : state) {
        const double start = processorMs();
        const auto bake = stage.bake(subject.directions, maps);
        const double begun = processorMs();
        const auto texels = static_cast<double>(bake->texels());
        while (bake->directionsDone() < bake->directions()) bake->step(stage.executor);
        const double stepped = processorMs();
        bake->finish(stage.executor);
        const double ms = processorMs() - start;
        state.PauseTiming();
        stage.executor.forget("occlusion");
        const auto questions = static_cast<double>(bake->asked());
        state.counters["texels"] = texels;
        state.counters["texels_left"] = static_cast<double>(bake->texels());
        state.counters["map_pixels"] = bake->maps().pixels();
        state.counters["begin_ms"] = begun - start;
        state.counters["steps_ms"] = stepped - begun;
        state.counters["texel_directions"] = questions;
        state.counters["ns_each"] = ms * 1e6 / questions;
        state.counters["steps_ns_each"] = (stepped - begun) * 1e6 / questions;
        state.counters["of_floor"] = ms / measureFloor(stage, *bake);
        state.ResumeTiming();
    }
}

void floorAlone(benchmark::State& state, const Subject& subject) {
    Stage& stage = findStage(subject);
    const test::OcclusionFloor floor = stage.floor(*stage.bake(subject.directions, stage.deviceMaps()));
    for (auto _ : state) floor.run(static_cast<std::uint32_t>(subject.directions));
}

benchmark::internal::Benchmark* withStatistics(benchmark::internal::Benchmark* b, int repetitions) {
    return b->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Repetitions(repetitions)
        ->ComputeStatistics("min", [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); })
        ->ReportAggregatesOnly();
}

}  // namespace

int main(int argc, char** argv) try {
    benchmark::Initialize(&argc, argv);
    if (!test::dataFolder()) throw std::runtime_error("no test data: set NACRE_DATA");
    for (const Subject& s : kSubjects) {
        const std::string large = "large/", name = s.name;
        const bool isLarge = name.starts_with(large);
        const std::string before = isLarge ? large : "", after = isLarge ? name.substr(large.size()) : name;
        withStatistics(benchmark::RegisterBenchmark(
                           (before + "bake/" + after).c_str(),
                           [&s](benchmark::State& state) { bakeAll(state, s, OcclusionMaps::automatic); }),
                       s.repetitions)
            ->Iterations(1);
        withStatistics(benchmark::RegisterBenchmark((before + "floor/" + after).c_str(),
                                                    [&s](benchmark::State& state) { floorAlone(state, s); }),
                       s.repetitions)
            ->Iterations(3);
    }
    constexpr std::pair<const char*, OcclusionMaps> kPaths[] = {
        {"encoded", OcclusionMaps::encoded}, {"fragdepth", OcclusionMaps::fragdepth}, {"tiles", OcclusionMaps::tiles}};
    for (const Subject& s : {kSubjects[0], kSubjects[1], kSubjects[2]})
        for (const auto& [path, maps] : kPaths)
            withStatistics(
                benchmark::RegisterBenchmark((std::string("paths/") + s.name + "/" + path).c_str(),
                                             [s, maps = maps](benchmark::State& state) { bakeAll(state, s, maps); }),
                3)
                ->Iterations(1);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "occlusion_benchmark: %s\n", error.what());
    return 1;
}
