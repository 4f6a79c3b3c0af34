#include "engine/self_test/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/frame/picture.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/occlusion/directions.h"

namespace nacre {
namespace {

constexpr std::uint32_t kOpaque = 0xff000000, kColor = ~kOpaque;

/// A colour for each of 63 atoms, all far apart; never black.
std::uint32_t makeColor(std::uint32_t atom) {
    constexpr std::uint32_t kLevels[] = {0x20, 0x60, 0xa0, 0xe0};
    return kOpaque | kLevels[atom & 3] | kLevels[atom >> 2 & 3] << 8 | kLevels[atom >> 4 & 3] << 16;
}

Representation sample(const char* name, Style style) {
    const Molecule molecule = sampleMolecule(name);
    return represent(molecule, drawnAtoms(molecule), RepresentationOptions{.style = style});
}

Representation colored(Style style) {
    Representation r = sample("glucose", style);
    for (SphereLook& s : r.sphereLooks) s.color = makeColor(s.atom);
    for (CylinderLook& c : r.cylinderLooks) c.colorA = makeColor(c.atomA), c.colorB = makeColor(c.atomB);
    return r;
}

/// An octahedron about each sphere, in its colour. @param size  of its radius
void addOctahedra(Representation& r, float size) {
    constexpr glm::vec3 kCorners[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    constexpr glm::uvec3 kFaces[] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    Mesh mesh;
    for (std::uint32_t i = 0; i < r.spheres.size(); ++i) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec3& corner : kCorners) {
            mesh.positions.push_back(r.spheres[i].center + size * r.spheres[i].radius * corner);
            mesh.normals.push_back(corner);
            mesh.atoms.push_back(i);
        }
        for (const glm::uvec3& face : kFaces) mesh.triangles.push_back(face + first);
    }
    const std::vector<SphereLook> looks = r.sphereLooks;
    const auto getLook = [&](std::uint32_t atom) { return looks[atom]; };
    appendMesh(mesh, glm::dvec3(0), getLook, r);
}

Representation octahedra(Representation r) {
    addOctahedra(r, 1.0f);
    r.spheres.clear();
    r.sphereLooks.clear();
    r.cylinders.clear();
    r.cylinderLooks.clear();
    return r;
}

/// A cube of copies, as separate spheres.
Representation repeated(Representation r, int side) {
    const Representation one = r;
    r.spheres.clear();
    r.sphereLooks.clear();
    const double middle = (side - 1) / 2.0, step = 1.5 * one.radius;
    for (int copy = 0; copy < side * side * side; ++copy) {
        const glm::dvec3 at(copy % side - middle, copy / side % side - middle, copy / (side * side) - middle);
        for (Sphere s : one.spheres) {
            s.center += glm::vec3(step * at);
            r.spheres.push_back(s);
        }
        r.sphereLooks.insert(r.sphereLooks.end(), one.sphereLooks.begin(), one.sphereLooks.end());
    }
    r.radius = one.radius + std::sqrt(3.0) * middle * step;
    return r;
}

struct Ray {
    glm::dvec3 from, along;
};

/// The expected surface on a ray.
struct Seen {
    std::uint32_t color = 0;    ///< 0: nothing
    glm::dvec3 at{}, normal{};  ///< of a sphere, view space
    bool operator==(const Seen& other) const { return color == other.color; }
};

/// The scene's shapes in view space.
class Rays {
public:
    Rays(const Representation& r, const View& view) : r_(r), view_(view) {
        const auto seen = [&](const glm::vec3& p) { return view.seen(glm::dvec3(p)); };
        for (const Sphere& s : r.spheres) centers_.push_back(seen(s.center));
        for (const Cylinder& c : r.cylinders) ends_.push_back({seen(c.a), seen(c.b)});
        for (const Triangle& t : r.triangles) {
            const auto corner = [&](std::uint32_t v) { return seen(decodePosition(r.meshVertices[v], t.step())); };
            corners_.push_back({corner(t.a), corner(t.b), corner(t.c)});
        }
    }

    Seen through(double px, double py) const {
        const double x = (px - view_.width / 2.0) / view_.pixelsPerAngstrom - view_.pan.x;
        const double y = (view_.height / 2.0 - py) / view_.pixelsPerAngstrom - view_.pan.y;
        const glm::dvec3 eye(0, 0, view_.eyeDistance), at(x, y, 0);
        const bool parallel = view_.projection == Projection::orthographic;
        Nearest nearest;
        const Ray ray = parallel ? Ray{at, {0, 0, -1}} : Ray{eye, glm::normalize(at - eye)};
        meetSpheres(ray, nearest);
        meetCylinders(ray, nearest);
        meetTriangles(ray, nearest);
        return nearest.seen;
    }
    const std::vector<glm::dvec3>& centers() const { return centers_; }

private:
    struct Nearest {
        double way = 1e9;
        Seen seen;
        void meet(double at, const Seen& what) {
            if (at < way) way = at, seen = what;
        }
    };

    void meetSpheres(const Ray& ray, Nearest& nearest) const {
        for (std::size_t i = 0; i < centers_.size(); ++i) {
            const glm::dvec3 to = centers_[i] - ray.from;
            const double radius = r_.spheres[i].radius, middle = glm::dot(to, ray.along);
            const double under = radius * radius - glm::dot(to, to) + middle * middle;
            if (under <= 0) continue;
            const double way = middle - std::sqrt(under);
            const glm::dvec3 at = ray.from + way * ray.along;
            nearest.meet(way, {r_.sphereLooks[i].color & kColor, at, glm::normalize(at - centers_[i])});
        }
    }

    void meetCylinders(const Ray& ray, Nearest& nearest) const {
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            const glm::dvec3 a = ends_[i][0], b = ends_[i][1];
            const double length = glm::distance(a, b), radius = r_.cylinders[i].radius;
            const glm::dvec3 axis = (b - a) / length, from = ray.from - a;
            const glm::dvec3 across = from - axis * glm::dot(axis, from),
                             way = ray.along - axis * glm::dot(axis, ray.along);
            const double aa = glm::dot(way, way), ab = glm::dot(way, across);
            const double under = ab * ab - aa * (glm::dot(across, across) - radius * radius);
            if (aa < 1e-9 || under <= 0) continue;
            const double t = (-ab - std::sqrt(under)) / aa, along = glm::dot(from + t * ray.along, axis);
            // Both ends are inside of spheres.
            const CylinderLook& look = r_.cylinderLooks[i];
            if (along > 0 && along < length)
                nearest.meet(t, {(along < length / 2 ? look.colorA : look.colorB) & kColor});
        }
    }

    void meetTriangles(const Ray& ray, Nearest& nearest) const {
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const glm::dvec3 a = corners_[i][0], ab = corners_[i][1] - a, ac = corners_[i][2] - a;
            const glm::dvec3 normal = glm::cross(ab, ac);
            const double facing = glm::dot(normal, ray.along);
            if (std::abs(facing) < 1e-12) continue;
            const double t = glm::dot(normal, a - ray.from) / facing;
            const glm::dvec3 p = ray.from + t * ray.along - a;
            const double area = glm::dot(normal, normal), u = glm::dot(glm::cross(p, ac), normal) / area,
                         v = glm::dot(glm::cross(ab, p), normal) / area;
            if (u < 0 || v < 0 || u + v > 1) continue;
            nearest.meet(t, {r_.meshLooks[r_.meshVertices[r_.triangles[i].a].look].color & kColor});
        }
    }

    const Representation& r_;
    const View& view_;
    std::vector<glm::dvec3> centers_;
    std::vector<std::array<glm::dvec3, 2>> ends_;
    std::vector<std::array<glm::dvec3, 3>> corners_;
};

/// Fraction of ambient light at a point of a sphere, from the directions of a bake.
double opennessAt(const Representation& r, const Rays& rays, const View& view, const Seen& seen,
                  const std::vector<glm::dmat3>& directions) {
    double open = 0, all = 0;
    for (const glm::dmat3& frame : directions) {
        const glm::dvec3 w = view.rotation * glm::dvec3(frame[0].z, frame[1].z, frame[2].z);
        const double share = std::max(glm::dot(seen.normal, w), 0.0);
        bool hidden = false;
        for (std::size_t i = 0; i < r.spheres.size() && !hidden; ++i) {
            const glm::dvec3 to = rays.centers()[i] - seen.at;
            const double radius = r.spheres[i].radius, along = glm::dot(to, w),
                         under = radius * radius - glm::dot(to, to) + along * along;
            hidden = under > 0 && along > 0 && glm::dot(to, to) > 1.001 * radius * radius;  // not by its own sphere
        }
        all += share;
        if (!hidden) open += share;
    }
    return all > 0 ? open / all : 1;
}

}  // namespace

std::vector<TestScene> selfTestScenes() {
    using Shows = TestScene::Shows;
    constexpr auto kParallel = Projection::orthographic, kPerspective = Projection::perspective;
    Representation all = colored(Style::ballAndStick);
    addOctahedra(all, 2.0f);  // larger than their spheres, so that all three kinds are visible
    return {{colored(Style::ballAndStick), kParallel, Shows::colors},
            {colored(Style::spacefill), kParallel, Shows::occlusion},
            {octahedra(colored(Style::spacefill)), kParallel, Shows::colors},
            {std::move(all), kPerspective, Shows::colors}};
}

std::vector<TimedScene> timedScenes() {
    const Representation dna = sample("dna", Style::spacefill);
    return {{dna, Projection::orthographic},
            {octahedra(dna), Projection::perspective},
            {repeated(dna, 2), Projection::orthographic}};
}

RenderSettings testSettings(const Representation& r, Projection projection, std::uint32_t pixels) {
    RenderSettings s;
    s.view = makeView(Camera{.projection = projection, .rotationDegrees = {20, 30, 40}}, r.radius, pixels, pixels);
    s.supersample = 1;
    s.background = {0, 0, 0, 0};
    s.lighting = false;
    s.occlusion.directions = 0;
    return s;
}

bool shows(const Picture& picture, const Representation& r, const View& view) {
    constexpr double kNear = 0.75;
    const Rays rays(r, view);
    std::uint32_t looked = 0;
    for (std::uint32_t j = 0; j < picture.height; ++j)
        for (std::uint32_t i = 0; i < picture.width; ++i) {
            const Seen seen = rays.through(i + 0.5, j + 0.5);
            const std::uint32_t expected = seen.color;
            bool edge = false;
            for (const double dx : {-kNear, kNear})
                for (const double dy : {-kNear, kNear}) edge = edge || rays.through(i + 0.5 + dx, j + 0.5 + dy) != seen;
            if (edge) continue;
            ++looked;
            const float* pixel = &picture.rgba[4 * (std::size_t{j} * picture.width + i)];
            if ((pixel[3] > 0.5f) != (expected != 0)) return false;
            for (int channel = 0; channel < 3 && expected; ++channel) {
                const float wanted = linearFromSrgb(static_cast<float>(expected >> 8 * channel & 0xff) / 255.0f);
                // Levels differ by at least 0.1 of linear light, except for the lowest two.
                if (!(std::abs(pixel[channel] - wanted) < 0.02f)) return false;
            }
        }
    return looked > picture.width * picture.height / 2;
}

bool showsOcclusion(const Picture& picture, const Representation& r, const View& view, int count) {
    const std::vector<glm::dmat3> directions = occlusionDirections(count);
    const Rays rays(r, view);
    double error = 0, looked = 0;
    for (std::uint32_t j = 0; j < picture.height; j += 3)
        for (std::uint32_t i = 0; i < picture.width; i += 3) {
            const Seen seen = rays.through(i + 0.5, j + 0.5);
            if (!seen.color) continue;
            const float base = linearFromSrgb(static_cast<float>(seen.color >> 8 & 0xff) / 255.0f);
            const float green = picture.rgba[4 * (std::size_t{j} * picture.width + i) + 1];
            error += std::abs(double{green} / base - opennessAt(r, rays, view, seen, directions));
            ++looked;
        }
    // Texels and edges cause an error of 0.05; an entirely light or dark bake, 0.3 and more.
    return error < 0.15 * looked;
}

}  // namespace nacre
