// H5MD and MDTraj's HDF5 as structures: every frame is a model. H5MD states species, masses, charges and connectivity;
// MDTraj a topology in JSON.
#include <vector>

#include "engine/molecule/formats/lammps_types.h"
#include "engine/molecule/text.h"

#ifdef NACRE_HDF5
#include <cmath>
#include <set>

#include "engine/molecule/element.h"
#include "engine/molecule/formats/id_index.h"
#include "engine/molecule/formats/json_text.h"
#include "engine/molecule/trajectory/h5md_data.h"

namespace nacre {
namespace {

constexpr std::size_t kMostH5Bytes = std::size_t{512} << 20;  // the library holds a copy
constexpr std::size_t kMostTopologyBytes = std::size_t{256} << 20;

/// Data of an atom common to all frames.
struct H5Atom {
    std::string name, residue, segment;
    std::int32_t number = 1;
    std::uint32_t chain = 0;
    Element element = 0;
};
struct H5Bond {
    std::int64_t a, b;
};

/// A number per atom: constant, or one per frame. Constant ones are read once.
class H5Values {
public:
    H5Values() = default;
    H5Values(Hdf5Handle set, std::size_t count)
        : set_(std::move(set)), count_(count), framed_(set_.valid() && H5mdData::readSizes(set_).size() > 1) {
        if (!framed_) values_ = H5mdData::readValues(set_, 0, count_);
    }
    /// Empty if there are none.
    const std::vector<double>& at(std::size_t frame) {
        if (framed_) values_ = H5mdData::readValues(set_, frame, count_);
        return values_;
    }
    const Hdf5Handle& set() const { return set_; }

private:
    Hdf5Handle set_;
    std::size_t count_ = 0;
    bool framed_ = false;
    std::vector<double> values_;
};

class H5mdReader {
public:
    H5mdReader(const std::string& name, std::string_view bytes, const ReadOptions& options)
        : name_(name), options_(options), data_(H5mdData::ofBytes(bytes)) {
        count_ = static_cast<std::size_t>(data_.atoms());
        if (count_ == 0) cannotRead(name, "it has no atoms");
        if (count_ > options.maxAtoms) throw tooManyAtoms(name, options.maxAtoms);
        if (data_.frames() > bytes.size()) cannotRead(name, "it states more frames than it holds");
        if (data_.group().empty())
            readTopology();
        else
            readSpecies();
    }

    Molecule read(std::int64_t model) {
        MoleculeBuilder builder(name_, options_.maxAtoms);
        const auto frame = static_cast<std::size_t>(model - 1);
        TrajectoryFrame places;
        places.positions.resize(count_);
        if (!data_.read(frame, places)) cannotRead(name_, "frame " + std::to_string(model) + " is damaged");
        if (atoms_.empty())
            addParticles(builder, frame, places);
        else
            addAtoms(builder, places);
        for (const H5Bond& bond : bonds_)
            builder.addBond(builder.atomOfRecord(bond.a), builder.atomOfRecord(bond.b), 1, 0);
        if (types_) types_->apply(builder);
        if (places.box) builder.takeBox(*places.box);
        builder.molecule().file.boxRepeats = data_.repeats();
        FileSummary& file = builder.molecule().file;
        file.format = "h5md";
        file.models = frames();
        file.totalAtomsAllModels = frames() * static_cast<std::int64_t>(count_);
        if (!bonds_.empty()) file.bonds = static_cast<std::int64_t>(bonds_.size());
        return builder.finish();
    }

    std::int64_t frames() const {
        return static_cast<std::int64_t>(std::min<std::uint64_t>(data_.frames(), INT32_MAX));
    }

private:
    /// For H5MD. Species have names, masses that imply elements, or are kinds of grains.
    void addParticles(MoleculeBuilder& builder, std::size_t frame, const TrajectoryFrame& places) {
        const std::vector<double>&kinds = species_.at(frame), &masses = masses_.at(frame),
              &charges = charges_.at(frame);
        for (const char* items : passed_) builder.pass(items, static_cast<std::int64_t>(count_));
        const bool numbers = labels_.empty() && names_.empty() && masses.empty() && areAtomicNumbers(kinds);
        if (numbers) builder.guess("elements", "from numbers of species", static_cast<std::int64_t>(count_));
        types_.emplace();
        for (std::size_t i = 0; i < count_; ++i) {
            const auto position = builder.computedPosition(glm::dvec3(places.positions[i]), 0);
            if (!position) continue;
            Atom atom;
            atom.position = *position;
            std::string type = labels_.empty() ? "1" : labels_[i];
            std::string label = type;
            if (labels_.empty() && !kinds.empty()) {
                const auto named = names_.find(kinds[i]);
                type = std::to_string(static_cast<std::int64_t>(std::clamp(kinds[i], -1e15, 1e15)));
                label = named == names_.end() ? "" : named->second;
            } else if (labels_.empty()) {
                label.clear();
            }
            atom.element = numbers         ? static_cast<Element>(kinds[i])
                           : label.empty() ? Element{0}
                                           : elementFromSymbol(label);
            builder.addAtom(atom);
            builder.molecule().types.emplace_back(type);
            if (!masses.empty()) types_->add(Name(type).view(), masses[i], label);
            if (!charges.empty()) builder.molecule().partialCharges.push_back(usable(charges[i]));
        }
    }

    /// Species are numbered from 0 or 1 on, unless they are atomic numbers.
    static bool areAtomicNumbers(const std::vector<double>& kinds) {
        constexpr int kMost = 118;
        std::set<int> distinct;
        for (const double kind : kinds) {
            if (!(kind >= 1 && kind <= kMost) || kind != std::floor(kind)) return false;
            distinct.insert(static_cast<int>(kind));
        }
        return !distinct.empty() && *distinct.rbegin() > static_cast<int>(distinct.size());
    }

    static float usable(double value) { return std::abs(value) <= 1e6 ? static_cast<float>(value) : 0.0f; }

    void readSpecies() {
        const std::string& group = data_.group();
        species_ = H5Values(data_.element(group + "/species"), count_);
        masses_ = H5Values(data_.element(group + "/mass"), count_);
        charges_ = H5Values(data_.element(group + "/charge"), count_);
        for (const auto& [list, items] : {std::pair("/velocity", "velocities"), std::pair("/force", "forces")})
            if (data_.element(group + list).valid()) passed_.push_back(items);
        names_ = H5mdData::readEnumeration(species_.set());
        labels_ = data_.readTexts(data_.element(group + "/species_label"), count_, kMostTopologyBytes);
        readConnectivity();
    }

    void readConnectivity() {
        const Hdf5Handle pairs = data_.element("connectivity/bonds");
        const Hdf5Sizes sizes = pairs.valid() ? H5mdData::readSizes(pairs) : Hdf5Sizes();
        const std::size_t rank = sizes.size();
        if (rank < 2 || sizes[rank - 1] != 2 || sizes[rank - 2] > MoleculeBuilder::kMostBondsPerAtom * count_) return;
        const std::vector<double> ends = H5mdData::readNumbers(pairs, 0, 2 * sizes[rank - 2], rank == 3);
        std::vector<std::int64_t> ids;
        for (const double id : H5mdData::readValues(data_.element(data_.group() + "/id"), 0, count_))
            ids.push_back(static_cast<std::int64_t>(std::clamp(id, -1e15, 1e15)));
        const IdIndex index(ids);
        const auto findAtom = [&](double given) {
            const auto id = static_cast<std::int64_t>(std::clamp(given, -1e15, 1e15));
            if (ids.empty()) return id;
            std::uint32_t atom = 0;
            return index.find(id, atom) == IdIndex::Found::one ? std::int64_t{atom} : std::int64_t{-1};
        };
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
            bonds_.push_back({findAtom(ends[i]), findAtom(ends[i + 1])});
    }

    void addAtoms(MoleculeBuilder& builder, const TrajectoryFrame& places) const {
        for (std::size_t i = 0; i < count_; ++i) {
            const H5Atom& stated = atoms_[i];
            const auto position = builder.computedPosition(glm::dvec3(places.positions[i]), 0);
            if (!position) continue;
            Atom atom{.position = *position, .name = Name(stated.name), .element = stated.element};
            builder.addAtom(atom, chainName(stated.chain), stated.number, '\0', stated.residue);
            builder.molecule().residues.back().segment = Name(stated.segment);
        }
    }
    /// MDTraj's chains have only numbers: named A, B, ..., then by number.
    static std::string chainName(std::uint32_t chain) {
        return chain < 26 ? std::string(1, static_cast<char>('A' + chain)) : std::to_string(chain + 1);
    }

    void readTopology() {
        const std::vector<std::string> texts = data_.readTexts(data_.dataset("topology"), 1, kMostTopologyBytes);
        if (texts.empty()) cannotRead(name_, "it has no topology: give a structure, and this file as --trajectory");
        JsonWalk walk(name_, texts[0]);
        walk.object([&](const std::string& key) {
            if (key == "chains")
                visitArray(walk, [&] { readChain(walk); });
            else if (key == "bonds")
                visitArray(walk, [&] { readBond(walk); });
            else
                walk.skip();
        });
        if (atoms_.size() != count_)
            cannotRead(name_, "its topology has " + std::to_string(atoms_.size()) + " atoms, its frames " +
                                  std::to_string(count_));
    }

    template <typename Visit>
    static void visitArray(JsonWalk& walk, const Visit& visit) {
        walk.expect('[');
        if (walk.accept(']')) return;
        do visit();
        while (walk.accept(','));
        walk.expect(']');
    }

    void readChain(JsonWalk& walk) {
        walk.object([&](const std::string& key) {
            if (key == "residues")
                visitArray(walk, [&] { readResidue(walk); });
            else
                walk.skip();
        });
        ++chains_;
    }

    /// A residue's name and number may follow its atoms.
    void readResidue(JsonWalk& walk) {
        const std::size_t first = atoms_.size();
        std::string buffer, name, segment;
        std::int64_t number = 1;
        walk.object([&](const std::string& key) {
            if (key == "atoms")
                visitArray(walk, [&] { readAtom(walk); });
            else if (key == "name")
                name = walk.string(buffer);
            else if (key == "segmentID" && walk.peek() == '"')
                segment = walk.string(buffer);
            else if (key == "resSeq" && walk.peek() != 'n')
                number = parseInteger(walk.number()).value_or(1);
            else
                walk.skip();
        });
        for (std::size_t i = first; i < atoms_.size(); ++i) {
            atoms_[i].residue = Name(name).view();
            atoms_[i].segment = Name(segment).view();
            atoms_[i].number = static_cast<std::int32_t>(std::clamp<std::int64_t>(number, INT32_MIN, INT32_MAX));
            atoms_[i].chain = chains_;
        }
    }

    void readAtom(JsonWalk& walk) {
        if (atoms_.size() == count_) cannotRead(name_, "its topology has more atoms than its frames");
        H5Atom& atom = atoms_.emplace_back();
        std::string buffer;
        walk.object([&](const std::string& key) {
            if (key == "name")
                atom.name = Name(walk.string(buffer)).view();
            else if (key == "element" && walk.peek() == '"')
                atom.element = elementFromSymbol(walk.string(buffer));
            else
                walk.skip();
        });
    }

    /// Two atoms, possibly with a type and an order.
    void readBond(JsonWalk& walk) {
        std::array<std::int64_t, 2> ends{-1, -1};
        std::size_t place = 0;
        visitArray(walk, [&] {
            if (place < ends.size())
                ends[place++] = parseInteger(walk.number()).value_or(-1);
            else
                walk.skip();
        });
        if (bonds_.size() < MoleculeBuilder::kMostBondsPerAtom * count_) bonds_.push_back({ends[0], ends[1]});
    }

    const std::string& name_;
    const ReadOptions& options_;
    H5mdData data_;
    std::size_t count_ = 0;
    H5Values species_, masses_, charges_;
    std::vector<const char*> passed_;  ///< what each particle has that is not read
    std::vector<H5Atom> atoms_;        ///< MDTraj's
    std::vector<H5Bond> bonds_;
    std::map<double, std::string> names_;  ///< of H5MD's species
    std::vector<std::string> labels_;      ///< of its particles
    std::optional<LammpsTypes> types_;
    std::uint32_t chains_ = 0;
};

}  // namespace

std::vector<Molecule> readH5md(const std::string& name, std::string_view bytes, const ReadOptions& options,
                               int lastModel) {
    if (options.uploaded) cannotRead(name, "the server reads no HDF5");
    if (bytes.size() > kMostH5Bytes)
        cannotRead(name, "HDF5 files above 512 MiB are read as --trajectory of a structure");
    const Hdf5Lock lock;
    try {
        H5mdReader reader(name, bytes, options);
        requireModel(name, options.model, reader.frames());
        std::vector<Molecule> models;
        for (std::int64_t model = options.model; model <= std::max(options.model, lastModel); ++model)
            models.push_back(reader.read(model));
        return models;
    } catch (const Hdf5Fault& fault) {
        cannotRead(name, fault.what());
    }
}

}  // namespace nacre

#else

namespace nacre {

std::vector<Molecule> readH5md(const std::string& name, std::string_view, const ReadOptions&, int) {
    cannotRead(name, "it is HDF5, which this program was built without");
}

}  // namespace nacre

#endif
