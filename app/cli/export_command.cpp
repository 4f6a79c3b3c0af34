// `nacre export`: the drawn scene as triangles in a file for other programs.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/drawing/drawing.h"
#include "app/drawing/map_layers.h"
#include "app/drawing/scenes.h"
#include "app/export/scene_files.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "app/files/output_file.h"
#include "app/mvs/write_scene.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/renderer.h"
#include "engine/scene/build/chunks.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app {
namespace {

/// For one copy of each part, in Å.
std::string exportStats(const ExportScene& scene, std::size_t bytes) {
    nlohmann::ordered_json parts = nlohmann::ordered_json::array();
    for (const ExportMesh& part : scene.meshes) {
        const MeshMeasures measures = measure(part.mesh);
        parts.push_back({{"name", part.name},
                         {"copies", part.transforms.size()},
                         {"vertices", part.mesh.positions.size()},
                         {"triangles", part.mesh.triangles.size()},
                         {"area", measures.area},
                         {"volume", measures.volume}});
    }
    for (const ExportInstances& part : scene.instances)
        parts.push_back({{"name", part.name}, {"copies", part.transforms.size()}, {"instances", part.places.size()}});
    return jsonText({{"triangles", triangleCount(scene)}, {"bytes", bytes}, {"parts", parts}});
}

/// Sorts the scene in the renderer's order, and bakes it.
BakedOcclusion bakedOcclusion(const ExportCommandOptions& options, Representation& scene, Progress& progress) {
    if (options.picture.occlusion.directions == 0) return {};
    progress.begin("baking occlusion");
    orderInSpace(scene);
    Renderer renderer(options.picture.device);
    renderer.setScene(scene);
    OcclusionSettings settings;
    settings.directions = options.picture.occlusion.directions;
    settings.onProgress = [&](double share) { progress.advance(share); };
    return renderer.bakedOcclusion(settings);
}

/// The picture as MolViewSpec; notes list what it cannot express.
void writeMolViewSpec(const Molecule& molecule, const ExportCommandOptions& options, OutputFile& file) {
    PictureDescription picture = options.picture;
    Drawing drawing;
    drawing.prepare(molecule, picture);
    picture.background = drawing.settings.background;
    const mvs::WrittenScene written =
        mvs::writeScene(molecule, picture, sceneVolumes(picture),
                        makeCamera(drawing.settings.view, drawing.run.center, !molecule.guide), picture.output);
    for (const std::string& note : written.notes) sayNote(note);
    writeText(file, written.json);
}

}  // namespace

void exportCommand(const ExportCommandOptions& options) {
    OutputFile file(options.picture.output);
    std::optional<OutputFile> stats;
    if (!options.picture.stats.empty()) stats.emplace(options.picture.stats, ".json");
    Progress progress;
    const Molecule molecule = readMoleculeAndMaps(options.picture, progress);
    progress.begin("building the scene");
    if (fileExtension(options.picture.output) == ".mvsj") return writeMolViewSpec(molecule, options, file);
    Representation scene = buildScene(molecule, options.picture);
    addMapSurfaces(molecule, options.picture, scene);
    for (const std::string& warning : scene.warnings) sayWarning(warning);
    const BakedOcclusion baked = bakedOcclusion(options, scene, progress);
    ExportOptions how = options.scene;
    if (options.picture.occlusion.directions > 0) how.occlusion = &baked;
    const ExportScene exported = exportScene(molecule, scene, how);
    progress.begin("writing");
    const std::string& title = molecule.file.title;
    const SceneFileOptions titled{
        title.empty() ? std::filesystem::path(options.picture.input.path).filename().string() : title, options.scale};
    const std::string bytes = sceneFile(exported, fileExtension(options.picture.output), titled);
    writeText(file, bytes);
    if (stats) writeText(*stats, exportStats(exported, bytes.size()));
}

}  // namespace nacre::app
