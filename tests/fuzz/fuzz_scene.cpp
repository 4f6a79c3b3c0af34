// libFuzzer target for MolViewSpec scenes: JSON or an archive, with a structure in place of all that it names. Any
// bytes are drawn or refused by one of the exceptions that the program shows.

#include <string>

#include "app/mvs/build_scene.h"
#include "app/mvs/scene_file.h"
#include "engine/error.h"
#include "engine/scene/build/scene_layers.h"

namespace {

const char* const kStructure =
    "ATOM      1  N   ALA A   1       1.000   2.000   3.000  1.00  0.00           N\n"
    "ATOM      2  CA  ALA A   1       2.000   2.000   3.000  1.00  0.00           C\n"
    "HETATM    3 ZN    ZN A   2       6.000   2.000   3.000  1.00  0.00          ZN\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    using namespace nacre;
    try {
        const std::string bytes(reinterpret_cast<const char*>(data), size);
        if (!app::mvs::isScene(bytes)) return 0;
        const app::mvs::SceneFile scene("input", bytes);
        app::mvs::SceneSources sources;
        sources.fetch = [&](const std::string& uri) {
            return uri.ends_with(".json") ? std::string(R"([{"auth_asym_id": "A", "color": "red"}])") : kStructure;
        };
        const Molecule molecule = app::mvs::buildScene(scene.tree, 0, scene.name, sources);
        const ResidueFacts facts(molecule);
        const GuidedLayers layers = guidedLayers(facts, {}, {});
        representLayers(facts, layers, {}, computeBounds(molecule, layers.layers));
    } catch (const Error&) {
    }
    return 0;
}
