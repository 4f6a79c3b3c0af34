#include "engine/scene/build/mesh_caps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <unordered_map>

#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

// Å behind the plane: caps of cartoons lie in front of those of surfaces around them. Below half of kCapRise.
constexpr double kCartoonDepth = 0.001, kSurfaceDepth = 0.002;
constexpr double kCellSide = 0.5;     // Å: owners are found at cells' corners
constexpr double kMostPerSide = 600;  // cells
constexpr double kNearAtoms = 5;      // Å from the plane, and from a point: range of atoms that may own the point

bool isCapped(const Representation& r, const MeshRun& mesh) {
    return mesh.closed && mesh.count > 0 &&
           isOpaque(r.meshLooks[r.meshVertices[r.triangles[mesh.first].a].look].color) &&
           isOpaque(r.meshLooks[r.meshVertices[r.triangles[mesh.first + mesh.count - 1].a].look].color);
}

/// A piece of an outline on the plane: the inside is on its left.
struct Segment {
    glm::dvec2 from, to;
    SphereLook look;

    bool spans(double y) const { return (from.y <= y) != (to.y <= y); }
    double xAt(double y) const {
        const double share = std::clamp((y - from.y) / (to.y - from.y), 0.0, 1.0);
        return from.x + (to.x - from.x) * share;
    }
    int winding() const { return to.y < from.y ? 1 : -1; }  // of points to the segment's right
};

/// The outlines of a mesh in a plane.
class Slicer {
public:
    /// @param toView  from the mesh to view space @param height  of the plane there
    Slicer(const Representation& r, const MeshRun& mesh, const glm::dmat4x3& toView, double height)
        : r_(r), toView_(toView), height_(height) {
        const bool mirrored = glm::dot(glm::cross(toView[0], toView[1]), toView[2]) < 0;
        for (std::uint32_t i = mesh.first; i < mesh.first + mesh.count; ++i) cut(r.triangles[i], mirrored);
    }
    std::vector<Segment> segments;

private:
    struct Corner {
        glm::dvec3 place;  // height above the plane in z
        std::uint64_t key;
        std::uint32_t look;
    };

    Corner makeCorner(std::uint32_t vertex, float step) const {
        const MeshVertex& v = r_.meshVertices[vertex];
        glm::dvec3 place = toView_ * glm::dvec4(decodePosition(v, step), 1.0);
        place.z -= height_;
        return {place, std::uint64_t{v.xz} << 32 | v.yz, v.look};
    }
    /// Gives both triangles at an edge the same bits.
    glm::dvec2 crossing(const Corner& a, const Corner& b) const {
        const Corner &first = a.key < b.key ? a : b, &second = a.key < b.key ? b : a;
        const double share = first.place.z / (first.place.z - second.place.z);
        return glm::dvec2(first.place) + glm::dvec2(second.place - first.place) * share;
    }
    void cut(const Triangle& t, bool mirrored) {
        const std::array<Corner, 3> corners{makeCorner(t.a, t.step()), makeCorner(t.b, t.step()),
                                            makeCorner(t.c, t.step())};
        std::array<bool, 3> before{};
        for (std::size_t i = 0; i < 3; ++i) before[i] = corners[i].place.z > 0;
        if (before[0] == before[1] && before[1] == before[2]) return;
        // The corner that is alone on its side.
        const std::size_t lone = before[0] == before[1] ? 2 : before[0] == before[2] ? 1 : 0;
        const Corner &a = corners[lone], &b = corners[(lone + 1) % 3], &c = corners[(lone + 2) % 3];
        glm::dvec2 from = crossing(a, b), to = crossing(a, c);
        if (before[lone] == mirrored) std::swap(from, to);
        if (from == to) return;
        const Corner& owner = std::abs(a.place.z) < std::abs(b.place.z) ? a : b;
        segments.push_back({from, to, r_.meshLooks[owner.look]});
    }

    const Representation& r_;
    const glm::dmat4x3 toView_;
    const double height_;
};

/// Finds the atom that owns a point of the plane.
class Owners {
public:
    void add(const glm::dvec2& at, double height, double radius, const SphereLook& look) {
        cells_[makeKey(findCell(at))].push_back({at, height, radius, look});
    }
    struct Owned {
        SphereLook look;
        double margin = std::numeric_limits<double>::infinity();  ///< Å by which the nearest other atom is farther
    };
    /// @param otherwise  the look where no atom is near
    Owned at(const glm::dvec2& point, const SphereLook& otherwise) const {
        const glm::ivec2 middle = findCell(point);
        double least = std::numeric_limits<double>::infinity(), next = least;
        const SphereLook* found = &otherwise;
        for (int x = middle.x - 1; x <= middle.x + 1; ++x)
            for (int y = middle.y - 1; y <= middle.y + 1; ++y) {
                const auto cell = cells_.find(makeKey({x, y}));
                if (cell == cells_.end()) continue;
                for (const Owner& owner : cell->second) {
                    const glm::dvec2 way = owner.at - point;
                    const double distance = std::sqrt(glm::dot(way, way) + owner.height * owner.height) - owner.radius;
                    const bool another = owner.look.atom != found->atom || owner.look.color != found->color;
                    if (distance < least) {
                        if (another) next = least;
                        least = distance, found = &owner.look;
                    } else if (another) {
                        next = std::min(next, distance);
                    }
                }
            }
        return {*found, next - least};
    }

private:
    struct Owner {
        glm::dvec2 at;
        double height, radius;
        SphereLook look;
    };
    static glm::ivec2 findCell(const glm::dvec2& at) { return glm::floor(at / kNearAtoms); }
    static std::uint64_t makeKey(const glm::ivec2& cell) {
        return std::uint64_t{static_cast<std::uint32_t>(cell.x)} << 32 | static_cast<std::uint32_t>(cell.y);
    }
    std::unordered_map<std::uint64_t, std::vector<Owner>> cells_;
};

/// Fills outlines with triangles, cell by cell of a grid: whole squares where no outline passes, else trapezoids
/// between the ends of its pieces. Neighbours overlap by `lap`, since vertices are rounded.
class Filler {
public:
    Filler(const std::vector<Segment>& segments, double lap) : lap_(lap) {
        glm::dvec2 high(-std::numeric_limits<double>::infinity());
        for (const Segment& s : segments) {
            low_ = glm::min(low_, glm::min(s.from, s.to));
            high = glm::max(high, glm::max(s.from, s.to));
        }
        const glm::dvec2 extent = high - low_;
        side_ = std::max(kCellSide, std::max(extent.x, extent.y) / kMostPerSide);
        columns_ = static_cast<int>(extent.x / side_) + 1;
        const int rows = static_cast<int>(extent.y / side_) + 1;
        std::vector<std::vector<const Segment*>> passing(static_cast<std::size_t>(rows));
        const auto findRow = [&](double y) { return std::clamp(static_cast<int>((y - low_.y) / side_), 0, rows - 1); };
        for (const Segment& s : segments)
            for (int row = findRow(std::min(s.from.y, s.to.y)); row <= findRow(std::max(s.from.y, s.to.y)); ++row)
                passing[static_cast<std::size_t>(row)].push_back(&s);
        for (int row = 0; row < rows; ++row) fillRow(row, passing[static_cast<std::size_t>(row)]);
    }
    /// `lap` points from a corner to its vertex.
    struct Corner {
        glm::dvec2 at, lap;
    };
    std::vector<Corner> corners;  ///< of quadrilaterals, four each, anticlockwise
    double side() const { return side_; }

private:
    using Segments = std::vector<const Segment*>;

    void fillRow(int row, const Segments& passing) {
        const double low = low_.y + row * side_, high = low + side_, middle = (low + high) / 2;
        std::vector<bool> crossed(static_cast<std::size_t>(columns_));
        std::vector<std::pair<double, int>> borders;
        for (const Segment* s : passing) {
            const double lowest = std::min(s->from.y, s->to.y), highest = std::max(s->from.y, s->to.y);
            const double a = highest > lowest ? s->xAt(std::max(low, lowest)) : s->from.x,
                         b = highest > lowest ? s->xAt(std::min(high, highest)) : s->to.x;
            for (int column = findColumn(std::min(a, b)); column <= findColumn(std::max(a, b)); ++column)
                crossed[static_cast<std::size_t>(column)] = true;
            if (s->spans(middle)) borders.emplace_back(s->xAt(middle), s->winding());
        }
        std::sort(borders.begin(), borders.end());
        std::size_t next = 0;
        int winding = 0;
        for (int column = 0; column < columns_; ++column) {
            const double left = low_.x + column * side_, right = left + side_;
            for (; next < borders.size() && borders[next].first < left; ++next) winding += borders[next].second;
            if (crossed[static_cast<std::size_t>(column)])
                fillCell({left, low}, {right, high}, passing);
            else if (winding > 0)
                add({left, low}, {right, low}, {right, high}, {left, high});
        }
    }

    void fillCell(const glm::dvec2& low, const glm::dvec2& high, const Segments& passing) {
        std::vector<double> levels{low.y, high.y};
        for (const Segment* s : passing) {
            for (const glm::dvec2& end : {s->from, s->to})
                if (end.y > low.y && end.y < high.y && end.x >= low.x && end.x <= high.x) levels.push_back(end.y);
            for (const double x : {low.x, high.x}) {  // ends at the cell's borders
                if ((s->from.x <= x) == (s->to.x <= x)) continue;
                const double y = s->from.y + (s->to.y - s->from.y) * ((x - s->from.x) / (s->to.x - s->from.x));
                if (y > low.y && y < high.y) levels.push_back(y);
            }
        }
        std::sort(levels.begin(), levels.end());
        for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
            const double from = levels[i], to = levels[i + 1];
            if (to - from > 1e-9) fillBand(low.x, high.x, from, to, passing);
        }
    }

    void fillBand(double left, double right, double from, double to, const Segments& passing) {
        const double middle = (from + to) / 2;
        struct Border {
            double at, below, above;
            int winding;
        };
        std::vector<Border> borders;
        int winding = 0;
        for (const Segment* s : passing) {
            if (!s->spans(middle)) continue;
            const double x = s->xAt(middle);
            if (x < left)
                winding += s->winding();
            else if (x < right)
                borders.push_back({x, s->xAt(from), s->xAt(to), s->winding()});
        }
        std::sort(borders.begin(), borders.end(), [](const Border& a, const Border& b) { return a.at < b.at; });
        double below = left, above = left;
        for (const Border& border : borders) {
            const double b = std::clamp(border.below, left, right), a = std::clamp(border.above, left, right);
            if (winding > 0) add({below, from}, {b, from}, {a, to}, {above, to});
            winding += border.winding;
            below = b, above = a;
        }
        if (winding > 0) add({below, from}, {right, from}, {right, to}, {above, to});
    }

    void add(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
        corners.insert(corners.end(), {{a, {-lap_, -lap_}}, {b, {lap_, -lap_}}, {c, {lap_, lap_}}, {d, {-lap_, lap_}}});
    }
    int findColumn(double x) const { return std::clamp(static_cast<int>((x - low_.x) / side_), 0, columns_ - 1); }

    double lap_, side_ = kCellSide;
    glm::dvec2 low_{std::numeric_limits<double>::infinity()};
    int columns_ = 0;
};

/// Adds the cap of one copy of a mesh.
void addCap(const Representation& scene, const MeshRun& mesh, const glm::dmat4x3& place, const View& view,
            double height, Representation& caps) {
    const glm::dmat3 turn = view.rotation * glm::dmat3(place);
    const glm::dmat4x3 toView(turn[0], turn[1], turn[2], view.rotation * place[3]);
    const std::vector<Segment> segments = Slicer(scene, mesh, toView, height).segments;
    if (segments.empty()) return;
    Owners owners;
    const bool atoms = mesh.surface && !scene.surfaceAtoms.empty();
    if (atoms) {
        for (const SurfaceAtom& atom : scene.surfaceAtoms) {
            const glm::dvec3 at = toView * glm::dvec4(atom.center, 1.0);
            if (std::abs(at.z - height) < kNearAtoms)
                owners.add(glm::dvec2(at), at.z - height, static_cast<double>(atom.radius), atom.look);
        }
    } else {
        for (const Segment& s : segments) owners.add(s.from, 0, 0, s.look);
    }
    const float step = scene.triangles[mesh.first].step();
    const Filler filler(segments, 2 * static_cast<double>(step));
    const double z = height - (mesh.surface ? kSurfaceDepth : kCartoonDepth);
    const glm::dmat3 back = glm::transpose(view.rotation);
    Mesh cap;
    const double widestMargin = 3 * filler.side();  // over a cell's diagonal, margins change by at most twice its
                                                    // length
    std::vector<SphereLook> looks;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    std::map<std::pair<double, double>, std::pair<std::uint32_t, float>> known;  // look and margin; cells share corners
    for (const auto& [at, lap] : filler.corners) {
        const auto [owned, found] = known.try_emplace({at.x, at.y});
        if (found) {
            const auto [look, margin] = owners.at(at, segments.front().look);
            const auto [number, isNew] =
                numbers.emplace(std::uint64_t{look.color} << 32 | look.atom, static_cast<std::uint32_t>(looks.size()));
            if (isNew) looks.push_back(look);
            owned->second = {number->second, static_cast<float>(std::min(margin, widestMargin))};
        }
        cap.positions.emplace_back(back * glm::dvec3(at + lap, z));
        cap.normals.emplace_back(back[2]);
        cap.atoms.push_back(owned->second.first);
        cap.margins.push_back(owned->second.second);
    }
    for (std::uint32_t i = 0; i + 3 < cap.positions.size(); i += 4) {
        cap.triangles.emplace_back(i, i + 1, i + 2);
        cap.triangles.emplace_back(i, i + 2, i + 3);
    }
    appendMesh(
        cap, {}, [&](std::uint32_t number) { return looks[number]; }, caps);
    caps.meshes.back().closed = false;
}

/// Whether a plane cuts a mesh, by the range of its vertices along the view axis.
bool meetsPlane(const Representation& scene, const MeshRun& mesh, const glm::dmat4x3& place, const View& view,
                double height) {
    const glm::dvec3 axis(view.rotation[0].z, view.rotation[1].z, view.rotation[2].z);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const float step = scene.triangles[mesh.first].step();
    for (std::uint32_t v = mesh.firstVertex; v < mesh.endVertex; ++v) {
        const double z = glm::dot(axis, place * glm::dvec4(decodePosition(scene.meshVertices[v], step), 1.0));
        low = std::min(low, z);
        high = std::max(high, z);
    }
    return low < height && high > height;
}

}  // namespace

std::uint32_t packedCapColor(const Clip& clip) {
    if (!clip.capColor) return 0;
    std::uint32_t color = 0xff000000u;
    for (std::size_t i = 0; i < 3; ++i)
        color |= static_cast<std::uint32_t>(std::lround((*clip.capColor)[i] * 255.0f)) << 8 * i;
    return color;
}

bool needsCaps(const Representation& scene, const Clip& clip) {
    return clip.near > -Clip::kNone && std::any_of(scene.meshes.begin(), scene.meshes.end(),
                                                   [&](const MeshRun& mesh) { return isCapped(scene, mesh); });
}

Representation meshCaps(const Representation& scene, const View& view, const Clip& clip) {
    Representation caps;
    caps.center = scene.center;
    if (!needsCaps(scene, clip)) return caps;
    const double height = -clip.near;
    const auto add = [&](const MeshRun& mesh, const glm::dmat4x3& place) {
        if (meetsPlane(scene, mesh, place, view, height)) addCap(scene, mesh, place, view, height, caps);
    };
    for (const MeshRun& mesh : scene.meshes) {
        if (!isCapped(scene, mesh)) continue;
        if (scene.copies.transforms.empty()) {
            add(mesh, glm::dmat4x3(1.0));
            continue;
        }
        for (const PrimitiveRun& run : scene.copies.triangles)
            if (run.first <= mesh.first && mesh.first < run.first + run.count)
                for (const std::uint32_t copy : scene.copies.lists[run.list]) add(mesh, scene.copies.transforms[copy]);
    }
    return caps;
}

}  // namespace nacre
