// `nacre looks`: lists the looks, or draws a sheet of a molecule in every look, with captions.

#include <algorithm>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/drawing/drawing.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "app/images/image_file.h"
#include "app/picture/looks.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

/// Cells side by side, rows from the top, with a white line between them.
class Sheet {
public:
    Sheet(const Size& cell, std::size_t cells, std::size_t columns)
        : cell_(cell), columns_(std::min(cells, columns)), line_(std::max(cell.width / 64, 1u)) {
        const auto side = [&](std::size_t count, std::uint32_t pixels) {
            return static_cast<std::uint32_t>(count * (pixels + line_) - line_);
        };
        picture_.width = side(columns_, cell.width);
        picture_.height = side((cells + columns_ - 1) / columns_, cell.height);
        picture_.rgba.assign(std::size_t{4} * picture_.width * picture_.height, 1.0f);
    }

    void put(std::size_t index, const Picture& picture) {
        const std::size_t left = index % columns_ * (cell_.width + line_),
                          top = index / columns_ * (cell_.height + line_);
        for (std::size_t y = 0; y < picture.height; ++y)
            std::copy_n(&picture.rgba[4 * y * picture.width], 4 * picture.width,
                        &picture_.rgba[4 * ((top + y) * picture_.width + left)]);
    }
    const Picture& picture() const { return picture_; }

private:
    Size cell_;
    std::size_t columns_;
    std::uint32_t line_;
    Picture picture_;
};

void drawSheet(const LooksOptions& options) {
    OutputFile file(options.picture.output, ".png");
    Progress progress;
    const Molecule molecule = readMoleculeAndMaps(options.picture, progress);
    progress.begin("drawing");
    Canvas canvas(options.picture.device);
    Drawing drawing;
    Sheet sheet(options.picture.size, looks().size(), static_cast<std::size_t>(options.columns));
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
