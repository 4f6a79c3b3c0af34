#include "engine/mesh/solids.h"

#include <cmath>
#include <numbers>

#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

/// Rings of vertices about an axis, from its begin to its end, each joined to the one before it.
class Lathe {
public:
    Lathe(Mesh& mesh, const glm::dvec3& axis, int sides)
        : mesh_(mesh), axis_(axis), x_(anyAcross(axis)), y_(glm::cross(axis, x_)), sides_(sides) {}

    /// The point where the solid begins.
    void begin(const glm::dvec3& point, std::uint32_t atom) { pole_ = addVertex(mesh_, point, -axis_, atom); }

    /// @param latitude  of the normals: -pi/2 points back along the axis
    void ring(const glm::dvec3& center, double radius, double latitude, std::uint32_t atom) {
        const std::uint32_t first = addRing(center, radius, latitude, atom);
        for (int j = 0; j < sides_; ++j) {
            const std::uint32_t a = static_cast<std::uint32_t>(j), b = static_cast<std::uint32_t>((j + 1) % sides_);
            if (ring_ == kNone)
                mesh_.triangles.emplace_back(pole_, first + b, first + a);
            else
                joinQuad(ring_ + a, ring_ + b, first + a, first + b);
        }
        ring_ = first;
    }

    /// The same ring for another atom.
    void change(const glm::dvec3& center, double radius, double latitude, std::uint32_t atom) {
        ring_ = addRing(center, radius, latitude, atom);
    }

    void end(const glm::dvec3& point, std::uint32_t atom) {
        const std::uint32_t tip = addVertex(mesh_, point, axis_, atom);
        for (int j = 0; j < sides_; ++j)
            mesh_.triangles.emplace_back(ring_ + static_cast<std::uint32_t>(j),
                                         ring_ + static_cast<std::uint32_t>((j + 1) % sides_), tip);
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t addRing(const glm::dvec3& center, double radius, double latitude, std::uint32_t atom) {
        const std::uint32_t first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (int j = 0; j < sides_; ++j) {
            const double angle = 2 * std::numbers::pi * j / sides_;
            const glm::dvec3 out = x_ * std::cos(angle) + y_ * std::sin(angle);
            addVertex(mesh_, center + out * radius, out * std::cos(latitude) + axis_ * std::sin(latitude), atom);
        }
        return first;
    }

    void joinQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh_.triangles.emplace_back(a, b, d);
        mesh_.triangles.emplace_back(a, d, c);
    }

    Mesh& mesh_;
    glm::dvec3 axis_, x_, y_;
    int sides_;
    std::uint32_t pole_ = kNone, ring_ = kNone;
};

}  // namespace

std::uint32_t addVertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal, std::uint32_t atom) {
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    mesh.atoms.push_back(atom);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void append(Mesh& mesh, const Mesh& other) {
    const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.atoms.insert(mesh.atoms.end(), other.atoms.begin(), other.atoms.end());
    mesh.triangles.reserve(mesh.triangles.size() + other.triangles.size());
    for (const glm::uvec3& triangle : other.triangles) mesh.triangles.push_back(triangle + first);
}

void addRod(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double radius, std::uint32_t atomA,
            std::uint32_t atomB, int sides) {
    const glm::dvec3 axis = unitOr(b - a, glm::dvec3());
    if (axis == glm::dvec3()) return addBall(mesh, a, radius, atomA, sides);
    Lathe lathe(mesh, axis, sides);
    const int rings = sides / 4;  // from pole to equator
    lathe.begin(a - axis * radius, atomA);
    for (int i = 1; i <= rings; ++i) {
        const double latitude = std::numbers::pi / 2 * (static_cast<double>(i) / rings - 1);
        lathe.ring(a + axis * (radius * std::sin(latitude)), radius * std::cos(latitude), latitude, atomA);
    }
    if (atomA != atomB) {
        lathe.ring((a + b) / 2.0, radius, 0, atomA);
        lathe.change((a + b) / 2.0, radius, 0, atomB);
    }
    for (int i = 0; i < rings; ++i) {
        const double latitude = std::numbers::pi / 2 * i / rings;
        lathe.ring(b + axis * (radius * std::sin(latitude)), radius * std::cos(latitude), latitude, atomB);
    }
    lathe.end(b + axis * radius, atomB);
}

void addCylinder(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double radius, std::uint32_t atomA,
                 std::uint32_t atomB, int sides) {
    const glm::dvec3 axis = unitOr(b - a, {});
    if (axis == glm::dvec3()) return;
    constexpr double kPole = std::numbers::pi / 2;
    Lathe lathe(mesh, axis, sides);
    lathe.begin(a, atomA);
    lathe.ring(a, radius, -kPole, atomA);
    lathe.change(a, radius, 0, atomA);
    if (atomA != atomB) {
        lathe.ring((a + b) / 2.0, radius, 0, atomA);
        lathe.change((a + b) / 2.0, radius, 0, atomB);
    }
    lathe.ring(b, radius, 0, atomB);
    lathe.change(b, radius, kPole, atomB);
    lathe.end(b, atomB);
}

void addBall(Mesh& mesh, const glm::dvec3& center, double radius, std::uint32_t atom, int sides) {
    const glm::dvec3 axis(0, 0, 1);
    Lathe lathe(mesh, axis, sides);
    lathe.begin(center - axis * radius, atom);
    for (int i = 1; i < sides / 2; ++i) {
        const double latitude = std::numbers::pi * (2.0 * i / sides - 0.5);
        lathe.ring(center + axis * (radius * std::sin(latitude)), radius * std::cos(latitude), latitude, atom);
    }
    lathe.end(center + axis * radius, atom);
}

void addPlate(Mesh& mesh, std::span<const glm::dvec3> outline, const glm::dvec3& normal, double halfThickness,
              std::span<const std::vector<std::uint32_t>> fans, std::uint32_t atom) {
    const glm::dvec3 up = normal * halfThickness;
    for (const bool top : {true, false}) {
        const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec3& p : outline) addVertex(mesh, top ? p + up : p - up, top ? normal : -normal, atom);
        for (const std::vector<std::uint32_t>& fan : fans)
            for (std::size_t i = 1; i + 1 < fan.size(); ++i)
                mesh.triangles.emplace_back(first + fan[0], first + fan[top ? i : i + 1], first + fan[top ? i + 1 : i]);
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        const glm::dvec3 out = unitOr(glm::cross(b - a, normal), normal);
        const std::uint32_t first = addVertex(mesh, a - up, out, atom);
        for (const glm::dvec3& p : {b - up, b + up, a + up}) addVertex(mesh, p, out, atom);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
}

}  // namespace nacre
