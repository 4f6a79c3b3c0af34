#include "app/cli/bench_shapes.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

namespace nacre::app {
namespace {

struct Variant {
    const char* plates;
    PlateShape plateShape;
    const char* impostor;
    ImpostorShape impostorShape;
};
constexpr Variant kVariants[] = {{"off", PlateShape::none, "octagon", ImpostorShape::octagon},
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

/// One sample a pixel.
RenderSettings shapeFrame(const BenchOptions& options, double radius, int frame) {
    RenderSettings settings = benchFrame(options, radius, frame);
    settings.supersample = 1;
    return settings;
}

}  // namespace

Json compareShapes(const BenchOptions& options, const Representation& scene, Renderer& encoded, Progress& progress) {
    Json rows = Json::array();
    for (const Variant& variant : kVariants) {
        RenderSettings settings = shapeFrame(options, scene.radius, 0);
        settings.tuning.plates = variant.plateShape;
        settings.tuning.impostor = variant.impostorShape;
        settings.tuning.countFragments = true;
        encoded.render(settings);
        const FrameStats stats = encoded.stats();
        Json passes = Json::array();
        for (const PassCount& pass : stats.passes)
            passes.push_back({{"name", pass.name}, {"shaded_fragments", pass.shadedFragments}});
        rows.push_back({{"plates", variant.plates},
                        {"impostor", variant.impostor},
                        {"visible", stats.coveredPixels},
                        {"passes", passes}});
    }
    // In turns, so that the machine's moods meet all of them.
    std::vector<std::vector<double>> samples(std::size(kVariants));
    BenchRounds rounds(options, 2);
    for (int frame = -1; rounds.goesOn(frame); ++frame) {
        progress.advance(rounds.share(frame));
        for (std::size_t i = 0; i < std::size(kVariants); ++i) {
            RenderSettings settings = shapeFrame(options, scene.radius, std::max(frame, 0));
            settings.tuning.plates = kVariants[i].plateShape;
            settings.tuning.impostor = kVariants[i].impostorShape;
            const double ms = encoded.drawFrame(settings);
            if (frame >= 0) samples[i].push_back(ms);
            rounds.spend(ms);
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i]["frame"] = timesJson(samples[i]);
    return rows;
}

void printShapes(const Json& shapes, std::ostream& out) {
    out << "\nshaded fragments per visible pixel, encoded path\nplates      impostor  prepass  encoding  colour  cut "
           "by  frame ms min\n";
    double off = 0;
    for (const Json& row : shapes) {
        const double visible = std::max(row["visible"].get<double>(), 1.0);
        const auto shaded = [&](std::string_view name) {
            for (const Json& pass : row["passes"])
                if (pass["name"] == name) return pass["shaded_fragments"].get<double>() / visible;
            return 0.0;  // a prepass of no plates is none
        };
        const double prepass = shaded("opaque prepass"), encoding = shaded("depth encoding"),
                     color = shaded("impostor colour"), costly = encoding + color;
        if (off == 0) off = costly;
        out << std::left << std::setw(12) << row["plates"].get<std::string>() << std::setw(8)
            << row["impostor"].get<std::string>() << std::right << std::setw(7) << prepass << std::setw(10) << encoding
            << std::setw(8) << color << std::setw(8) << off / costly << std::setw(14)
            << row["frame"]["min"].get<double>() << "\n";
    }
}

}  // namespace nacre::app
