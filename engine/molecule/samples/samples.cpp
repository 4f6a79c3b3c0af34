#include "engine/molecule/samples/samples.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/read.h"

namespace nacre {

SampleBuilder::SampleBuilder(std::string_view title) {
    molecule_.file.format = "sample";
    molecule_.file.title = title;
}

void SampleBuilder::chain(std::string_view name) { molecule_.chains.push_back({std::string(name)}); }

void SampleBuilder::residue(std::string_view name, std::int32_t number, bool hetero) {
    Residue residue;
    residue.name = name;
    residue.number = number;
    residue.chain = static_cast<std::uint32_t>(molecule_.chains.size() - 1);
    residue.firstAtom = static_cast<std::uint32_t>(molecule_.atoms.size());
    molecule_.residues.push_back(residue);
    hetero_ = hetero;
}

std::uint32_t SampleBuilder::atom(std::string_view name, std::string_view symbol, glm::dvec3 position) {
    Atom atom;
    atom.position = glm::vec3(position);
    atom.residue = static_cast<std::uint32_t>(molecule_.residues.size() - 1);
    atom.name = name;
    atom.element = elementFromSymbol(symbol);
    atom.hetero = hetero_;
    molecule_.atoms.push_back(atom);
    ++molecule_.residues.back().atomCount;
    return static_cast<std::uint32_t>(molecule_.atoms.size() - 1);
}

void SampleBuilder::bond(std::uint32_t a, std::uint32_t b, std::uint8_t order) {
    molecule_.bonds.push_back({std::min(a, b), std::max(a, b), order, BondSource::file});
}

Molecule SampleBuilder::finish() {
    std::sort(molecule_.bonds.begin(), molecule_.bonds.end(),
              [](const Bond& l, const Bond& r) { return std::tie(l.a, l.b) < std::tie(r.a, r.b); });
    molecule_.file.models = 1;
    molecule_.file.totalAtomsAllModels = static_cast<std::int64_t>(molecule_.atoms.size());
    molecule_.file.chains = static_cast<std::int64_t>(molecule_.chains.size());
    return std::move(molecule_);
}

Molecule sampleMolecule(std::string_view name) {
    if (name == "dna") return sampleDna();
    if (name == "glucose") return sampleGlucose();
    if (name == "buckyball") return sampleBuckyball();
    throw Error("unknown sample", std::string(name), "there are dna, glucose and buckyball");
}

}  // namespace nacre
