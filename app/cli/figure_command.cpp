// `nacre figure`: pictures from one camera as the lettered panels of a figure.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "app/annotation/painter.h"
#include "app/cli/batch_lines.h"
#include "app/cli/commands.h"
#include "app/cli/picture_grid.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"
#include "app/drawing/aim.h"
#include "app/drawing/drawing.h"
#include "app/files/messages.h"
#include "app/images/image_file.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::size_t kMostPanels = 26;

/// Paints a panel's letter at its upper left.
void paintLetter(const WordPainter& painter, const std::string& letter, const PictureDescription& panel,
                 Picture& picture) {
    constexpr double kLarger = 1.6;  // than other text
    const double usual = panel.words.size > 0 ? panel.words.size : usualTextSize(picture.width, picture.height);
    const double size = kLarger * usual;
    View view{.width = picture.width, .height = picture.height};
    Marks marks = painter.layOut({}, view, size, panel.words.color, panel.background);
    marks.texts.push_back({{0.5 * size, 1.1 * size}, size, letter, 0});
    painter.paint(marks, picture.rgba.data(), picture.width, 0, picture.height);
}

std::string panelLetter(PanelLetters letters, std::size_t panel) {
    if (letters == PanelLetters::off) return "";
    return std::string(1, static_cast<char>((letters == PanelLetters::capital ? 'A' : 'a') + panel));
}

struct Panel {
    PictureDescription picture;
    PanelLine line;
    Molecule molecule;
    Drawing drawing;
};

std::vector<std::unique_ptr<Panel>> readPanels(const FigureOptions& options) {
    std::vector<std::unique_ptr<Panel>> panels;
    BatchLines lines(options.batch.path, [] { return false; });
    while (const auto line = lines.next()) {
        if (panels.size() == kMostPanels)
            throw Error("cannot draw figure", options.batch.path,
                        "more than " + std::to_string(kMostPanels) + " panels");
        auto panel = std::make_unique<Panel>();
        try {
            panel->picture = parsePanel(line->whole(), options, panel->line);
        } catch (const UsageError& error) {
            throw Error("cannot draw figure", options.batch.path,
                        "line " + std::to_string(line->number) + ": " + error.what());
        }
        panels.push_back(std::move(panel));
    }
    if (panels.empty()) throw Error("cannot draw figure", options.batch.path, "it has no panels");
    panels.front()->line = {.scaleBar = panels.front()->line.scaleBar};  // its camera is the figure's
    const Size& size = panels.front()->picture.size;
    for (const auto& panel : panels)
        if (panel->picture.size.width != size.width || panel->picture.size.height != size.height)
            throw Error("cannot draw figure", options.batch.path, "its panels have different sizes");
    return panels;
}

/// A panel with the first panel's camera, or its own if its line sets one. The scale is the figure's, unless the line
/// sets one.
PictureDescription withCamera(const Panel& panel, const Camera& shared) {
    PictureDescription picture = panel.picture;
    const Camera own = picture.camera;
    Aim& aim = picture.aim;
    if (panel.line.aims) {
        if (!panel.line.turns) {
            picture.camera.orientation = shared.orientation;
            if (!panel.line.rotates) picture.camera.rotationDegrees = shared.rotationDegrees;
            aim.principal = false;
            aim.lookAt.reset();
        }
        if (panel.line.scales) return picture;
        picture.camera.scale = shared.scale;
        picture.camera.zoom = shared.zoom;
        picture.given.insert("scale");  // also of a close-up
        aim.fits = true;                // centred, at that scale
        return picture;
    }
    picture.camera = shared;
    aim.uncover = uncoveredBy(aim);
    for (std::optional<Selection>* part : {&aim.orientBy, &aim.left, &aim.center, &aim.lookAt, &aim.zoomTo})
        part->reset();
    aim.principal = aim.fromSide = aim.fits = false;
    if (!panel.line.scales) return picture;
    if (own.scale) picture.camera.scale = own.scale;
    picture.camera.zoom = own.zoom;
    return picture;
}

/// Whether a panel shows its whole molecule at the figure's scale.
bool isWhole(const Panel& panel) { return !panel.line.scales && !panel.picture.aim.zoomTo; }

/// The camera of the panels: the first one's, moved back so that every panel fits. The panel that needs the most room,
/// including its words, decides.
Camera makeCamera(const std::vector<std::unique_ptr<Panel>>& panels) {
    const PictureDescription& first = panels.front()->picture;
    Camera shared = panels.front()->drawing.placed().camera;
    if (!first.aim.fits || !isWhole(*panels.front())) return shared;
    const auto tried = [](Panel& panel, PictureDescription picture) {
        picture.camera.scale.reset();
        picture.camera.zoom = 1;
        picture.given.erase("scale");
        picture.aim.fits = true;
        panel.drawing.prepare(panel.molecule, picture);
        return panel.drawing.placed().camera;
    };
    const Camera side = shared;
    for (const auto& panel : panels) {
        if (panel->line.aims || !isWhole(*panel) || panel->picture.input.path != first.input.path) continue;
        PictureDescription picture = withCamera(*panel, side);
        picture.camera.center = first.camera.center;
        picture.camera.pan = glm::dvec2(0);
        picture.camera.eyeDistance.reset();
        const Camera camera = tried(*panel, std::move(picture));
        if (camera.scale->value > shared.scale->value) shared = camera;
    }
    Camera middle = shared;  // centred on the picture's middle
    *middle.center -= glm::conjugate(middle.orientation) * glm::dvec3(middle.pan, 0);
    middle.pan = glm::dvec2(0);
    for (const auto& panel : panels)
        if (isWhole(*panel))
            shared.scale->value = std::max(shared.scale->value, tried(*panel, withCamera(*panel, middle)).scale->value);
    return shared;
}

}  // namespace

void figureCommand(const FigureOptions& options) {
    OutputFile file(options.output, ".png");
    const std::vector<std::unique_ptr<Panel>> panels = readPanels(options);
    const PictureDescription& first = panels.front()->picture;
    const auto bar = std::find_if(panels.rbegin(), panels.rend(), [](const auto& p) { return !p->line.scales; });
    Progress progress;
    Canvas canvas(first.device);
    WordPainter painter;
    for (const auto& panel : panels) {
        if (!panel->line.scales && !panel->line.scaleBar && panel != *bar)
            panel->picture.words.scaleBar = ScaleBar::off;  // one per scale
        panel->molecule = readMoleculeAndMaps(panel->picture, progress);
    }
    progress.begin("drawing");
    panels.front()->drawing.prepare(panels.front()->molecule, first);
    const Clip clip = panels.front()->drawing.placed().effects.clip;
    const Camera camera = makeCamera(panels);
    PictureGrid figure(first.size, panels.size(), static_cast<std::size_t>(options.columns),
                       static_cast<std::uint32_t>(std::lround(options.gapPoints * *first.dpi / 72)), first.background);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        Panel& panel = *panels[i];
        PictureDescription shown = withCamera(panel, camera);
        if (!panel.line.aims && !panel.line.clips) shown.effects.clip = clip;
        panel.drawing.prepare(panel.molecule, shown);
        std::vector<std::string> warnings = panel.drawing.warnings;
        Picture picture = panel.drawing.draw(canvas, &warnings);
        for (const std::string& warning : warnings) sayWarning("panel " + std::to_string(i + 1) + ": " + warning);
        if (const std::string letter = panelLetter(options.letters, i); !letter.empty())
            paintLetter(painter, letter, shown, picture);
        figure.put(i, picture);
        panel.drawing.forget();
        progress.advance(static_cast<double>(i + 1) / static_cast<double>(panels.size()));
    }
    writePicture(file, figure.picture(), chooseFormat(first));
}

}  // namespace nacre::app
