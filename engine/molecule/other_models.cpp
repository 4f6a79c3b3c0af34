#include "engine/molecule/other_models.h"

#include <algorithm>
#include <utility>

#include "engine/molecule/assemblies.h"
#include "engine/molecule/byte_file.h"
#include "engine/molecule/molecule.h"

namespace nacre {
namespace {

// Part of the 700 bytes per atom of memory_bound.h.
constexpr std::size_t kBytesPerAtom = 48;

/// Whether two molecules are equal except for atom positions.
bool sameButForPlaces(const Molecule& a, const Molecule& b) {
    const auto sameAtom = [](const Atom& x, const Atom& y) {
        return x.element == y.element && x.residue == y.residue && x.name == y.name && x.alternate == y.alternate &&
               x.hetero == y.hetero && x.occupancy == y.occupancy && x.temperatureFactor == y.temperatureFactor;
    };
    const auto sameResidue = [](const Residue& x, const Residue& y) {
        return x.name == y.name && x.number == y.number && x.insertionCode == y.insertionCode && x.chain == y.chain &&
               x.subchain == y.subchain && x.firstAtom == y.firstAtom && x.secondary == y.secondary &&
               x.entity == y.entity && x.entityKind == y.entityKind;
    };
    const auto sameChain = [](const Chain& x, const Chain& y) { return x.name == y.name; };
    return std::equal(a.atoms.begin(), a.atoms.end(), b.atoms.begin(), b.atoms.end(), sameAtom) &&
           std::equal(a.residues.begin(), a.residues.end(), b.residues.begin(), b.residues.end(), sameResidue) &&
           std::equal(a.chains.begin(), a.chains.end(), b.chains.begin(), b.chains.end(), sameChain) &&
           a.subchains == b.subchains;
}

/// The records of a file (SDF, MOL2) may be poses of one molecule, or different molecules.
bool sameElements(const Molecule& a, const Molecule& b) {
    return std::equal(a.atoms.begin(), a.atoms.end(), b.atoms.begin(), b.atoms.end(),
                      [](const Atom& x, const Atom& y) { return x.element == y.element; });
}

}  // namespace

struct OtherModels::Store {
    struct Place {
        OtherModel held;        ///< empty if it is in the file
        std::uint64_t at = 0;   ///< in the file
        std::size_t atoms = 0;  ///< number of these positions
        bool inFile = false;
    };
    std::vector<Place> places;
    std::size_t heldBytes = 0;
    std::shared_ptr<ByteFile> file;
    bool noFile = false;
};

std::size_t OtherModels::size() const { return store_ ? store_->places.size() : 0; }

OtherModel OtherModels::operator[](std::size_t i) const {
    const Store::Place& place = store_->places[i];
    if (!place.inFile) return place.held;
    OtherModel other;
    other.positions.resize(place.atoms);
    store_->file->read(place.at, other.positions.data(), place.atoms * sizeof(glm::vec3));
    return other;
}

bool OtherModels::allMove(std::size_t atoms) const {
    return !empty() && std::all_of(store_->places.begin(), store_->places.end(), [&](const Store::Place& place) {
        return !place.held.whole && place.atoms == atoms;
    });
}

std::size_t OtherModels::add(OtherModel other, std::size_t mostHeld) {
    if (!store_) store_ = std::make_shared<Store>();
    Store& store = *store_;
    Store::Place place;
    place.atoms = other.positions.size();
    const std::size_t bytes = place.atoms * sizeof(glm::vec3);
    const bool much = !other.whole && store.heldBytes + bytes > mostHeld && !store.noFile;
    if (much && !store.file) store.file = ByteFile::temporary();
    if (much && store.file) place.at = store.file->size();
    place.inFile = much && store.file && store.file->append(other.positions.data(), bytes);
    store.noFile = much && !place.inFile;  // no disk space: kept in memory, up to the reader's limit
    if (!place.inFile) {
        store.heldBytes += bytes;
        place.held = std::move(other);
    }
    store.places.push_back(std::move(place));
    return store.places.back().inFile ? 0 : bytes;
}

OtherModelCollector::OtherModelCollector(Molecule& own, std::size_t maxAtoms)
    : own_(own), mostBytes_(kBytesPerAtom * maxAtoms) {}

void OtherModelCollector::add(Molecule model) {
    OtherModel other;
    if (sameButForPlaces(own_, model)) {
        other.positions.reserve(model.atoms.size());
        for (const Atom& atom : model.atoms) other.positions.push_back(atom.position);
    } else if (own_.file.records && !sameElements(own_, model)) {
        own_.others.clear();  // different molecules: they share no camera
        wanted_ = false;
        return;
    } else {
        bytes_ += model.atoms.size() * sizeof(Atom) + model.residues.size() * sizeof(Residue);
        Molecule whole;
        whole.atoms = std::move(model.atoms);
        whole.residues = std::move(model.residues);
        whole.chains = std::move(model.chains);
        whole.subchains = std::move(model.subchains);
        whole.entities = std::move(model.entities);
        whole.statesSecondaryStructure = model.statesSecondaryStructure;
        other.whole = std::make_shared<const Molecule>(std::move(whole));
    }
    bytes_ += own_.others.add(std::move(other), std::min(mostBytes_, OtherModels::kMostHeld));
    if (bytes_ > mostBytes_) {
        own_.others.clear();
        own_.othersMissing = "all models together have too many atoms";
        wanted_ = false;
    }
}

void place(const Molecule& molecule, const OtherModel& other, Molecule& placed) {
    if (other.whole) {
        placed = *other.whole;
        if (!molecule.assemblies.empty()) placed.assemblies = assembliesFor(placed, molecule);
        return;
    }
    // Copies everything except the other models and large data that does not depend on positions.
    placed.atoms = molecule.atoms;
    placed.residues = molecule.residues;
    placed.chains = molecule.chains;
    placed.subchains = molecule.subchains;
    placed.entities = molecule.entities;
    placed.assemblies = molecule.assemblies;
    placed.statesSecondaryStructure = molecule.statesSecondaryStructure;
    for (std::size_t i = 0; i < other.positions.size(); ++i) placed.atoms[i].position = other.positions[i];
}

}  // namespace nacre
