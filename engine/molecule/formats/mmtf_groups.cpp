#include "engine/molecule/formats/mmtf_groups.h"

#include <algorithm>
#include <tuple>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

using Kind = MsgpackValue::Kind;

constexpr std::size_t kMaxGroups = 100'000;       // the dictionary of residues has some 45,000 entries
constexpr std::size_t kFewAtomsOfGroup = 10'000;  // of all groups; always allowed
constexpr std::size_t kMaxBondsPerAtom = 16;

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

}  // namespace

std::uint8_t mmtfBondOrder(std::int64_t order) {
    return static_cast<std::uint8_t>(std::clamp<std::int64_t>(order, 1, 3));
}

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

}  // namespace nacre
