#include "engine/occlusion/copies.h"

#include <algorithm>
#include <set>

namespace nacre {
namespace {

std::vector<glm::dmat4x3> picked(const Copies& copies, const std::vector<std::uint32_t>& which) {
    std::vector<glm::dmat4x3> transforms;
    transforms.reserve(which.size());
    for (const std::uint32_t i : which) transforms.push_back(copies.transforms[i]);
    return transforms;
}

/// Primitives of one kind, and the range of their texels.
struct Kind {
    std::span<const PrimitiveRun> copies;
    std::span<const ModelRun> models;
    std::size_t count;
    std::uint64_t firstTexel, texelsEach;
    OcclusionCopies::Run::Of of;
    float step = 1;
};

/// Vertices of a mesh with the same copies and model.
struct VertexRun {
    std::uint32_t first, end;
    std::uint32_t list, model;
    float step;
};

/// Runs of vertices by consecutive triangles. No two meshes share vertices.
std::vector<VertexRun> vertexRuns(const Representation& r) {
    std::vector<VertexRun> runs;
    auto copies = r.copies.triangles.begin();
    auto model = r.triangleModels.begin();
    for (std::uint32_t i = 0; i < r.triangles.size(); ++i) {
        const Triangle& t = r.triangles[i];
        while (copies != r.copies.triangles.end() && i >= copies->first + copies->count) ++copies;
        while (model != r.triangleModels.end() && i >= model->first + model->count) ++model;
        const std::uint32_t list = copies != r.copies.triangles.end() ? copies->list : 0;
        const std::uint32_t of = model != r.triangleModels.end() ? model->model : 0;
        if (runs.empty() || runs.back().list != list || runs.back().model != of || runs.back().step != t.step())
            runs.push_back({t.a, t.a + 1, list, of, t.step()});
        VertexRun& run = runs.back();
        run.first = std::min({run.first, t.a, t.b, t.c});
        run.end = std::max({run.end, t.a + 1, t.b + 1, t.c + 1});
    }
    return runs;
}

/// List entries of a kind's texels, by copy list and model.
class Runs {
public:
    Runs(std::span<const std::uint32_t> texels, std::vector<OcclusionCopies::Run>& runs)
        : texels_(texels), runs_(runs) {}

    /// @param groups  whether each list of copies has its own group
    void add(const Kind& kind, bool groups) {
        if (!groups) return addModels(kind, 0, kind.count, 0);
        for (const PrimitiveRun& run : kind.copies) addModels(kind, run.first, run.first + run.count, run.list);
    }

    void add(const VertexRun& run, std::uint64_t firstTexel, bool groups) {
        const Kind kind{{}, {}, 0, firstTexel, 2, OcclusionCopies::Run::Of::vertices, run.step};
        addRun(kind, run.first, run.end, groups ? run.list : 0, run.model);
    }

private:
    void addModels(const Kind& kind, std::uint64_t begin, std::uint64_t end, std::uint32_t group) {
        if (kind.models.empty()) return addRun(kind, begin, end, group, 0);
        for (const ModelRun& model : kind.models) {
            const std::uint64_t from = std::max<std::uint64_t>(begin, model.first);
            const std::uint64_t to = std::min(end, std::uint64_t{model.first} + model.count);
            if (from < to) addRun(kind, from, to, group, model.model);
        }
    }
    void addRun(const Kind& kind, std::uint64_t begin, std::uint64_t end, std::uint32_t group, std::uint32_t model) {
        const auto at = [&](std::uint64_t primitive) {
            const std::uint64_t texel = kind.firstTexel + primitive * kind.texelsEach;
            return static_cast<std::size_t>(std::lower_bound(texels_.begin(), texels_.end(), texel) - texels_.begin());
        };
        runs_.push_back({at(begin), at(end) - at(begin), kind.of, group, model, kind.step});
    }

    std::span<const std::uint32_t> texels_;
    std::vector<OcclusionCopies::Run>& runs_;
};

}  // namespace

OcclusionCopies occlusionCopies(const Representation& r, const OcclusionLayout& layout,
                                std::span<const std::uint32_t> texels) {
    OcclusionCopies result;
    const Copies& copies = r.copies;
    std::set<std::uint32_t> lists;
    for (const auto* runs : {&copies.spheres, &copies.cylinders, &copies.triangles})
        for (const PrimitiveRun& run : *runs) lists.insert(run.list);
    const bool groups = lists.size() > 1;
    if (lists.empty()) {
        result.groups = {{glm::dmat4x3(1.0)}};
    } else if (!groups) {
        const std::vector<std::uint32_t>& list = copies.lists[*lists.begin()];
        result.groups = {picked(copies, representativeCopies(copies.transforms, list, r.radius))};
    } else {
        for (const std::vector<std::uint32_t>& list : copies.lists) result.groups.push_back(picked(copies, list));
    }
    Runs runs(texels, result.runs);
    using Of = OcclusionCopies::Run::Of;
    const std::uint64_t ofSphere = std::uint64_t{layout.sphereEdge} * layout.sphereEdge;
    runs.add({copies.spheres, r.sphereModels, r.spheres.size(), 0, ofSphere, Of::spheres}, groups);
    const std::uint64_t ofCylinder = std::uint64_t{layout.around} * layout.along;
    runs.add({copies.cylinders, r.cylinderModels, r.cylinders.size(), layout.sphereTexels(), ofCylinder, Of::cylinders},
             groups);
    for (const VertexRun& run : vertexRuns(r)) runs.add(run, layout.patchTexels(), groups);
    return result;
}

}  // namespace nacre
