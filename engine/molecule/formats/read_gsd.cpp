// GSD (HOOMD-blue): a header, an index of chunks by frame and name, a list of names, and chunks of numbers. A frame
// that lacks a chunk uses the first frame's. Units are the simulation's.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

#include "engine/molecule/formats/lammps_types.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::uint64_t kGsdMagic = 0x65DF65DF65DF65DF;
constexpr std::size_t kGsdHeader = 256, kIndexEntry = 32, kNameEntry = 64;
constexpr std::size_t kMostGsdNames = 65'535;  // their numbers have 16 bits

constexpr std::string_view kGsdLists[] = {"particles/position", "particles/typeid", "particles/mass",
                                          "particles/charge",   "particles/types",  "particles/diameter",
                                          "bonds/group",        "configuration/box"};

struct GsdChunk {
    std::uint64_t rows = 0, columns = 0, place = 0;
    std::uint8_t type = 0;
};

class GsdReader {
public:
    /// @param first, last  frames to read, from 0
    GsdReader(const std::string& name, std::string_view bytes, const ReadOptions& options, std::uint64_t first,
              std::uint64_t last)
        : name_(name), bytes_(bytes), maxAtoms_(options.maxAtoms), first_(first), chunksOf_(last - first + 1) {
        static_assert(std::endian::native == std::endian::little, "GSD files are little-endian");
        if (bytes.size() < kGsdHeader || at<std::uint64_t>(0) != kGsdMagic) cannotRead(name, "it is not a GSD file");
        readNames(at<std::uint64_t>(24), at<std::uint64_t>(32), at<std::uint32_t>(44) >= 0x20000);
        readIndex(at<std::uint64_t>(8), at<std::uint64_t>(16));
        requireModel(name, options.model, static_cast<std::int64_t>(frames_));
    }

    Molecule read(std::uint64_t frame) {
        own_ = &chunksOf_[frame - first_];
        MoleculeBuilder builder(name_, maxAtoms_);
        const std::vector<float> positions = numbers<float>("particles/position", 3);
        const std::size_t count = positions.size() / 3;
        const std::vector<std::uint32_t> kinds = numbers<std::uint32_t>("particles/typeid", 1);
        const std::vector<float> masses = numbers<float>("particles/mass", 1),
                                 charges = numbers<float>("particles/charge", 1),
                                 diameters = numbers<float>("particles/diameter", 1);
        const std::vector<std::string> types = typeNames();
        Molecule& molecule = builder.molecule();
        LammpsTypes elements;
        for (std::size_t i = 0; i < count; ++i) {
            const auto position =
                builder.computedPosition(glm::dvec3(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]), 0);
            if (!position) continue;
            Atom atom;
            atom.position = *position;
            const std::size_t kind = i < kinds.size() ? kinds[i] : 0;
            const std::string& type = kind < types.size() ? types[kind] : unknown_;
            if (i < diameters.size() && diameters[i] > 0 && diameters[i] < 1e6f) atom.radius = diameters[i] / 2;
            builder.addAtom(atom);
            molecule.types.emplace_back(type);
            if (masses.size() == count) elements.add(Name(type).view(), static_cast<double>(masses[i]), type);
            if (charges.size() == count) molecule.partialCharges.push_back(charges[i]);
        }
        const std::vector<std::uint32_t> bonds = numbers<std::uint32_t>("bonds/group", 2);
        for (std::size_t i = 0; i + 1 < bonds.size(); i += 2)
            builder.addBond(builder.atomOfRecord(bonds[i]), builder.atomOfRecord(bonds[i + 1]), 1, 0);
        builder.state("radii", std::count_if(molecule.atoms.begin(), molecule.atoms.end(),
                                             [](const Atom& atom) { return atom.radius > 0; }));
        elements.apply(builder);
        takeBox(builder);
        for (; unread_ > 0; --unread_) builder.leaveOut("lists", "numbers of an unexpected type");
        for (const auto& entry : names_)
            if (const bool used = std::ranges::find(kGsdLists, entry.first) != std::end(kGsdLists);
                !used && chunk(entry.first))
                builder.pass("further lists");
        FileSummary& file = molecule.file;
        file.format = "gsd";
        file.models = static_cast<std::int64_t>(frames_);
        file.totalAtomsAllModels = static_cast<std::int64_t>(frames_ * count);
        if (!bonds.empty()) file.bonds = static_cast<std::int64_t>(bonds.size() / 2);
        return builder.finish();
    }

private:
    template <typename Number>
    Number at(std::uint64_t place) const {
        if (place > bytes_.size() || bytes_.size() - place < sizeof(Number)) cannotRead(name_, "it is cut short");
        Number value;
        std::memcpy(&value, bytes_.data() + place, sizeof value);
        return value;
    }
    void require(std::uint64_t place, std::uint64_t count, std::uint64_t each) const {
        if (place > bytes_.size() || count > (bytes_.size() - place) / each)
            cannotRead(name_, "it lists more than it holds");
    }

    /// In fields of 64 bytes or, from version 2 on, consecutive.
    void readNames(std::uint64_t place, std::uint64_t entries, bool packed) {
        require(place, entries, kNameEntry);
        std::string_view list = bytes_.substr(place, entries * kNameEntry);
        while (!list.empty()) {
            const std::string_view name = list.substr(0, std::min(list.find('\0'), list.size()));
            if (name.empty() || names_.size() == kMostGsdNames) break;
            names_.emplace(name, static_cast<std::uint16_t>(names_.size()));
            list.remove_prefix(std::min(packed ? name.size() + 1 : kNameEntry, list.size()));
        }
    }

    /// Entries are sorted by frame; unused ones have no position.
    void readIndex(std::uint64_t place, std::uint64_t entries) {
        require(place, entries, kIndexEntry);
        for (std::uint64_t i = 0; i < entries; ++i) {
            const std::uint64_t entry = place + i * kIndexEntry, frame = at<std::uint64_t>(entry);
            const GsdChunk chunk{at<std::uint64_t>(entry + 8), at<std::uint32_t>(entry + 24),
                                 at<std::uint64_t>(entry + 16), at<std::uint8_t>(entry + 30)};
            if (chunk.place == 0 || frame > bytes_.size()) break;
            frames_ = std::max(frames_, frame + 1);
            const auto id = at<std::uint16_t>(entry + 28);
            if (frame == 0) chunksOfFirst_[id] = chunk;
            if (frame >= first_ && frame - first_ < chunksOf_.size()) chunksOf_[frame - first_][id] = chunk;
        }
    }

    const GsdChunk* chunk(std::string_view name) const {
        const auto id = names_.find(name);
        if (id == names_.end()) return nullptr;
        if (const auto found = own_->find(id->second); found != own_->end()) return &found->second;
        const auto found = chunksOfFirst_.find(id->second);
        return found == chunksOfFirst_.end() ? nullptr : &found->second;
    }

    /// Numbers of a chunk with as many columns, of four bytes each; empty if there is no such chunk.
    template <typename Number>
    std::vector<Number> numbers(std::string_view name, std::uint64_t columns) const {
        constexpr std::uint8_t kUnsigned = 3, kSigned = 7, kReal = 9;
        const GsdChunk* found = chunk(name);
        if (!found || found->rows == 0) return {};
        // Python writes bond pairs as signed numbers.
        const bool fits = std::is_floating_point_v<Number> ? found->type == kReal
                                                           : found->type == kUnsigned || found->type == kSigned;
        if (found->columns != columns || !fits) {
            ++unread_;
            return {};
        }
        require(found->place, found->rows, columns * sizeof(Number));
        if (found->rows > MoleculeBuilder::kMostBondsPerAtom * maxAtoms_) throw tooManyAtoms(name_, maxAtoms_);
        std::vector<Number> values(found->rows * columns);
        std::memcpy(values.data(), bytes_.data() + found->place, values.size() * sizeof(Number));
        return values;
    }

    /// Rows of characters, padded with zeros.
    std::vector<std::string> typeNames() const {
        std::vector<std::string> types;
        const GsdChunk* found = chunk("particles/types");
        if (!found || found->columns == 0) return {"A"};
        require(found->place, found->rows, found->columns);
        if (found->rows > kMostGsdNames) cannotRead(name_, "it has more types than " + std::to_string(kMostGsdNames));
        for (std::uint64_t i = 0; i < found->rows; ++i) {
            const std::string_view row = bytes_.substr(found->place + i * found->columns, found->columns);
            types.emplace_back(row.substr(0, row.find('\0')));
        }
        return types;
    }

    /// Lengths, and tilts as fractions of them. The box's middle is the origin.
    void takeBox(MoleculeBuilder& builder) const {
        const std::vector<float> b = numbers<float>("configuration/box", 1);
        if (b.size() != 6) return;
        for (const float number : b)
            if (!(std::abs(static_cast<double>(number)) <= kFarthestCoordinate)) return;
        const std::array box{glm::vec3(b[0], 0, 0), glm::vec3(b[3] * b[1], b[1], 0),
                             glm::vec3(b[4] * b[2], b[5] * b[2], b[2])};
        builder.takeBox(box, (box[0] + box[1] + box[2]) / -2.0f);
    }

    const std::string& name_;
    std::string_view bytes_;
    std::size_t maxAtoms_;
    std::uint64_t first_, frames_ = 0;
    std::map<std::string, std::uint16_t, std::less<>> names_;
    using Chunks = std::map<std::uint16_t, GsdChunk>;
    Chunks chunksOfFirst_;
    std::vector<Chunks> chunksOf_;  ///< by frame to read
    const Chunks* own_ = nullptr;   ///< of the current frame
    mutable int unread_ = 0;        ///< chunks of that frame
    const std::string unknown_ = "?";
};

}  // namespace

std::vector<Molecule> readGsd(const std::string& name, std::string_view bytes, const ReadOptions& options,
                              int lastModel) {
    const auto first = static_cast<std::uint64_t>(options.model - 1);
    const auto last = static_cast<std::uint64_t>(std::max(options.model, lastModel) - 1);
    GsdReader reader(name, bytes, options, first, last);
    std::vector<Molecule> frames;
    for (std::uint64_t frame = first; frame <= last; ++frame) frames.push_back(reader.read(frame));
    return frames;
}

}  // namespace nacre
