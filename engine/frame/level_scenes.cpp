#include "engine/frame/level_scenes.h"

#include <algorithm>

#include "engine/passes/view_constants.h"

namespace nacre {
namespace {

ScreenView makeScreenView(const View& view, const RenderSettings& settings) {
    const graph::Extent image = imageExtent(view);
    const layout::ViewConstants c = passes::viewConstants(view, image.width / 2.0, image.height / 2.0);
    ScreenView v = passes::screenView(c, view, image.width, image.height);
    const Clip& clip = settings.effects.clip;
    if (clip.on()) {
        v.clipNear = std::max(v.origin + static_cast<float>(clip.near), -ScreenView::kNoPlane);
        v.clipFar = std::min(v.origin + static_cast<float>(clip.far), ScreenView::kNoPlane);
    }
    return v;
}

}  // namespace

std::uint32_t LevelScenes::chooseGrid(std::uint32_t width, std::uint32_t height) {
    static_assert(RenderSettings::kEdgeSamples == RenderSettings::kBlockSamples * RenderSettings::kBlockSamples);
    constexpr std::uint64_t kMostPlaces = std::uint64_t{1} << 26;  // 512 MB
    std::uint32_t grid = RenderSettings::kBlockSamples;
    while (grid > 1 && std::uint64_t{width} * height * grid * grid > kMostPlaces) grid /= 2;
    return grid;
}

bool LevelScenes::draws(const Representation& r, const RenderSettings& settings) {
    if (!canHaveLevels(r)) return false;
    if (!hasNumbers(r)) return true;
    return settings.occlusion.directions == 0 && spheresInCopies(r) >= settings.levelsFrom;
}

Representation LevelScenes::shownBy(const Representation& whole, const RenderSettings& settings, const View& view,
                                    bool edges) {
    const ScreenView seen = makeScreenView(view, settings);
    const float samples = edges ? RenderSettings::kBlockSamples : 1;
    copies_.draw(seen, {levels_, whole.copies, view.rotation, view.shift},
                 static_cast<float>(settings.levelError) / samples, edges ? chooseGrid(seen.width, seen.height) : 1,
                 edges);
    Representation r;
    r.spheres.assign(copies_.spheres().begin(), copies_.spheres().end());
    r.sphereLooks.assign(copies_.looks().begin(), copies_.looks().end());
    r.ownMaterials = whole.ownMaterials;
    r.atomGroups = whole.atomGroups;
    r.center = whole.center;
    r.radius = whole.radius;
    return r;
}

Representation LevelScenes::show(const Representation& whole, const RenderSettings& settings, const View& view) {
    leveled_.reset();
    levels_ = makeSphereLevels(whole);
    return shownBy(whole, settings, view, false);
}

std::shared_ptr<const Scene> LevelScenes::show(const gpu::Device& device, const std::shared_ptr<const Scene>& scene,
                                               const RenderSettings& settings, const View& view, bool edges) {
    if (leveled_.lock() != scene) {
        levels_ = makeSphereLevels(scene->representation);
        leveled_ = scene;
    }
    return std::make_shared<const Scene>(
        makeOrderedScene(device, shownBy(scene->representation, settings, view, edges)));
}

std::vector<CopyLevelCount> LevelScenes::counts() const {
    std::vector<CopyLevelCount> counts;
    for (const SeenCopies::LevelCount& l : copies_.levels())
        counts.push_back({static_cast<double>(l.error), l.copies, l.spheres});
    return counts;
}

}  // namespace nacre
