// `nacre looks`: lists the looks, or draws a sheet of a molecule in every look, with captions.

#include <algorithm>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/picture_grid.h"
#include "app/cli/progress.h"
#include "app/drawing/drawing.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "app/images/image_file.h"
#include "app/picture/looks.h"

namespace nacre::app {
namespace {

void drawSheet(const LooksOptions& options) {
    OutputFile file(options.picture.output, ".png");
    Progress progress;
    const Molecule molecule = readMoleculeAndMaps(options.picture, progress);
    progress.begin("drawing");
    Canvas canvas(options.picture.device);
    Drawing drawing;
    const Size& cell = options.picture.size;
    PictureGrid sheet(cell, looks().size(), static_cast<std::size_t>(options.columns), std::max(cell.width / 64, 1u),
                      {1, 1, 1, 1});
    std::size_t done = 0;
    for (const Look& look : looks()) {
        PictureDescription one = options.picture;
        applyLook(look, one);
        one.words.title = look.name;
        drawing.prepare(molecule, one);
        if (done == 0)
            for (const std::string& warning : drawing.warnings) sayWarning(warning);
        sheet.put(done, drawing.draw(canvas));
        progress.advance(static_cast<double>(++done) / static_cast<double>(looks().size()));
    }
    writePicture(file, sheet.picture(), {});
}

}  // namespace

void looksCommand(const LooksOptions& options, std::ostream& out) {
    if (!options.picture.output.empty()) return drawSheet(options);
    if (options.json) {
        nlohmann::ordered_json all;
        for (const Look& look : looks()) all[look.name] = nlohmann::ordered_json::parse(lookJson(look));
        out << jsonText(all);
        return;
    }
    std::size_t widest = 0;
    for (const Look& look : looks()) widest = std::max(widest, look.name.size());
    for (const Look& look : looks())
        out << look.name << std::string(widest + 2 - look.name.size(), ' ') << look.about << "\n";
}

}  // namespace nacre::app
