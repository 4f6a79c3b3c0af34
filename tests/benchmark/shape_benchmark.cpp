// What the shapes of plates and impostors shade and take: shape_benchmark FILE [WxH...] (640x960), on the device that
// VK_DRIVER_FILES names, by the encoded path, without occlusion. Prints JSON: a list with an object for each size, and
// in it one for each pair of shapes, with the fragments that each pass shades and milliseconds of a frame, the least of
// five.

#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace {

using namespace nacre;
using Json = nlohmann::ordered_json;

struct Shapes {
    const char* plates;
    PlateShape plateShape;
    const char* impostor;
    ImpostorShape impostorShape;
};
constexpr Shapes kShapes[] = {{"off", PlateShape::none, "octagon", ImpostorShape::octagon},
                              {"square", PlateShape::square, "octagon", ImpostorShape::octagon},
                              {"octagon", PlateShape::octagon, "octagon", ImpostorShape::octagon},
                              {"dome of 2", PlateShape::dome2, "octagon", ImpostorShape::octagon},
                              {"dome of 3", PlateShape::dome3, "octagon", ImpostorShape::octagon},
                              {"octagon", PlateShape::octagon, "pyramid", ImpostorShape::pyramid},
                              {"dome of 2", PlateShape::dome2, "pyramid", ImpostorShape::pyramid},
                              {"dome of 3", PlateShape::dome3, "pyramid", ImpostorShape::pyramid},
                              {"off", PlateShape::none, "square", ImpostorShape::square},
                              {"square", PlateShape::square, "square", ImpostorShape::square},
                              {"octagon", PlateShape::octagon, "square", ImpostorShape::square}};

RenderSettings makeSettings(const View& view, const Shapes& shapes) {
    RenderSettings settings{.view = view, .supersample = 1};
    settings.occlusion.directions = 0;
    settings.tuning.plates = shapes.plateShape;
    settings.tuning.impostor = shapes.impostorShape;
    return settings;
}

Json counted(Renderer& renderer, RenderSettings settings, const Shapes& shapes) {
    settings.tuning.countFragments = true;
    renderer.render(settings);
    Json row{{"plates", shapes.plates},
             {"impostor", shapes.impostor},
             {"visible", renderer.stats().coveredPixels},
             {"passes", Json::array()}};
    for (const PassCount& pass : renderer.stats().passes)
        row["passes"].push_back({{"name", pass.name}, {"shaded_fragments", pass.shadedFragments}});
    return row;
}

Json measureShapes(Renderer& renderer, const View& view) {
    constexpr int kRounds = 5;
    Json rows = Json::array();
    for (const Shapes& shapes : kShapes) rows.push_back(counted(renderer, makeSettings(view, shapes), shapes));
    // In turns, so that the machine's moods meet all of them; the first round warms up.
    for (int round = 0; round <= kRounds; ++round)
        for (std::size_t i = 0; i < std::size(kShapes); ++i) {
            const double ms = renderer.drawFrame(makeSettings(view, kShapes[i]));
            if (round == 1 || (round > 1 && ms < rows[i]["ms"])) rows[i]["ms"] = ms;
        }
    return rows;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) throw std::runtime_error("shape_benchmark FILE [WxH...]");
    const Molecule molecule = readMoleculeFile(argv[1]);
    const Representation scene = represent(molecule, drawnAtoms(molecule), {Style::spacefill});
    Renderer renderer(DeviceOptions{.visibility = Visibility::encoded});
    renderer.setScene(scene);
    std::vector<std::string> sizes(argv + 2, argv + argc);
    if (sizes.empty()) sizes = {"640x960"};
    Json report = Json::array();
    for (const std::string& size : sizes) {
        unsigned width = 0, height = 0;
        if (std::sscanf(size.c_str(), "%ux%u", &width, &height) != 2) throw std::runtime_error(size + " is no WxH");
        report.push_back({{"size", {width, height}},
                          {"atoms", scene.drawnAtoms},
                          {"shapes", measureShapes(renderer, makeView(Camera(), scene.radius, width, height))}});
    }
    std::puts(report.dump(1).c_str());
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "shape_benchmark: %s\n", error.what());
    return 1;
}
