#include "app/python/pickled.h"

#include <xxhash.h>

#include <cstring>
#include <type_traits>
#include <utility>

#include "engine/error.h"

namespace nacre::python {
namespace {

/// Header of the bytes. Sizes identify the layout of structures copied from memory.
std::string heading() {
    std::string text = "nacre molecule " NACRE_VERSION;
    for (const std::size_t size : {sizeof(Atom), sizeof(Residue), sizeof(Bond), sizeof(Molecule)})
        text += " " + std::to_string(size);
    return text;
}

std::uint64_t hashBytes(std::string_view bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

class Writer {
public:
    template <typename T>
    void plain(const T& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <typename T>
    void plains(const std::vector<T>& list) {
        plain(std::uint64_t{list.size()});
        bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
    }
    void text(const std::string& value) {
        plain(std::uint64_t{value.size()});
        bytes += value;
    }
    template <typename T, typename Each>
    void list(const std::vector<T>& values, Each&& each) {
        plain(std::uint64_t{values.size()});
        for (const T& value : values) each(value);
    }
    std::string bytes;
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    template <typename T>
    void plain(T& value) {
        std::memcpy(&value, take(sizeof value), sizeof value);
    }
    template <typename T>
    void plains(std::vector<T>& list) {
        list.resize(count(sizeof(T)));
        if (!list.empty())
            std::memcpy(static_cast<void*>(list.data()), take(list.size() * sizeof(T)), list.size() * sizeof(T));
    }
    void text(std::string& value) {
        const std::size_t size = count(1);
        value.assign(take(size), size);
    }
    template <typename T, typename Each>
    void list(std::vector<T>& values, Each&& each) {
        values.resize(count(1));
        for (T& value : values) each(value);
    }
    bool atEnd() const { return rest_.empty(); }

private:
    const char* take(std::size_t size) {
        if (size > rest_.size()) fail();
        const char* const at = rest_.data();
        rest_.remove_prefix(size);
        return at;
    }
    /// Length of a list, limited by the available bytes, so that invalid data cannot request more memory.
    std::size_t count(std::size_t each) {
        std::uint64_t n = 0;
        plain(n);
        if (n > rest_.size() / each) fail();
        return static_cast<std::size_t>(n);
    }
    [[noreturn]] static void fail() { throw Error("cannot unpickle", "a structure", "its bytes are damaged"); }

    std::string_view rest_;
};

template <typename Archive, typename Maybe>
void maybe(Archive& archive, Maybe& value) {
    bool there = value.has_value();
    archive.plain(there);
    if constexpr (!std::is_const_v<Maybe>)
        if (there) value.emplace();
    if (there) archive.plain(*value);
}

template <typename Archive, typename Names>
void names(Archive& archive, Names& all) {
    std::vector<std::pair<std::string, std::string>> pairs(all.begin(), all.end());
    archive.list(pairs, [&](auto& pair) {
        archive.text(pair.first);
        archive.text(pair.second);
    });
    if constexpr (!std::is_const_v<Names>) all = {pairs.begin(), pairs.end()};
}

template <typename Archive, typename Parts>
void parts(Archive& archive, Parts& all) {
    archive.list(all, [&](auto& part) {
        archive.plains(part.transforms);
        archive.plains(part.subchains);
    });
}

/// Reads or writes, as all().
template <typename Archive, typename File>
void summary(Archive& archive, File& file) {
    auto& [format, title, models, records, totalAtomsAllModels, totalAtomsAllRecords, totalBondsAllRecords, stated,
           bondsAllModels, conectUniquePairs, itsChains, chainsAuth, chainsLabel, biomtOperators, itsAssemblies,
           operators, resolution, organism, method, chainNames, componentNames, confidence, box, boxOrigin, boxRepeats,
           cell, spaceGroup, packed, entityNames] = file;
    archive.text(format);
    archive.text(title);
    archive.text(organism);
    archive.text(method);
    names(archive, chainNames);
    names(archive, componentNames);
    for (auto* number : {&models, &records, &totalAtomsAllModels, &totalAtomsAllRecords, &totalBondsAllRecords, &stated,
                         &bondsAllModels, &conectUniquePairs, &itsChains, &chainsAuth, &chainsLabel, &biomtOperators,
                         &itsAssemblies, &operators})
        maybe(archive, *number);
    maybe(archive, resolution);
    archive.plain(confidence);
    maybe(archive, box);
    archive.plain(boxOrigin);
    archive.plain(boxRepeats);
    maybe(archive, cell);
    archive.text(spaceGroup);
    archive.text(packed);
    names(archive, entityNames);
}

/// Reads or writes all members. The bindings name every member: a new member does not compile until it is added here.
template <typename Archive, typename M>
void all(Archive& archive, M& molecule) {
    auto& [atoms, residues, chains, subchains, bonds, assemblies, entities, statesSecondaryStructure, partialCharges,
           radii, masses, displacements, types, serials, warnings, notes, lacksPositions, modelsAreInputs, inputs,
           inputFiles, others, othersMissing, file, guide] = molecule;
    const auto texts = [&](auto& list) { archive.list(list, [&](auto& text) { archive.text(text); }); };
    archive.plains(atoms);
    archive.plains(residues);
    archive.list(chains, [&](auto& chain) {
        auto& [name, model] = chain;
        archive.text(name);
        archive.plain(model);
    });
    texts(subchains);
    archive.plains(bonds);
    archive.list(assemblies, [&](auto& assembly) {
        auto& [id, details, itsParts] = assembly;
        archive.text(id);
        archive.text(details);
        parts(archive, itsParts);
    });
    texts(entities);
    archive.plain(statesSecondaryStructure);
    archive.plains(partialCharges);
    archive.plains(radii);
    archive.plains(masses);
    archive.plains(displacements);
    archive.plains(types);
    archive.plains(serials);
    texts(warnings);
    archive.list(notes, [&](auto& note) {
        archive.plain(note.action);
        archive.text(note.what);
        archive.text(note.why);
        archive.plain(note.count);
        archive.plain(note.line);
    });
    archive.plain(lacksPositions);
    archive.plain(modelsAreInputs);
    texts(inputs);
    archive.text(othersMissing);
    summary(archive, file);
    archive.list(inputFiles, [&](auto& each) { summary(archive, each); });
    static_cast<void>(others);  // through its functions, below
}

static_assert(std::is_trivially_copyable_v<Atom> && std::is_trivially_copyable_v<Residue> &&
              std::is_trivially_copyable_v<Bond>);

void write(Writer& writer, const Molecule& molecule) {
    all(writer, molecule);
    writer.plain(std::uint64_t{molecule.others.size()});
    for (std::size_t i = 0; i < molecule.others.size(); ++i) {
        const OtherModel other = molecule.others[i];
        writer.plains(other.positions);
        writer.plain(other.whole != nullptr);
        if (other.whole) write(writer, *other.whole);
    }
}

Molecule read(Reader& reader, bool whole) {
    Molecule molecule;
    all(reader, molecule);
    std::uint64_t others = 0;
    reader.plain(others);
    if (others > 0 && !whole) throw Error("cannot unpickle", "a structure", "its bytes are damaged");
    for (std::uint64_t i = 0; i < others; ++i) {
        OtherModel other;
        bool hasAtoms = false;
        reader.plains(other.positions);
        reader.plain(hasAtoms);
        if (hasAtoms) other.whole = std::make_shared<const Molecule>(read(reader, false));
        molecule.others.add(std::move(other));
    }
    return molecule;
}

}  // namespace

std::string pickled(const Molecule& molecule) {
    if (molecule.guide) throw Error("cannot pickle", "a scene", "pickle the path of its file");
    Writer writer;
    writer.text(heading());
    write(writer, molecule);
    writer.plain(hashBytes(writer.bytes));
    return std::move(writer.bytes);
}

Molecule unpickled(std::string_view bytes) {
    std::uint64_t hash = 0;
    if (bytes.size() < sizeof hash) throw Error("cannot unpickle", "a structure", "its bytes are damaged");
    const std::string_view whole = bytes.substr(0, bytes.size() - sizeof hash);
    std::memcpy(&hash, whole.data() + whole.size(), sizeof hash);
    Reader reader(whole);
    std::string begin;
    reader.text(begin);
    if (begin != heading()) throw Error("cannot unpickle", "a structure", "another version of nacre pickled it");
    if (hash != hashBytes(whole)) throw Error("cannot unpickle", "a structure", "its bytes are damaged");
    return read(reader, true);
}

}  // namespace nacre::python
