// MMTF, version 1: arrays over all models, chains, residues and atoms; the counts of one level nest the next.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <tuple>

#include "engine/molecule/assemblies.h"
#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/formats/mmtf_fields.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/read.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

using Kind = MsgpackValue::Kind;

constexpr const char* kPositions[3] = {"xCoordList", "yCoordList", "zCoordList"};

/// A type of residues: each is stored once, and its residues refer to it.
struct MmtfGroup {
    struct Bond {
        std::uint32_t a, b;  ///< different indices into atoms
        std::uint8_t order;
    };
    std::string name;
    std::vector<Atom> atoms;  ///< name, element, charge and hetero are set
    std::vector<Bond> bonds;  ///< no pair twice
};

constexpr std::size_t kMaxGroups = 100'000;       // the dictionary of residues has some 45,000 entries
constexpr std::size_t kFewAtomsOfGroup = 10'000;  // of all groups; always allowed
constexpr std::size_t kMaxBondsPerAtom = 16;

/// Order for Molecule. MMTF also has quadruple bonds, and -1 for unknown orders.
std::uint8_t mmtfBondOrder(std::int64_t order) {
    return static_cast<std::uint8_t>(std::clamp<std::int64_t>(order, 1, 3));
}

class GroupReader {
public:
    GroupReader(const MmtfFields& fields, MoleculeBuilder& builder, const MsgpackValue& group)
        : fields_(fields), builder_(builder), map_(group) {}

    /// @param room  maximum number of atoms
    MmtfGroup read(std::size_t room) {
        MmtfGroup group;
        const auto name = map_.find("groupName");
        group.name = std::string(name ? name->asText().value_or("") : "");
        readAtoms(group, room);
        readBonds(group);
        return group;
    }

private:
    [[noreturn]] void fail(const std::string& why) const { fields_.fail("a group of groupList is malformed: " + why); }

    MsgpackValue list(const char* field) const {
        const auto value = map_.find(field);
        if (!value || value->is(Kind::nothing)) return {};
        if (!value->is(Kind::array)) fail(std::string(field) + " is not an array");
        return *value;
    }

    void readAtoms(MmtfGroup& group, std::size_t room) const {
        const MsgpackValue names = list("atomNameList"), elements = list("elementList"),
                           charges = list("formalChargeList");
        if (elements.count != names.count || (charges.count != 0 && charges.count != names.count))
            fail("its lists of atoms differ in length");
        if (names.count > room) fail("the groups have more atoms than there is memory for");
        MsgpackElements name(names), element(elements), charge(charges);
        // MMTF does not store the difference between ATOM and HETATM: it is that between standard residues and others.
        const bool hetero = residueTemplate(Name(group.name)) == nullptr || group.name == "MSE";
        MsgpackValue value;
        for (std::uint32_t i = 0; i < names.count; ++i) {
            Atom atom;
            atom.hetero = hetero;
            name.next(value);
            atom.name = Name(value.asText().value_or(""));
            element.next(value);
            atom.element = builder_.element(value.asText().value_or(""), 0);
            const auto units = charge.next(value) ? value.asInteger() : std::nullopt;
            if (units && *units >= -20 && *units <= 20) atom.charge = static_cast<std::int8_t>(*units);
            group.atoms.push_back(atom);
        }
    }

    void readBonds(MmtfGroup& group) const {
        const MsgpackValue pairs = list("bondAtomList"), orders = list("bondOrderList");
        if (pairs.count % 2 != 0 || (orders.count != 0 && orders.count != pairs.count / 2))
            fail("its lists of bonds differ in length");
        if (pairs.count / 2 > kMaxBondsPerAtom * group.atoms.size()) fail("more bonds than its atoms could form");
        MsgpackElements ends(pairs), order(orders);
        MsgpackValue first, second, units;
        while (ends.next(first) && ends.next(second)) {
            const auto a = first.asInteger(), b = second.asInteger();
            const auto atoms = static_cast<std::int64_t>(group.atoms.size());
            if (!a || !b || *a < 0 || *b < 0 || *a >= atoms || *b >= atoms || *a == *b)
                fail("a bond to an atom that is not there");
            const std::int64_t steps = order.next(units) ? units.asInteger().value_or(1) : 1;
            group.bonds.push_back({static_cast<std::uint32_t>(std::min(*a, *b)),
                                   static_cast<std::uint32_t>(std::max(*a, *b)), mmtfBondOrder(steps)});
        }
        const auto key = [](const MmtfGroup::Bond& bond) { return std::tie(bond.a, bond.b); };
        std::stable_sort(group.bonds.begin(), group.bonds.end(),
                         [&](const auto& x, const auto& y) { return key(x) < key(y); });
        group.bonds.erase(std::unique(group.bonds.begin(), group.bonds.end(),
                                      [&](const auto& x, const auto& y) { return key(x) == key(y); }),
                          group.bonds.end());
    }

    const MmtfFields& fields_;
    MoleculeBuilder& builder_;
    MsgpackValue map_;
};

/// @param mostAtoms  of all groups together; a few are always allowed
/// @throws Error if a group is malformed
std::vector<MmtfGroup> readMmtfGroups(const MmtfFields& fields, MoleculeBuilder& builder, std::size_t mostAtoms) {
    std::vector<MmtfGroup> groups;
    std::size_t room = mostAtoms + kFewAtomsOfGroup;
    MsgpackElements elements(fields.list("groupList"));
    for (MsgpackValue group; elements.next(group);) {
        if (groups.size() == kMaxGroups)
            fields.fail("groupList has more than " + std::to_string(kMaxGroups) + " groups");
        groups.push_back(GroupReader(fields, builder, group).read(room));
        room -= groups.back().atoms.size();
    }
    return groups;
}

class MmtfReader {
public:
    MmtfReader(const std::string& name, std::string_view bytes, const ReadOptions& options, int lastModel)
        : fields_(name, bytes),
          maxAtoms_(options.maxAtoms),
          firstModel_(static_cast<std::size_t>(options.model)),
          lastModel_(static_cast<std::size_t>(std::max(options.model, lastModel))) {
        builders_.emplace_back(name, options.maxAtoms);
    }

    std::vector<Molecule> read() {
        checkVersion();
        readCounts();
        openArrays();
        walk();
        addBondsBetweenGroups();
        addAssemblies();
        summarise();
        std::vector<Molecule> models;
        for (std::size_t i = 0; i < builders_.size(); ++i) {
            if (i > 0) {
                builders_[i].molecule().file = models.front().file;
                builders_[i].molecule().file.chainsLabel =
                    static_cast<std::int64_t>(chainsOfModel_[firstModel_ - 1 + i]);
            }
            models.push_back(builders_[i].finish());
        }
        return models;
    }

private:
    void checkVersion() const {
        const std::string version = fields_.text("mmtfVersion");
        if (!startsWith(version, "1.") && !startsWith(version, "0."))
            fields_.fail("MMTF version '" + printable(version) + "' is not supported; supported: 1");
    }

    /// An unencoded list of counts that sum to `total`.
    std::vector<std::uint32_t> counts(const char* field, std::size_t size, std::size_t total) const {
        const MsgpackValue list = fields_.list(field);
        if (!list.is(Kind::array) || list.count != size)
            fields_.fail(std::string(field) + " does not have the stated length");
        std::vector<std::uint32_t> counts;
        MsgpackElements elements(list);
        std::size_t sum = 0;
        for (MsgpackValue value; elements.next(value);) {
            const auto count = value.asInteger();
            if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > total - sum)
                fields_.fail(std::string(field) + " has an impossible value");
            sum += static_cast<std::size_t>(*count);
            counts.push_back(static_cast<std::uint32_t>(*count));
        }
        if (sum != total) fields_.fail(std::string(field) + " does not add up");
        return counts;
    }

    void readCounts() {
        constexpr std::size_t kMaxAtomsOfModels = 4 * kMaxAtoms, kMaxChains = 1'000'000;
        atoms_ = fields_.count("numAtoms", kMaxAtomsOfModels);
        groups_ = fields_.count("numGroups", kMaxAtomsOfModels);
        chains_ = fields_.count("numChains", kMaxChains);
        models_ = fields_.count("numModels", kMaxChains);
        if (atoms_ == 0) fields_.fail("it has no atoms");
        if (firstModel_ > models_)
            fields_.fail("there is no model " + std::to_string(firstModel_) + "; the file has " +
                         std::to_string(models_));
        groupsOfChain_ = counts("groupsPerChain", chains_, groups_);
        chainsOfModel_ = counts("chainsPerModel", models_, chains_);
    }

    void openArrays() {
        types_ = readMmtfGroups(fields_, builders_.front(), maxAtoms_);
        typeOfGroup_ = fields_.integers("groupTypeList", groups_);
        numbers_ = fields_.integers("groupIdList", groups_);
        insertions_ = fields_.integers("insCodeList", groups_, 0);
        subchains_ = fields_.names("chainIdList", chains_);
        chainNames_ = fields_.has("chainNameList") ? fields_.names("chainNameList", chains_) : subchains_;
        for (std::size_t axis = 0; axis < 3; ++axis) positions_[axis] = fields_.floats(kPositions[axis], atoms_);
        temperature_ = fields_.floats("bFactorList", atoms_, 0);
        occupancy_ = fields_.floats("occupancyList", atoms_, 1);
        alternates_ = fields_.integers("altLocList", atoms_, 0);
    }

    /// Walks through every model; adds atoms and bonds of wanted ones.
    void walk() {
        std::size_t chain = 0;
        for (std::size_t model = 1; model <= models_; ++model) {
            const bool taken = model >= firstModel_ && model <= lastModel_;
            if (taken && model > firstModel_) builders_.emplace_back(builders_.front().name(), maxAtoms_);
            if (taken) begins_.push_back(next_);
            for (const std::size_t end = chain + chainsOfModel_[model - 1]; chain < end; ++chain)
                for (std::uint32_t group = 0; group < groupsOfChain_[chain]; ++group) addGroup(chain, taken);
            if (!taken) continue;
            if (firstModel_ < lastModel_ && next_ == begins_.back())
                fields_.fail("model " + std::to_string(model) + " has no atoms");
            end_ = next_;
        }
        if (next_ != atoms_) fields_.fail("its groups have " + std::to_string(next_) + " atoms instead of numAtoms");
    }

    void addGroup(std::size_t chain, bool taken) {
        const auto index = static_cast<std::size_t>(typeOfGroup_.next());  // a negative index becomes too large
        const std::int32_t number = numbers_.next();
        const char insertion = character(insertions_.next());
        if (index >= types_.size()) fields_.fail("groupTypeList refers to a group that is not there");
        const MmtfGroup& type = types_[index];
        if (type.atoms.size() > atoms_ - next_) fields_.fail("its groups have more atoms than numAtoms");
        if (taken && next_ + type.atoms.size() - begins_.front() > maxAtoms_)
            throw tooManyAtoms(builders_.front().name() + (firstModel_ < lastModel_ ? ", several models" : ""),
                               maxAtoms_);
        MoleculeBuilder& builder = builders_.back();
        for (std::size_t i = 0; i < type.atoms.size(); ++i) {
            Atom atom = type.atoms[i];
            place(atom, next_ + i + 1, taken);
            if (taken) builder.addAtom(atom, chainNames_[chain], number, insertion, type.name, subchains_[chain]);
        }
        if (taken) {
            countBonds(type.bonds.size());
            const auto first = static_cast<std::int64_t>(next_ - begins_.back());
            for (const MmtfGroup::Bond& bond : type.bonds)
                builder.addBond(first + bond.a, first + bond.b, bond.order, 0);
        }
        bondsOfAll_ += static_cast<std::int64_t>(type.bonds.size());
        next_ += type.atoms.size();
    }

    /// A hostile group could bond all its atoms with each other, and a million residues could refer to it.
    void countBonds(std::size_t more) {
        bonds_ += more;
        if (bonds_ > kMaxBondsPerAtom * atoms_) fields_.fail("it has more bonds than its atoms could form");
    }

    static char character(std::int32_t code) { return code > ' ' && code < 127 ? static_cast<char>(code) : '\0'; }

    /// Takes the next value of each array. @param number  of the atom, counted from 1
    void place(Atom& atom, std::size_t number, bool taken) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float value = positions_[axis].next();
            if (taken && !(std::abs(static_cast<double>(value)) <= kFarthestCoordinate))
                fields_.fail(std::string(1, "xyz"[axis]) + " of atom " + std::to_string(number) +
                             " is not a finite number within 1e9");
            atom.position[static_cast<int>(axis)] = value;
        }
        // NaN fails both comparisons, and keeps the Atom's default.
        const float occupancy = occupancy_.next(), temperature = temperature_.next();
        if (std::abs(occupancy) <= 1e9f) atom.occupancy = occupancy;
        if (std::abs(temperature) <= 1e9f) atom.temperatureFactor = temperature;
        atom.alternate = character(alternates_.next());
    }

    void addBondsBetweenGroups() {
        if (!fields_.has("bondAtomList")) return;
        const MsgpackValue list = fields_.list("bondAtomList");
        const std::size_t pairs = encodedLength(list) / 2;
        MmtfIntegers ends = fields_.integers("bondAtomList", 2 * pairs);
        MmtfIntegers orders = fields_.integers("bondOrderList", pairs, 1);
        bondsOfAll_ += static_cast<std::int64_t>(pairs);
        for (std::size_t i = 0; i < pairs; ++i) {
            // Numbered over all models.
            const std::int64_t a = ends.next(), b = ends.next();
            const std::int32_t order = orders.next();
            const auto total = static_cast<std::int64_t>(atoms_);
            if (a < 0 || b < 0 || a >= total || b >= total || a == b)
                fields_.fail("bondAtomList refers to an atom that is not there, or bonds one to itself");
            const std::size_t model = findModel(static_cast<std::size_t>(a));
            if (model == builders_.size() || model != findModel(static_cast<std::size_t>(b))) continue;
            countBonds(1);
            const auto begin = static_cast<std::int64_t>(begins_[model]);
            builders_[model].addBond(a - begin, b - begin, mmtfBondOrder(order), 0);
        }
    }

    /// Index, among the models read, of the one that contains an atom of the file; their number if none does.
    std::size_t findModel(std::size_t atom) const {
        const auto after = std::upper_bound(begins_.begin(), begins_.end(), atom);
        if (after == begins_.begin() || atom >= end_) return builders_.size();
        return static_cast<std::size_t>(after - begins_.begin()) - 1;
    }

    /// Number of values that an encoded array announces: bonds between groups have no other count. Limited by the
    /// file's size, like all counts.
    std::size_t encodedLength(const MsgpackValue& list) const {
        if (!list.is(Kind::binary) || list.bytes.size() < 8) fields_.fail("bondAtomList is not an encoded array");
        std::int32_t length = 0;
        integersFromBytes(list.bytes.substr(4, 4), {4, true}, ByteOrder::big)->next(length);
        if (length < 0 || length % 2 != 0 || static_cast<std::size_t>(length) > fields_.bytes())
            fields_.fail("bondAtomList announces an impossible number of atoms");
        return static_cast<std::size_t>(length);
    }

    void addAssemblies() {
        AssemblyLimits limits(maxAtoms_);
        MsgpackElements elements(fields_.list("bioAssemblyList"));
        for (MsgpackValue given; elements.next(given);) {
            const auto named = given.find("name");
            ++assemblies_;
            const std::string number = std::to_string(assemblies_);
            Assembly assembly{std::string(named ? named->asText().value_or(number) : number), "", {}};
            try {
                if (builders_.front().molecule().assemblies.size() == AssemblyLimits::kMaxAssemblies)
                    throw AssemblyFault("there are more than " + std::to_string(AssemblyLimits::kMaxAssemblies));
                addTransforms(assembly, given, limits);
                if (assembly.parts.empty()) throw AssemblyFault("it places no chain that is here");
                builders_.front().molecule().assemblies.push_back(std::move(assembly));
            } catch (const AssemblyFault& fault) {
                builders_.front().warn(leftOutWarning(assembly.id, fault.what()));
            }
        }
    }

    void addTransforms(Assembly& assembly, const MsgpackValue& given, AssemblyLimits& limits) {
        MsgpackElements transforms(given.find("transformList").value_or(MsgpackValue{}));
        std::int64_t count = 0;
        for (MsgpackValue transform; transforms.next(transform); ++count) {
            const MsgpackValue chains = transform.find("chainIndexList").value_or(MsgpackValue{});
            const MsgpackValue matrix = transform.find("matrix").value_or(MsgpackValue{});
            limits.spend(1, chains.count);
            if (matrix.count != 16) throw AssemblyFault("a matrix has not 16 numbers");
            TransformRows rows{};
            MsgpackElements numbers(matrix), indices(chains);
            MsgpackValue value;
            for (double& number : rows) number = numbers.next(value) ? value.asNumber().value_or(HUGE_VAL) : HUGE_VAL;
            std::vector<std::uint32_t> subchains;
            while (indices.next(value)) {
                const auto chain = value.asInteger();
                if (!chain || *chain < 0 || static_cast<std::size_t>(*chain) >= chains_)
                    throw AssemblyFault("it names a chain that is not there");
                if (const auto index = builders_.front().subchain(subchains_[static_cast<std::size_t>(*chain)]))
                    subchains.push_back(*index);
            }
            addPart(assembly, {{toMatrix(rows)}, std::move(subchains)});
        }
        mostTransforms_ = std::max(mostTransforms_, count);
    }

    void summarise() {
        FileSummary& file = builders_.front().molecule().file;
        file.format = "mmtf";
        file.title = fields_.text("title");
        file.models = static_cast<std::int64_t>(models_);
        file.totalAtomsAllModels = static_cast<std::int64_t>(atoms_);
        file.bonds = static_cast<std::int64_t>(bonds_);
        file.bondsAllModels = bondsOfAll_;
        file.chainsLabel = static_cast<std::int64_t>(chainsOfModel_[firstModel_ - 1]);
        if (assemblies_ == 0) return;
        file.assemblies = assemblies_;
        file.biomtOperators = mostTransforms_;
    }

    MmtfFields fields_;
    std::deque<MoleculeBuilder> builders_;           ///< of the models that are read
    std::size_t maxAtoms_, firstModel_, lastModel_;  ///< models from `firstModel_` to `lastModel_` are read
    std::size_t atoms_ = 0, groups_ = 0, chains_ = 0, models_ = 0;
    std::vector<std::uint32_t> groupsOfChain_, chainsOfModel_;
    std::vector<MmtfGroup> types_;
    MmtfIntegers typeOfGroup_, numbers_, insertions_, alternates_;
    std::vector<std::string_view> subchains_, chainNames_;
    std::array<MmtfFloats, 3> positions_;
    MmtfFloats temperature_, occupancy_;
    std::vector<std::size_t> begins_;  ///< first atoms of the models that are read
    std::size_t next_ = 0, end_ = 0;   ///< the next atom; end of the last of those models
    std::size_t bonds_ = 0;
    std::int64_t bondsOfAll_ = 0, assemblies_ = 0, mostTransforms_ = 0;
};

}  // namespace

std::vector<Molecule> readMmtf(const std::string& name, std::string_view bytes, const ReadOptions& options,
                               int lastModel) {
    return MmtfReader(name, bytes, options, lastModel).read();
}

}  // namespace nacre
