// Prints how far the baked occlusion is from the ray-traced one, by the number of directions, as the table of
// docs/measurements.md: occlusion_table [POINTS [RAYS [NAME]]]

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string_view>
#include <vector>

#include "tests/occlusion/scenes.h"
#include "tests/occlusion/traced_points.h"

int main(int argc, char** argv) {
    using namespace nacre;
    const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 5000;
    const std::size_t rays = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 4096;
    const std::string_view only = argc > 3 ? argv[3] : "";
    constexpr int kDirections[] = {16, 44, 128, 512};
    std::cout << "| molecule |";
    for (const int k : kDirections) std::cout << " " << k << " |";
    std::cout << " 44, the original's |\n|---|";
    for (std::size_t i = 0; i <= std::size(kDirections); ++i) std::cout << "---|";
    std::cout << std::fixed << std::setprecision(3) << "\n";
    Renderer renderer(DeviceOptions{});
    std::vector<test::OcclusionScene> scenes(std::begin(test::kLargeOcclusionScenes),
                                             std::end(test::kLargeOcclusionScenes));
    scenes.insert(scenes.end(), std::begin(test::kSmallOcclusionScenes), std::end(test::kSmallOcclusionScenes));
    scenes.insert(scenes.end(), std::begin(test::kMeshOcclusionScenes), std::end(test::kMeshOcclusionScenes));
    for (const test::OcclusionScene& s : scenes) {
        if (std::string_view(s.name).find(only) == std::string_view::npos) continue;
        if (!test::isSample(s) && !test::dataFolder()) {
            std::cerr << s.name << ": no test data (set NACRE_DATA)\n";
            continue;
        }
        const Representation scene = test::makeScene(s);
        renderer.setScene(scene);
        const auto points = test::tracePoints(renderer, scene, count, rays);
        std::cout << "| " << s.name << " |";
        for (const int k : kDirections) {
            RenderSettings settings;
            settings.occlusion.directions = k;
            std::cout << " " << test::bakedDifference(renderer, scene, settings, points).rootMeanSquare << " |"
                      << std::flush;
        }
        std::cout << " " << test::directionsDifference(scene, test::originalDirections(), points).rootMeanSquare << " |"
                  << std::endl;
    }
}
