#include "engine/molecule/samples/samples.h"

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/read.h"

namespace nacre {

SampleBuilder::SampleBuilder(std::string_view title) : builder_("sample", kMaxAtoms) {
    builder_.molecule().file.format = "sample";
    builder_.molecule().file.title = title;
}

std::uint32_t SampleBuilder::atom(std::string_view name, std::string_view symbol, glm::dvec3 position) {
    Atom atom{.position = glm::vec3(position), .name = name, .element = elementFromSymbol(symbol), .hetero = hetero_};
    builder_.addAtom(atom, chain_, number_, '\0', residue_);
    return static_cast<std::uint32_t>(builder_.molecule().atoms.size() - 1);
}

Molecule SampleBuilder::finish() {
    FileSummary& file = builder_.molecule().file;
    file.models = 1;
    file.totalAtomsAllModels = static_cast<std::int64_t>(builder_.molecule().atoms.size());
    file.chains = static_cast<std::int64_t>(builder_.molecule().chains.size());
    return builder_.finish();
}

namespace {

struct Sample {
    std::string_view name;
    Molecule (*make)();
};
constexpr Sample kSamples[] = {{"dna", sampleDna}, {"glucose", sampleGlucose}, {"buckyball", sampleBuckyball}};

}  // namespace

std::vector<std::string> sampleNames() {
    std::vector<std::string> names;
    for (const Sample& sample : kSamples) names.emplace_back(sample.name);
    return names;
}

Molecule sampleMolecule(std::string_view name) {
    for (const Sample& sample : kSamples)
        if (sample.name == name) return sample.make();
    throw Error("unknown sample", std::string(name),
                "there are dna, glucose and buckyball" + suggestion(name, sampleNames()));
}

}  // namespace nacre
