// Prints how far the light of clefts is from paths that bounce from surface to surface, without and with --bounce, as
// the table of docs/ambient_occlusion.md: bounce_table [PIXELS [PATHS]]

#include <cstdlib>
#include <functional>
#include <iomanip>
#include <iostream>

#include "tests/occlusion/traced_light.h"
#include "tests/support/test_data.h"

int main(int argc, char** argv) {
    using namespace nacre;
    const std::size_t pixels = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 3000;
    const std::size_t paths = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 2048;
    if (!test::dataFolder()) {
        std::cerr << "no test data (set NACRE_DATA)\n";
        return EXIT_FAILURE;
    }
    struct Row {
        const char* name;
        std::function<test::Lit()> lit;
    };
    const Row rows[] = {{"`sample:dna` by element", test::dna},
                        {"4HHB by chain", [] { return test::hemoglobin(ColorScheme::chain); }},
                        {"4HHB by element", [] { return test::hemoglobin(ColorScheme::element); }},
                        {"pocket of 1HPV by chain", [] { return test::pocket(ColorScheme::chain); }},
                        {"pocket of 1HPV by element", [] { return test::pocket(ColorScheme::element); }}};
    std::cout << "| molecule | off | on |\n|---|---|---|\n" << std::fixed << std::setprecision(4);
    for (const Row& row : rows) {
        const test::Lit lit = row.lit();
        Renderer renderer(DeviceOptions{});
        renderer.setScene(lit.scene);
        RenderSettings settings = lit.settings;
        settings.fine = true;
        settings.occlusion.directions = 128;
        settings.effects.light = test::ambientAlone();
        const test::TracedLight truth = test::traceLight(lit, renderer.layers(settings), test::sky(), pixels, paths);
        const double before = test::lightError(renderer.render(settings).rgba, truth);
        settings.occlusion.bounce = true;
        const double after = test::lightError(renderer.render(settings).rgba, truth);
        std::cout << "| " << row.name << " | " << before << " | " << after << " |" << std::endl;
    }
    return EXIT_SUCCESS;
}
