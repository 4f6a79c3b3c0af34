// How fast files are read, beside gemmi's own readers of the same bytes: load_benchmark [FILE...] [Google Benchmark's
// options]; without files those of docs/measurements.md (tests/support/test_data.h says where they are looked for).
// Everything starts from inflated bytes in memory. "read" stops where gemmi does, at atoms; "load" is what the program
// does: bonds too. --benchmark_enable_random_interleaving=true lets the machine's moods meet all of them.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/formats/detect.h"
#include "engine/molecule/formats/format_table.h"
#include "tests/benchmark/gemmi_mmcif.h"
#include "tests/molecule/bcif_writer.h"
#include "tests/support/test_data.h"

namespace {

using namespace nacre;

constexpr int kRepetitions = 7;
constexpr const char* kFiles[] = {"4hhb.pdb",    "1aon-groel.pdb.gz", "1f2n-halfcapsid-hybrid36.pdb.gz",
                                  "4hhb.cif.gz", "1igy.cif.gz",       "3j6r-capsid-expanded.cif.gz",
                                  "1igy.bcif",   "4v5a-ribosome.mmtf"};

struct Input {
    std::string name, bytes;
    Format format{};
};

Input readInput(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    Input input{std::filesystem::path(path).filename().string(), {std::istreambuf_iterator<char>(file), {}}};
    constexpr std::size_t kMost = std::size_t{1} << 31;
    if (!detectCompression(input.bytes).empty()) input.bytes = decompress(path, input.bytes, kMost);
    const auto binary = detectBinaryFormat(input.bytes);
    input.format = binary ? *binary : detectFormat(path, input.bytes);
    return input;
}

Molecule readAlone(const Input& input) {
    switch (input.format) {
        case Format::pdb:
            return formatRow(Format::pdb).read(input.name, input.bytes, {});
        case Format::mmcif:
            return std::move(formatRow(Format::mmcif).readTables(input.name, input.bytes, {}, 0).front());
        case Format::bcif:
            return std::move(formatRow(Format::bcif).readTables(input.name, input.bytes, {}, 0).front());
        case Format::mmtf:
            return std::move(formatRow(Format::mmtf).readTables(input.name, input.bytes, {}, 0).front());
        default:
            throw std::runtime_error(input.name + ": no such format here");
    }
}

/// Counters: bytes and atoms per second.
template <typename Read>
void measure(const std::string& what, const Input& input, Read read) {
    benchmark::RegisterBenchmark((input.name + "/" + what).c_str(),
                                 [&input, read](benchmark::State& state) {
                                     std::size_t atoms = 0;
                                     for (auto _ : state) atoms = read(input);
                                     const auto times = static_cast<std::int64_t>(state.iterations());
                                     state.SetBytesProcessed(times * static_cast<std::int64_t>(input.bytes.size()));
                                     state.SetItemsProcessed(times * static_cast<std::int64_t>(atoms));
                                 })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(kRepetitions)
        ->ComputeStatistics("min", [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); })
        ->ComputeStatistics("max", [](const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); })
        ->ReportAggregatesOnly();
}

void measureAll(const Input& input) {
    measure("read", input, [](const Input& in) { return readAlone(in).atoms.size(); });
    measure("load", input, [](const Input& in) { return readMolecule(in.name, in.bytes).atoms.size(); });
    if (input.format == Format::pdb) measure("gemmi", input, [](const Input& in) { return test::gemmiPdb(in.bytes); });
    if (input.format == Format::mmcif)
        measure("gemmi", input, [](const Input& in) { return test::gemmiMmcif(in.bytes); });
}

}  // namespace

int main(int argc, char** argv) try {
    benchmark::Initialize(&argc, argv);
    std::vector<std::string> paths(argv + 1, argv + argc);
    if (paths.empty())
        for (const char* name : kFiles) paths.push_back(test::dataFile(name));
    std::vector<Input> inputs;
    for (const std::string& path : paths) inputs.push_back(readInput(path));
    // A million atoms of BinaryCIF: the largest mmCIF, written anew.
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (inputs[i].format == Format::mmcif && inputs[i].bytes.size() > 50'000'000)
            inputs.push_back({inputs[i].name + " as BinaryCIF", test::writeBcif(readAlone(inputs[i])), Format::bcif});
    for (const Input& input : inputs) measureAll(input);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "load_benchmark: %s\n", error.what());
    return 1;
}
