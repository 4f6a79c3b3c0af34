#include "engine/scene/build/join_parts.h"

namespace nacre {
namespace {

template <typename T>
void appendTo(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void appendShifted(std::vector<Triangle>& list, const std::vector<Triangle>& more, std::uint32_t firstVertex) {
    for (Triangle t : more) {
        t.a += firstVertex, t.b += firstVertex, t.c += firstVertex;
        list.push_back(t);
    }
}

}  // namespace

void appendPart(Representation& whole, const Representation& part) {
    appendTo(whole.spheres, part.spheres);
    appendTo(whole.sphereLooks, part.sphereLooks);
    appendTo(whole.cylinders, part.cylinders);
    appendTo(whole.cylinderLooks, part.cylinderLooks);
    appendTo(whole.wires, part.wires);
    appendTo(whole.wireLooks, part.wireLooks);
    const auto vertices = static_cast<std::uint32_t>(whole.meshVertices.size()),
               looks = static_cast<std::uint32_t>(whole.meshLooks.size()),
               triangles = static_cast<std::uint32_t>(whole.triangles.size()),
               coarse = static_cast<std::uint32_t>(whole.coarseTriangles.size());
    for (MeshVertex v : part.meshVertices) {
        v.look += looks;
        whole.meshVertices.push_back(v);
    }
    appendTo(whole.meshLooks, part.meshLooks);
    appendShifted(whole.triangles, part.triangles, vertices);
    appendShifted(whole.coarseTriangles, part.coarseTriangles, vertices);
    for (MeshRun run : part.meshes) {
        run.first += triangles;
        run.firstVertex += vertices, run.endVertex += vertices;
        for (MeshRun::Level& level : run.levels) level.first += coarse, level.endVertex += vertices;
        whole.meshes.push_back(std::move(run));
    }
}

}  // namespace nacre
