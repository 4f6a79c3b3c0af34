#include "engine/software/host_lists.h"

#include <algorithm>

#include "engine/passes/view_constants.h"
#include "engine/software/software.h"
#include "engine/software/tile_lists.h"

namespace nacre::passes {

static_assert(TileLists::kDepthSteps == layout::kListSteps);
static_assert(TileView::kNoPlane == layout::kNoPlane);

TileView tileView(const SceneView& seen, const View& view, graph::Extent image, bool centers) {
    const layout::ViewConstants& c = seen.constants;
    TileView v{screenView(c, view, image.width, image.height)};
    if (seen.effects.clip.on()) v.clipNear = c.clipNear, v.clipFar = c.clipFar;
    v.contour = std::max(c.contourWidth, seen.rims.widest());
    v.wireScale = seen.wireScale;
    v.centers = centers;
    v.frontsOnly = seen.frontsOnly;
    return v;
}

namespace {

void listCalls(const SceneView& seen, const std::vector<PlacedCopies::Call>& calls, std::uint32_t first,
               std::vector<TileCall>& list) {
    list.clear();
    for (const PlacedCopies::Call& c : calls)
        list.push_back({&seen.copies.rows[3 * std::size_t{c.copy}], c.first, c.count,
                        c.copy * seen.constants.primitives + first + 1});
}

class SoftwareLists final : public HostLists {
public:
    TileLists lists;

    const TileSet& tiles() const override { return lists; }
    std::uint32_t longest() const override { return lists.longest(); }
    TileCounts counts() const override {
        return {lists.tiles().size(), lists.kept(), lists.keptSpheres(), lists.entries(), lists.longest()};
    }
    bool holds(std::size_t bin) const override { return lists.holds(bin); }
    std::size_t words() const override { return lists.words(); }
    void write(std::uint32_t* to) override { lists.write(to); }
    bool seeded() const override { return lists.seeded(); }
    void writeSeeds(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const override {
        lists.writeSeeds(x, y, count, to);
    }
};

class SoftwareLister final : public HostLister {
public:
    std::unique_ptr<HostLists> makeLists() const override { return std::make_unique<SoftwareLists>(); }
    void build(HostLists& lists, const ListedView& view, const TileWork& work) override;

private:
    const SphereBoxes& sceneBoxes(const Representation& r, const SceneView& seen);

    std::vector<TileCall> spheres_, cylinders_, triangles_;  // scratch of one frame
    std::weak_ptr<const void> boxed_;                        // the scene of the boxes
    SphereBoxes boxes_;
};

/// Made when the host first draws a scene's spheres. Kept when only colours change.
const SphereBoxes& SoftwareLister::sceneBoxes(const Representation& r, const SceneView& seen) {
    if (!seen.owner || boxed_.lock() != seen.owner) {
        boxes_ = makeSphereBoxes(r);
        boxed_ = seen.owner;
    }
    return boxes_;
}

void SoftwareLister::build(HostLists& lists, const ListedView& v, const TileWork& work) {
    const Representation& r = v.representation;
    const SceneView& seen = v.seen;
    listCalls(seen, seen.copies.spheres, 0, spheres_);
    listCalls(seen, seen.copies.cylinders, seen.constants.spheres, cylinders_);
    listCalls(seen, seen.copies.triangles, seen.constants.spheres + seen.constants.cylinders, triangles_);
    const SphereBoxes* boxes = work.frontSpheres ? &sceneBoxes(r, seen) : nullptr;
    const TileScenery scenery{r.spheres,      spheres_,   r.cylinders,       cylinders_, r.wires, r.triangles,
                              r.meshVertices, triangles_, r.coarseTriangles, r.meshes,   boxes,   work.triangleChunks};
    TileView asked = tileView(seen, v.view, v.image, !work.edges && !work.subsamples && !work.marksSmall);
    asked.layers = work.result == TileResult::layers;
    asked.edges = work.edges;
    asked.small = work.small();
    asked.mask = work.mask;
    static_cast<SoftwareLists&>(lists).lists.build(asked, scenery);
}

}  // namespace

std::unique_ptr<HostLister> makeHostLister() { return std::make_unique<SoftwareLister>(); }

}  // namespace nacre::passes
