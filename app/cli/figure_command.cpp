// `nacre figure`: pictures from one camera as the lettered panels of a figure.

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/annotation/painter.h"
#include "app/cli/batch_lines.h"
#include "app/cli/commands.h"
#include "app/cli/picture_grid.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"
#include "app/drawing/complete.h"
#include "app/drawing/drawing.h"
#include "app/files/messages.h"
#include "app/images/image_file.h"
#include "engine/error.h"
#include "engine/scene/color/palettes.h"

namespace nacre::app {
namespace {

constexpr std::size_t kMostPanels = 26;

/// Paints a panel's letter at its upper left.
void paintLetter(const WordPainter& painter, const std::string& letter, const PictureDescription& panel,
                 Picture& picture) {
    constexpr double kLarger = 1.6;  // than other words
    const double usual = panel.words.size > 0 ? panel.words.size : usualTextSize(picture.width, picture.height);
    const double size = kLarger * usual;
    View view;
    view.width = picture.width;
    view.height = picture.height;
    Marks marks = painter.layOut({}, view, size, panel.words.color, panel.background);
    marks.texts.push_back({{0.5 * size, 1.1 * size}, size, letter, 0});
    painter.paint(marks, picture.rgba.data(), picture.width, 0, picture.height);
}

std::string letterOf(PanelLetters letters, std::size_t panel) {
    if (letters == PanelLetters::off) return "";
    return std::string(1, static_cast<char>((letters == PanelLetters::capital ? 'A' : 'a') + panel));
}

std::vector<PictureDescription> panelsOf(const FigureOptions& options) {
    std::vector<PictureDescription> panels;
    BatchLines lines(options.batch.path, [] { return false; });
    while (const auto line = lines.next()) {
        if (panels.size() == kMostPanels)
            throw Error("cannot draw figure", options.batch.path,
                        "more than " + std::to_string(kMostPanels) + " panels");
        try {
            panels.push_back(panelOf(line->whole(), options));
        } catch (const UsageError& error) {
            throw Error("cannot draw figure", options.batch.path,
                        "line " + std::to_string(line->number) + ": " + error.what());
        }
    }
    if (panels.empty()) throw Error("cannot draw figure", options.batch.path, "it has no panels");
    const Size& size = panels.front().size;
    for (const PictureDescription& panel : panels)
        if (panel.size.width != size.width || panel.size.height != size.height)
            throw Error("cannot draw figure", options.batch.path, "its panels have different sizes");
    return panels;
}

/// Gives a panel the first panel's camera, unless it has its own; the scale is always the first panel's.
void shareCamera(const PictureDescription& first, PictureDescription& panel) {
    const bool own = panel.aim.any() || panel.camera.center || panel.given.contains("view") ||
                     panel.given.contains("rotate") || panel.given.contains("orientation");
    if (own) {
        panel.camera.scale = first.camera.scale;
        panel.aim.fits = true;  // centred, in that scale
        return;
    }
    panel.camera = first.camera;
    panel.aim = {};
}

}  // namespace

void figureCommand(const FigureOptions& options) {
    OutputFile file(options.output, ".png");
    std::vector<PictureDescription> panels = panelsOf(options);
    const double dpi = *panels.front().dpi;
    Progress progress;
    Canvas canvas(panels.front().device);
    WordPainter painter;
    std::optional<PictureDescription> first;
    PictureGrid figure(panels.front().size, panels.size(), static_cast<std::size_t>(options.columns),
                       static_cast<std::uint32_t>(std::lround(options.gapPoints * dpi / 72)),
                       panels.front().background);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        PictureDescription& panel = panels[i];
        if (first) shareCamera(*first, panel);
        if (i + 1 < panels.size()) panel.words.scaleBar = ScaleBar::off;  // one bar for all
        const Molecule molecule = readMoleculeAndMaps(panel, progress);
        progress.begin("drawing");
        Drawing drawing;
        drawing.prepare(molecule, panel);
        if (!first) first = drawing.placed();
        std::vector<std::string> warnings = drawing.warnings;
        Picture picture = drawing.draw(canvas, &warnings);
        for (const std::string& warning : warnings) sayWarning("panel " + std::to_string(i + 1) + ": " + warning);
        if (const std::string letter = letterOf(options.letters, i); !letter.empty())
            paintLetter(painter, letter, panel, picture);
        figure.put(i, picture);
        progress.advance(static_cast<double>(i + 1) / static_cast<double>(panels.size()));
    }
    writePicture(file, figure.picture(), formatOf(panels.front()));
}

}  // namespace nacre::app
