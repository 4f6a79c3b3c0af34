#include "engine/molecule/space_group.h"

#include <cctype>
#include <exception>
#include <gemmi/symmetry.hpp>

namespace nacre {

const gemmi::SpaceGroup* findSpaceGroup(const std::string& name) {
    if (const gemmi::SpaceGroup* group = gemmi::find_spacegroup_by_name(name)) return group;
    std::string plain = name;
    if (const std::size_t origin = plain.find(':'); origin != std::string::npos) plain.erase(origin);
    std::erase_if(plain, [](unsigned char c) { return std::isspace(c) || c == '_'; });
    if (const gemmi::SpaceGroup* group = gemmi::find_spacegroup_by_name(plain)) return group;
    // A mirror or glide plane, then a threefold axis: since 1995 the axis is written with its inversion.
    constexpr std::string_view kPlanes = "mnadc";
    if (plain.size() < 3 || plain[2] != '3' ||
        kPlanes.find(static_cast<char>(std::tolower(static_cast<unsigned char>(plain[1])))) == std::string_view::npos)
        return nullptr;
    return gemmi::find_spacegroup_by_name(plain.insert(2, "-"));
}

std::optional<gemmi::Op> parseTriplet(std::string_view text) {
    // gemmi multiplies and adds without overflow checks.
    constexpr std::size_t kLongest = 200, kMostDigits = 3;
    if (text.size() > kLongest) return {};
    std::size_t digits = 0;
    for (const unsigned char c : text)
        if ((digits = std::isdigit(c) ? digits + 1 : 0) > kMostDigits) return {};
    try {
        return gemmi::parse_triplet(std::string(text));
    } catch (const std::exception&) {  // thrown by gemmi's parser
        return {};
    }
}

}  // namespace nacre
