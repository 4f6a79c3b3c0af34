#include "engine/scene/build/carbohydrates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <numbers>
#include <span>

#include "engine/mesh/solids.h"
#include "engine/mesh/unit_vectors.h"
#include "engine/scene/color/palettes.h"

namespace nacre {
namespace {

// The standard's colours: www.ncbi.nlm.nih.gov/glycans/snfg.html, version 1.5.
constexpr std::uint32_t kBlue = packedColor(0x0090bc), kGreen = packedColor(0x00a651), kYellow = packedColor(0xffd400),
                        kOrange = packedColor(0xf47920), kPink = packedColor(0xf69ea1), kPurple = packedColor(0xa54399),
                        kLightBlue = packedColor(0x8fcce9), kBrown = packedColor(0xa17a4d),
                        kRed = packedColor(0xed1c24);

/// A sugar, and its residues in the chemical component dictionary, separated by blanks. Shapes and colours are those of
/// the standard's table. Residues are those of Mol* 5.6 (carbohydrates/constants.ts), plus N,N'-diacetylated
/// bacillosamine. Mol* draws apiose green; the standard says blue.
struct SugarRow {
    SugarSymbol symbol;
    std::string_view residues;
};
using enum SugarShape;
constexpr SugarRow kSugars[] = {
    {{"Glc", sphere, kBlue}, "GLC BGC Z8T"},
    {{"Man", sphere, kGreen}, "MAN BMA"},
    {{"Gal", sphere, kYellow}, "GAL GLA GZL GXL GIV"},
    {{"Gul", sphere, kOrange}, "GUP GL0 4GL Z8H"},
    {{"Alt", sphere, kPink}, "SHD 3MK Z6H"},
    {{"All", sphere, kPurple}, "ALL AFD WOO Z2D"},
    {{"Tal", sphere, kLightBlue}, "A5C ZEE SDY"},
    {{"Ido", sphere, kBrown}, "4N2 ZCD Z0F"},
    {{"GlcNAc", cube, kBlue}, "NAG NDG NGZ"},
    {{"ManNAc", cube, kGreen}, "BM3 BM7"},
    {{"GalNAc", cube, kYellow}, "A2G NGA YYQ"},
    {{"GulNAc", cube, kOrange}, "LXB"},
    {{"AllNAc", cube, kPurple}, "NAA"},
    {{"IdoNAc", cube, kBrown}, "HSQ LXZ"},
    {{"GlcN", crossedCube, kBlue}, "GCS PA1"},
    {{"ManN", crossedCube, kGreen}, "95Z"},
    {{"GalN", crossedCube, kYellow}, "X6X 1GN"},
    {{"GlcA", dividedDiamond, kBlue}, "BDP GCU"},
    {{"ManA", dividedDiamond, kGreen}, "BEM MAV"},
    {{"GalA", dividedDiamond, kYellow}, "ADA GTR GTK"},
    {{"GulA", dividedDiamond, kOrange}, "LGU"},
    {{"TalA", dividedDiamond, kLightBlue}, "X1X X0X"},
    {{"IdoA", dividedDiamond, kBrown}, "IDR"},
    {{"Qui", cone, kBlue}, "G6D YYK"},
    {{"Rha", cone, kGreen}, "RAM RM4 XXR"},
    {{"6dGul", cone, kOrange}, "66O"},
    {{"Fuc", cone, kRed}, "FUC FUL FCA FCB GYE"},
    {{"QuiNAc", dividedCone, kBlue}, "Z9W"},
    {{"FucNAc", dividedCone, kRed}, "49T"},
    {{"Oli", flatRectangle, kBlue}, "DDA RAE Z5J"},
    {{"Tyv", flatRectangle, kGreen}, "TYV"},
    {{"Abe", flatRectangle, kOrange}, "ABE"},
    {{"Par", flatRectangle, kPink}, "PZU"},
    {{"Dig", flatRectangle, kPurple}, "Z3U"},
    {{"Ara", star, kGreen}, "ARA ARB AHR FUB 64K BXY BXX SEJ"},
    {{"Lyx", star, kYellow}, "LDY Z4W"},
    {{"Xyl", star, kOrange}, "XYP XYS XYZ HSY LXC"},
    {{"Rib", star, kPink}, "RIP RIB BDR YYM 0MK Z6J 32O"},
    {{"Kdn", diamond, kGreen}, "KDM KDN"},
    {{"Neu5Ac", diamond, kPurple}, "SIA SLB"},
    {{"Neu5Gc", diamond, kLightBlue}, "NGC NGE"},
    {{"Bac", flatHexagon, kBlue}, "B6D"},
    {{"LDmanHep", flatHexagon, kGreen}, "GMH"},
    {{"Kdo", flatHexagon, kYellow}, "KDO"},
    {{"DDmanHep", flatHexagon, kPink}, "289"},
    {{"MurNAc", flatHexagon, kPurple}, "MUB AMU"},
    {{"Mur", flatHexagon, kBrown}, "MUR 1S4"},
    {{"Api", pentagon, kBlue}, "XXM"},
    {{"Fru", pentagon, kGreen}, "FRU BDF Z9N LFR"},
    {{"Tag", pentagon, kYellow}, "T6T"},
    {{"Sor", pentagon, kOrange}, "SOE UEA"},
    {{"Psi", pentagon, kPink}, "PSV SF6 SF9 TTV"},
};

/// Position and orientation of a sugar.
struct SugarPlace {
    glm::dvec3 center{}, x{}, y{}, z{};  ///< z is the ring's normal; Å, in the file's frame
    std::uint32_t atom = 0;              ///< the anomeric carbon
};

/// Rings by atom names: carbons in order from the anomeric one, then the oxygen.
constexpr std::array<std::array<std::string_view, 6>, 4> kRings{{{"C1", "C2", "C3", "C4", "C5", "O5"},
                                                                 {"C2", "C3", "C4", "C5", "C6", "O6"},
                                                                 {"C1", "C2", "C3", "C4", "O4", ""},
                                                                 {"C2", "C3", "C4", "C5", "O5", ""}}};

std::optional<SugarPlace> placeOfRing(const Molecule& molecule, const Residue& residue,
                                      const std::array<std::string_view, 6>& names) {
    constexpr double kLongestBond = 1.9;  // Å
    std::vector<std::uint32_t> ring;
    for (const std::string_view name : names) {
        if (name.empty()) continue;
        std::uint32_t atom = residue.firstAtom;
        const std::uint32_t end = residue.firstAtom + residue.atomCount;
        while (atom < end && molecule.atoms[atom].name.view() != name) ++atom;
        if (atom == end) return std::nullopt;
        ring.push_back(atom);
    }
    const auto at = [&](std::size_t i) { return glm::dvec3(molecule.atoms[ring[i % ring.size()]].position); };
    SugarPlace place;
    glm::dvec3 normal{};
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (!(glm::distance(at(i), at(i + 1)) < kLongestBond)) return std::nullopt;
        place.center += at(i) / static_cast<double>(ring.size());
        normal += glm::cross(at(i), at(i + 1));
    }
    place.z = unitOr(normal, {0, 0, 1});
    place.x = unitOr(across(at(0) - place.center, place.z), anyAcross(place.z));
    place.y = glm::cross(place.z, place.x);
    place.atom = ring[0];
    return place;
}

std::optional<SugarPlace> placeOfSugar(const Molecule& molecule, const Residue& residue) {
    if (!sugarSymbol(residue.name)) return std::nullopt;
    for (const auto& names : kRings)
        if (const auto place = placeOfRing(molecule, residue, names)) return place;
    return std::nullopt;
}

/// Adds symbols to a mesh.
class SymbolMaker {
public:
    SymbolMaker(Mesh& mesh, const SugarPlace& place, const glm::dvec3& center, double size)
        : mesh_(mesh), place_(place), center_(center), size_(size) {}

    void add(SugarShape shape) {
        constexpr double kPi = std::numbers::pi;
        switch (shape) {
            case sphere:
                return addBall(mesh_, center_, size_, place_.atom, 48);
            case cube:
                return cubes(false);
            case crossedCube:
                return cubes(true);
            case diamond:
                return octahedron(false);
            case dividedDiamond:
                return octahedron(true);
            case cone:
                return cones(false);
            case dividedCone:
                return cones(true);
            case flatRectangle:
                return prism({{1, 0.6}, {-1, 0.6}, {-1, -0.6}, {1, -0.6}});
            case flatDiamond:
                return prism({{1.1, 0}, {0, 0.7}, {-1.1, 0}, {0, -0.7}});
            case flatHexagon:
                return prism({{1, 0}, {0.5, 0.8}, {-0.5, 0.8}, {-1, 0}, {-0.5, -0.8}, {0.5, -0.8}});
            case pentagon:
            case star: {
                std::vector<glm::dvec2> outline;
                const int corners = shape == star ? 10 : 5;
                for (int i = 0; i < corners; ++i) {
                    const double radius = shape == star && i % 2 ? 0.45 : 1, angle = 2 * kPi * i / corners;
                    outline.push_back(radius * glm::dvec2(std::cos(angle), std::sin(angle)));
                }
                return prism(outline);
            }
        }
    }

private:
    /// @param p  in the symbol's own frame, in units of its size
    glm::dvec3 at(const glm::dvec3& p) const {
        return center_ + size_ * (place_.x * p.x + place_.y * p.y + place_.z * p.z);
    }
    std::uint32_t half(bool white) const { return white ? place_.atom | kWhiteHalf : place_.atom; }

    /// A flat face whose normal points away from the symbol's centre, or from another point.
    void face(std::span<const glm::dvec3> corners, bool white, const glm::dvec3& inside = {}) {
        glm::dvec3 middle{};
        std::vector<glm::dvec3> placed;
        for (const glm::dvec3& p : corners) {
            placed.push_back(at(p));
            middle += placed.back() / static_cast<double>(corners.size());
        }
        glm::dvec3 normal = unitOr(glm::cross(placed[1] - placed[0], placed[2] - placed[0]), {0, 0, 1});
        const bool outward = glm::dot(normal, middle - at(inside)) >= 0;
        if (!outward) normal = -normal;
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (const glm::dvec3& p : placed) addVertex(mesh_, p, normal, half(white));
        for (std::uint32_t i = 1; i + 1 < placed.size(); ++i)
            mesh_.triangles.emplace_back(first, first + (outward ? i : i + 1), first + (outward ? i + 1 : i));
    }

    /// A cube, split along a diagonal if crossed.
    void cubes(bool crossed) {
        constexpr double a = 0.806;  // for the same volume as the sphere
        for (const double z : {-a, a}) {
            const glm::dvec3 p[] = {{-a, -a, z}, {a, -a, z}, {a, a, z}, {-a, a, z}};
            const glm::dvec3 first[] = {p[0], p[1], p[2]}, second[] = {p[0], p[2], p[3]};
            face(first, false);
            face(second, crossed);
        }
        const glm::dvec2 corners[] = {{-a, -a}, {a, -a}, {a, a}, {-a, a}};
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec2 u = corners[i], v = corners[(i + 1) % 4];
            const glm::dvec3 side[] = {{u, -a}, {v, -a}, {v, a}, {u, a}};
            face(side, crossed && i >= 2);
        }
    }

    void octahedron(bool divided) {
        constexpr double r = 1.28;
        const glm::dvec3 around[] = {{r, 0, 0}, {0, r, 0}, {-r, 0, 0}, {0, -r, 0}};
        for (const double z : {-r, r})
            for (std::size_t i = 0; i < 4; ++i) {
                const glm::dvec3 corners[] = {around[i], around[(i + 1) % 4], {0, 0, z}};
                face(corners, divided && z < 0);
            }
    }

    void cones(bool divided) {
        constexpr int kSides = 48;
        constexpr double r = 1.1, low = -0.85, high = 1.4;
        const auto rim = [](int i) {
            const double angle = 2 * std::numbers::pi * i / kSides;
            return glm::dvec3(r * std::cos(angle), r * std::sin(angle), low);
        };
        const double slant = std::hypot(r, high - low);
        const auto slope = [&](double i) {
            const double angle = 2 * std::numbers::pi * i / kSides;
            const glm::dvec3 n =
                glm::dvec3(std::cos(angle), std::sin(angle), 0) * ((high - low) / slant) + glm::dvec3(0, 0, r / slant);
            return place_.x * n.x + place_.y * n.y + place_.z * n.z;
        };
        for (int i = 0; i < kSides; ++i) {
            const bool white = divided && i >= kSides / 2;
            const std::uint32_t first = addVertex(mesh_, at(rim(i)), slope(i), half(white));
            addVertex(mesh_, at(rim(i + 1)), slope(i + 1), half(white));
            addVertex(mesh_, at({0, 0, high}), slope(i + 0.5), half(white));
            mesh_.triangles.emplace_back(first, first + 1, first + 2);
            const glm::dvec3 base[] = {{0, 0, low}, rim(i), rim(i + 1)};
            face(base, white);
        }
    }

    /// A prism: an outline that is star-shaped about its centre, thickened to both sides of the ring's plane.
    void prism(const std::vector<glm::dvec2>& outline) {
        constexpr double kHalf = 0.4;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec2 u = outline[i], v = outline[(i + 1) % outline.size()];
            for (const double z : {-kHalf, kHalf}) {
                const glm::dvec3 wedge[] = {{0, 0, z}, {u, z}, {v, z}};
                face(wedge, false);
            }
            const glm::dvec3 wall[] = {{u, -kHalf}, {v, -kHalf}, {v, kHalf}, {u, kHalf}};
            face(wall, false);
        }
    }

    Mesh& mesh_;
    const SugarPlace& place_;
    glm::dvec3 center_;
    double size_;
};

/// Sticks between bonded sugars, and from a sugar to the residue that it is attached to.
void addSticks(const Molecule& molecule, const std::map<std::uint32_t, SugarPlace>& places, const glm::dvec3& origin,
               double scale, Mesh& mesh) {
    const double radius = 0.35 * scale;  // Å
    constexpr int kSides = 24;
    for (const Bond& bond : molecule.bonds) {
        const std::uint32_t a = molecule.atoms[bond.a].residue, b = molecule.atoms[bond.b].residue;
        if (a == b) continue;
        const auto sugarA = places.find(a), sugarB = places.find(b);
        if (sugarA != places.end() && sugarB != places.end()) {
            const SugarPlace &p = sugarA->second, &q = sugarB->second;
            addCylinder(mesh, p.center - origin, q.center - origin, radius, p.atom, q.atom, kSides);
        } else if (sugarA != places.end() || sugarB != places.end()) {
            const SugarPlace& sugar = sugarA != places.end() ? sugarA->second : sugarB->second;
            const std::uint32_t other = sugarA != places.end() ? bond.b : bond.a;
            const glm::dvec3 end(molecule.atoms[other].position);
            addRod(mesh, sugar.center - origin, end - origin, radius, sugar.atom, sugar.atom, kSides);
            // Ends at the atom through which a cartoon or backbone passes.
            const Residue& residue = molecule.residues[molecule.atoms[other].residue];
            for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i)
                if (molecule.atoms[i].name.view() == "CA")
                    addRod(mesh, end - origin, glm::dvec3(molecule.atoms[i].position) - origin, radius, sugar.atom,
                           sugar.atom, kSides);
        }
    }
}

}  // namespace

const SugarSymbol* sugarSymbol(const Name& residue) {
    static const std::map<std::string_view, const SugarSymbol*> kByResidue = [] {
        std::map<std::string_view, const SugarSymbol*> all;
        for (const SugarRow& row : kSugars)
            for (std::size_t from = 0; from < row.residues.size();) {
                const std::size_t end = std::min(row.residues.find(' ', from), row.residues.size());
                all.emplace(row.residues.substr(from, end - from), &row.symbol);
                from = end + 1;
            }
        return all;
    }();
    const auto found = kByResidue.find(residue.view());
    return found == kByResidue.end() ? nullptr : found->second;
}

bool isSugar(const Molecule& molecule, std::uint32_t residue) {
    return placeOfSugar(molecule, molecule.residues[residue]).has_value();
}

Mesh sugarSymbols(const Molecule& molecule, const std::vector<std::uint32_t>& atoms, const SugarOptions& options,
                  const glm::dvec3& origin) {
    constexpr double kSize = 1.75, kIconSize = 0.6;  // Å, of a sphere's radius
    std::map<std::uint32_t, SugarPlace> places;
    for (const std::uint32_t atom : atoms) {
        const std::uint32_t residue = molecule.atoms[atom].residue;
        if (places.contains(residue)) continue;
        if (const auto place = placeOfSugar(molecule, molecule.residues[residue])) places.emplace(residue, *place);
    }
    Mesh mesh;
    for (const auto& [residue, place] : places)
        SymbolMaker(mesh, place, place.center - origin, (options.icons ? kIconSize : kSize) * options.scale)
            .add(sugarSymbol(molecule.residues[residue].name)->shape);
    if (!options.icons) addSticks(molecule, places, origin, options.scale, mesh);
    return mesh;
}

}  // namespace nacre
