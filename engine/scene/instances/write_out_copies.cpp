#include "engine/scene/instances/write_out_copies.h"

#include <glm/mat3x3.hpp>
#include <utility>
#include <vector>

#include "engine/scene/build/mesh_streams.h"

namespace nacre {
namespace {

struct PlacedRun {
    const PrimitiveRun* run;
    const glm::dmat4x3* motion;
};

glm::vec3 placedAt(const glm::dmat4x3& motion, const glm::vec3& p) {
    return glm::vec3(motion * glm::dvec4(glm::dvec3(p), 1.0));
}

/// The triangles of a run as a mesh; Mesh::atoms are its looks.
Mesh meshOfRun(const Representation& r, const PrimitiveRun& run) {
    Mesh mesh;
    std::vector<std::uint32_t> places(r.meshVertices.size(), UINT32_MAX);
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        const Triangle& t = r.triangles[i];
        glm::uvec3 corners{};
        int corner = 0;
        for (const std::uint32_t v : {t.a, t.b, t.c}) {
            if (places[v] == UINT32_MAX) {
                places[v] = static_cast<std::uint32_t>(mesh.positions.size());
                mesh.positions.push_back(decodePosition(r.meshVertices[v], t.step()));
                mesh.normals.push_back(decodeNormal(r.meshVertices[v]));
                mesh.atoms.push_back(r.meshVertices[v].look);
                mesh.margins.push_back(t.weight(corner));
            }
            corners[corner++] = places[v];
        }
        mesh.triangles.push_back(corners);
    }
    return mesh;
}

void writeRunOut(const Representation& from, const PlacedRun& placed, Representation& to) {
    Mesh mesh = meshOfRun(from, *placed.run);
    const glm::dmat4x3& m = *placed.motion;
    const glm::mat3 turn(glm::dmat3(m[0], m[1], m[2]));
    for (glm::vec3& p : mesh.positions) p = placedAt(m, p);
    for (glm::vec3& n : mesh.normals) n = turn * n;
    appendMesh(
        mesh, {}, [&](std::uint32_t look) { return from.meshLooks[look]; }, to);
    to.meshes.back().closed = false;  // a mirror image turns inwards
}

}  // namespace

bool writeOutCopies(Representation& r, const std::function<bool(const glm::dvec3&, double)>& wanted) {
    std::size_t count = 0;
    const auto chosen = [&](const std::vector<PrimitiveRun>& runs) {
        std::vector<PlacedRun> placed;
        for (const PrimitiveRun& run : runs)
            for (const std::uint32_t copy : r.copies.lists[run.list]) {
                const glm::dmat4x3& motion = r.copies.transforms[copy];
                if (!wanted(motion * glm::dvec4(run.center, 1.0), run.radius)) continue;
                placed.push_back({&run, &motion});
                count += run.count;
            }
        return placed;
    };
    const std::vector<PlacedRun> spheres = chosen(r.copies.spheres), sticks = chosen(r.copies.cylinders),
                                 triangles = chosen(r.copies.triangles);
    if (count > kMostWrittenOut) return false;
    Representation out;
    for (const auto& [run, motion] : spheres)
        for (std::uint32_t i = run->first; i < run->first + run->count; ++i) {
            if (i < r.ellipsoids.size()) {
                const glm::mat3 turn(glm::dmat3((*motion)[0], (*motion)[1], (*motion)[2]));
                out.ellipsoids.resize(out.spheres.size());
                out.ellipsoids.push_back(r.ellipsoids[i]);
                out.ellipsoids.back().first = turn * r.ellipsoids[i].first;
                out.ellipsoids.back().second = turn * r.ellipsoids[i].second;
            }
            out.spheres.push_back({placedAt(*motion, r.spheres[i].center), r.spheres[i].radius});
            out.sphereLooks.push_back(r.sphereLooks[i]);
        }
    for (const auto& [run, motion] : sticks)
        for (std::uint32_t i = run->first; i < run->first + run->count; ++i) {
            Cylinder stick = r.cylinders[i];
            stick.a = placedAt(*motion, stick.a);
            stick.b = placedAt(*motion, stick.b);
            out.cylinders.push_back(stick);
            out.cylinderLooks.push_back(r.cylinderLooks[i]);
        }
    for (const PlacedRun& placed : triangles) writeRunOut(r, placed, out);
    std::swap(r.spheres, out.spheres);
    std::swap(r.ellipsoids, out.ellipsoids);
    std::swap(r.sphereLooks, out.sphereLooks);
    std::swap(r.cylinders, out.cylinders);
    std::swap(r.cylinderLooks, out.cylinderLooks);
    std::swap(r.triangles, out.triangles);
    std::swap(r.meshVertices, out.meshVertices);
    std::swap(r.meshLooks, out.meshLooks);
    std::swap(r.meshes, out.meshes);
    r.coarseTriangles.clear();
    r.copies = {};
    return true;
}

}  // namespace nacre
