// How the molecule is represented: style, colours, rules, meshes, and which atoms are drawn.

#include "app/picture/appearance_values.h"
#include "app/picture/interaction_values.h"
#include "app/picture/rows.h"

namespace nacre::app {
namespace {

using P = PictureDescription;
using R = RepresentationOptions;
using T = std::string_view;
using enum Option::Kind;
using enum Option::Save;

inline constexpr std::array<const char*, 2> kAllModel{"all", "model"}, kOwnAll{"own", "all"};
inline constexpr std::array<const char*, 3> kBondOrders{"off", "ligands", "on"};
inline constexpr std::array<const char*, 2> kAromaticForms{"dashes", "ring"};
inline constexpr std::array<const char*, 3> kHelixForms{"ribbon", "tube", "cylinder"};
inline constexpr std::array<const char*, 3> kCarbohydrates{"off", "on", "icon"};
inline constexpr std::array<const char*, 4> kBaseForms{"plates", "rings", "ladder", "none"};
inline constexpr Words2 kDashedOff = {"dashed", "off"};
inline constexpr std::array<const char*, 3> kSurfaceForms{"solid", "mesh", "dots"};
inline constexpr std::array<const char*, 2> kEllipsoidForms{"bands", "octants"};
inline constexpr std::array<const char*, 3> kSurfaceKinds{"excluded", "accessible", "gaussian"};

T parseAssembly(T text) {
    if (text.empty()) throw std::invalid_argument("expected an assembly's identifier");
    return text;
}

void parseAnyStyle(T text, P& d) {
    if (text == "auto") return d.look.style.reset();
    setStyle(parseStyle(text), d.look);
}

std::vector<Option> whole() {
    std::vector<Option> rows{
        {.key = "camera",
         .syntax = "all|model",
         .standard = "all",
         .help = "In a file with several models: one camera for all of them, or each model's own",
         .value = choiceOf<kAllModel, &P::look, &R::ownFrame>(),
         .save = differing},
        {.key = "occlusion-models",
         .syntax = "own|all",
         .standard = "own",
         .help = "When models are drawn together: ambient occlusion within each model only, or by all models",
         .value = choiceOf<kOwnAll, &P::look, &R::modelsOcclude>(),
         .save = differing},
        {.key = "assembly",
         .syntax = "ID",
         .standard = "none: the file's atoms as they are; of a packed scene, all of it",
         .help = "Biological assembly or unit cell, one that `nacre info` lists",
         .value = valueOf<&P::look, &R::assembly>(parseAssembly),
         .save = differing},
        {.key = "style",
         .syntax = "NAME",
         .standard = "cartoon for proteins, beside maps licorice; ball-and-stick under 100 atoms with bonds; spacefill",
         .help = "spacefill, ball-and-stick, licorice, line, cartoon or backbone (with ligands as licorice),\nsurface, "
                 "carbohydrate (symbols of sugars), ellipsoids (of displacements) or auto: the default",
         .value = {parseAnyStyle, [](const P& d) { return d.look.style ? styleName(*d.look.style) : "auto"; }},
         .save = differing,
         .control = {.label = "Style",
                     .choices = {{"Automatic", "auto"},
                                 {"Spacefill", "spacefill", "Each atom is a sphere of its van der Waals radius."},
                                 {"Ball and stick", "ball-and-stick",
                                  "Balls are atoms, and sticks are the bonds between them."},
                                 {"Licorice", "licorice", "Sticks are the bonds between atoms."},
                                 {"Cartoon", "cartoon", "Ribbons follow the backbone."},
                                 {"Surface", "surface", "The surface is the boundary that water can reach."},
                                 {"Lines", "line", "Lines are the bonds between atoms."},
                                 {"Backbone", "backbone", "A tube goes through the alpha carbons or phosphates."},
                                 {"Ellipsoids", "ellipsoids",
                                  "Each atom is inside its ellipsoid with the chosen probability."}}}},
        {.key = "bond-orders",
         .syntax = "ligands|on|off",
         .standard = "=",
         .help =
             "Double, triple and aromatic bonds as parallel sticks: of ligands and small molecules, of all, or none",
         .value = choiceOf<kBondOrders, &P::look, &R::bondOrders>(),
         .save = differing},
        {.key = "aromatic-bonds",
         .syntax = "dashes|ring",
         .standard = "=",
         .help = "Inner line of aromatic rings: dashes along each bond, or a ring",
         .value = choiceOf<kAromaticForms, &P::look, &R::aromatic>(),
         .save = differing},
    };
    return under(Topic::style, Facet::scene, std::move(rows));
}

std::vector<Option> colors() {
    std::vector<Option> rows{
        {.key = "color",
         .syntax = "SCHEME|COLOR",
         .standard = "element; chain-carbons for cartoons; plddt for predictions without --style",
         .help = schemeNames() + ";\nor a colour as for --background; element:COLOR colours only the carbons;\n"
                                 "b-factor:10..60:viridis gives the range and the palette, chain:muted a palette,\n"
                                 "b-factor:white:red a ramp of these colours",
         .value = valueOf<&P::look, &R::color>(parseColoring, coloringText),
         .save = always,
         .look = true,
         .control =
             {.label = "Colours",
              .choices = {{"By element", "element", "Each element has its own colour."},
                          {"By chain", "chain", "Each chain has its own colour."},
                          {"By chain, atoms by element", "chain-carbons",
                           "Carbon has the colour of its chain, other elements have their own.", "Carbons by chain"},
                          {"By structure", "input", "Each structure has its own colour.", "Structure"},
                          {"By copy of the assembly", "copy", "Each copy of the assembly has its own colour.", "Copy"},
                          {"By copy, chains shaded", "copy-chain",
                           "Each copy of the assembly has its own colour, and each of its chains a shade of it.",
                           "Copy, chain"},
                          {"By copy, molecules shaded", "copy-entity",
                           "Each copy of the assembly has its own colour, and each of its molecules a shade of it.",
                           "Copy, entity"},
                          {"By residue", "residue", "Each kind of residue has its own colour."},
                          {"By kind of molecule", "entity", "Each kind of molecule has its own colour."},
                          {"Rainbow, start to end", "rainbow",
                           "Colours run along each chain from its start to its end.", "Along the chain"},
                          {"By charge", "charge",
                           "Colours show the charges of atoms that the file states, else which residues are charged.",
                           "Charge (e)"},
                          {"By B factor", "b-factor",
                           "Colours show the B factor: how much atoms move, or how uncertain their places are.",
                           "B factor (Å²)"},
                          {"By helix and strand", "secondary-structure",
                           "Helices, strands and loops have colours of their own.", "Secondary structure"},
                          {"By confidence (AlphaFold)", "plddt",
                           "Colours show the confidence of the prediction for each residue.", "Confidence (pLDDT)"},
                          {"By occupancy", "occupancy", "Colours show the occupancy of each atom."},
                          {"By distance after a fit", "rmsd",
                           "Colours show how far each residue is from its counterpart in another input.",
                           "Distance after the fit (Å)"},
                          {"By distance from the centre", "distance",
                           "Colours show the distance of each atom from the centre.", "Distance from the centre (Å)"},
                          {"Hydrophobic to polar", "hydrophobicity", "Colours run from hydrophobic to polar residues.",
                           "Hydropathy (Kyte–Doolittle)"}}}},
        {.key = "color-from",
         .syntax = "FILE|TEXT",
         .help = "Colour the residues or atoms of a CSV or JSON table by its colours or values; :value=COLUMN,\n"
                 ":10..60 and :viridis after the name choose column, range and palette; repeatable",
         .value = listOf<&P::look, &R::colorFrom>(kMostColorTables, parseColorSource, colorSourceText),
         .kind = list,
         .save = differing},
        {.key = "palette",
         .syntax = "NAME",
         .standard = "by the scheme",
         .help = "Colours of categories (chains, copies, entities): " + paletteNames(false) +
                 ";\nof numbers: " + paletteNames(true),
         .value = valueOf<&P::look, &R::palette>(parsePalette,
                                                 [](const AnyPalette& palette) { return paletteName(palette); }),
         .save = differing},
    };
    return under(Topic::color, Facet::scene, std::move(rows));
}

/// A radius in Å, or a width in pixels; or a width in points, which the picture's scale converts to one.
template <auto points, auto... members>
Option::Access thickness(double low, double high) {
    Option::Access access = numberOf<members...>(low, high);
    access.parse = [inOwnUnit = access.parse](T text, P& d) {
        d.*points = parsePoints(text);
        if (!(d.*points)) inOwnUnit(text, d);
    };
    return access;
}

double parseResolution(T text) { return text == "auto" ? 0 : parseNumber(text, kFinestSurface, kCoarsestSurface); }
std::string resolutionText(double resolution) { return resolution > 0 ? numberText(resolution) : "auto"; }
template <auto share>
Option opacity(T key, const char* help, Option::Control control) {
    return {.key = key,
            .syntax = "SHARE",
            .standard = "=",
            .help = help,
            .value = numberOf<&P::look, share>(kLeastOpacity, 1),
            .save = differing,
            .control = std::move(control)};
}

std::vector<Option> meshes() {
    using C = CartoonOptions;
    using S = SurfaceOptions;
    const auto row = [](T key, const char* syntax, const char* help, Option::Access access,
                        Option::Control control = {}) {
        return Option{.key = key,
                      .syntax = syntax,
                      .standard = "=",
                      .help = help,
                      .value = std::move(access),
                      .save = differing,
                      .control = std::move(control)};
    };
    std::vector<Option> rows{
        row("helices", "FORM", "Cartoon helices: ribbon, tube (follows the bends) or cylinder (straight)",
            choiceOf<kHelixForms, &P::look, &R::cartoon, &C::helices>(),
            {.label = "Helices", .choices = {{"Ribbons", "ribbon"}, {"Tubes", "tube"}, {"Cylinders", "cylinder"}}}),
        row("bases", "FORM",
            "Nucleic acid cartoons: plates of the bases, rings (plates of bases and sugars), ladder or none",
            choiceOf<kBaseForms, &P::look, &R::cartoon, &C::bases>(),
            {.label = "Nucleotides",
             .choices = {{"Plates", "plates"}, {"Filled rings", "rings"}, {"Ladder", "ladder"}, {"None", "none"}}}),
        row("putty", "on|off", "Cartoons as tubes that are wider where the B factor is larger",
            switchOf<kOnOff, &P::look, &R::cartoon, &C::putty>(),
            {.label = "Width by B factor (putty)", .choices = {{"off", "off"}, {"on", "on"}}}),
        row("carbohydrates", "on|off|icon",
            "Sugars beside a cartoon as symbols (SNFG): on, small within licorice, or off",
            choiceOf<kCarbohydrates, &P::look, &R::carbohydrates>()),
        row("line-width", "PIXELS|POINTSpt", "Width of lines, 0.5 to 10 pixels, or as 1pt at --dpi",
            thickness<&P::linePoints, &P::look, &R::lineWidth>(0.5, kWidestWire)),
        row("stick-radius", "A|POINTSpt", "Radius of licorice sticks; or their width on paper, with --scale",
            thickness<&P::stickPoints, &P::look, &R::sizes, &Sizes::stick>(0.01, 5)),
        row("bond-radius", "A|POINTSpt", "Radius of bonds in ball-and-stick, likewise",
            thickness<&P::bondPoints, &P::look, &R::sizes, &Sizes::bond>(0.01, 5)),
        row("tube-radius", "A|POINTSpt", "Radius of the tubes of --style backbone, likewise",
            thickness<&P::tubePoints, &P::look, &R::sizes, &Sizes::tube>(0.01, 5)),
        row("ball-scale", "F", "Size of balls in ball-and-stick, of the van der Waals radius, 0.05 to 1",
            numberOf<&P::look, &R::sizes, &Sizes::ball>(0.05, 1)),
        row("cartoon-scale", "F", "Factor of all widths and thicknesses of cartoons, 0.1 to 5",
            numberOf<&P::look, &R::cartoon, &C::scale>(0.1, 5)),
        row("gaps", "dashed|off", "Where the chain of a cartoon or backbone is broken: a dashed line, or nothing",
            switchOf<kDashedOff, &P::look, &R::gaps>(),
            {.label = "Dashes at chain breaks", .choices = {{"off", "off"}, {"on", "dashed"}}}),
        row("surface-form", "FORM", "Surfaces as solid, mesh (lines of --line-width) or dots",
            choiceOf<kSurfaceForms, &P::look, &R::surfaceForm>()),
        row("disulfides", "show|hide", "Disulfide bonds as sticks in cartoons",
            switchOf<kShowHide, &P::look, &R::cartoon, &C::disulfides>()),
        row("surface", "KIND",
            "Kind of --style surface: excluded (the region that a probe cannot enter), accessible (the surface of "
            "the probe's centre) or gaussian",
            choiceOf<kSurfaceKinds, &P::look, &R::surface, &S::kind>()),
        row("probe", "RADIUS", "Probe radius of surfaces in Å, 0 to 10",
            numberOf<&P::look, &R::surface, &S::probe>(0, kLargestProbe)),
        row("surface-resolution", "auto|CELL",
            "Edge of the grid cells of surfaces in Å, 0.1 to 1.2; auto: 0.4 (lines of a mesh 0.8),\nlarger for many "
            "atoms",
            valueOf<&P::look, &R::surface, &S::resolution>(parseResolution, resolutionText)),
        row("cavities", "show|hide", "Surfaces of closed cavities",
            switchOf<kShowHide, &P::look, &R::surface, &S::cavities>()),
        opacity<&R::surfaceOpacity>("surface-opacity", "Opacity of surfaces, 0.01 to 1",
                                    {"Surface opacity", 0.1, 1, "Surface opacity: %.2f"}),
        opacity<&R::cartoonOpacity>("cartoon-opacity", "Opacity of cartoons, 0.01 to 1",
                                    {"Cartoon opacity", 0.1, 1, "Cartoon opacity: %.2f"}),
        opacity<&R::atomOpacity>("atom-opacity", "Opacity of spheres and sticks, 0.01 to 1",
                                 {"Atom opacity", 0.1, 1, "Atom opacity: %.2f"}),
        row("ellipsoids", "bands|octants",
            "Ellipsoids with bands along the principal ellipses, or also with the octant towards the viewer cut out\n"
            "and lines on its faces, as in ORTEP",
            choiceOf<kEllipsoidForms, &P::look, &R::ellipsoids>(),
            {.label = "Ellipsoid style", .choices = {{"Bands", "bands"}, {"Octants", "octants"}}}),
        row("probability", "P", "Probability in % that an atom is inside its ellipsoid (--style ellipsoids), 1 to 99",
            numberOf<&P::look, &R::sizes, &Sizes::probability>(1, 99)),
    };
    rows.back().control = {"Probability of ellipsoids", 1, 99, "Probability of ellipsoids: %.0f %%"};
    return under(Topic::mesh, Facet::scene, std::move(rows));
}

std::vector<Option> interactions() {
    std::vector<Option> rows{
        {.key = "interactions",
         .syntax = "SEL[,SEL]|off",
         .standard = "=",
         .help =
             "Hydrogen bonds, salt bridges and the like as dashed lines: between a selection and its surroundings,\n"
             "or between two selections; all: between all atoms",
         .value = {[](T text, P& d) { parseInteractions(text, d.look.contacts); },
                   [](const P& d) { return interactionsText(d.look.contacts); }}},
        {.key = "interaction-kinds",
         .syntax = "KIND[,KIND]|all",
         .standard = "=",
         .help = interactionKindNames(),
         .value = valueOf<&P::look, &R::contacts, &ContactOptions::kinds>(parseInteractionKinds, interactionKindsText),
         .needs = "interactions"},
        {.key = "interaction-rules",
         .syntax = "NAME",
         .standard = "=",
         .help = "Definitions of interactions: molstar, plip, baker-hubbard or wernet-nilsson (docs/interactions.md)",
         .value = valueOf<&P::look, &R::contacts, &ContactOptions::rules>(parseInteractionRules, interactionRulesName),
         .needs = "interactions"},
        {.key = "interaction-color",
         .syntax = "[KINDS=]COLOR",
         .help = "Colour of the dashes, of all interactions or of some kinds; repeatable",
         .value = {[](T text, P& d) { parseInteractionColor(text, d.look.contacts); },
                   [](const P& d) { return interactionColorsText(d.look.contacts); }},
         .kind = list,
         .save = differing,
         .needs = "interactions"},
        {.key = "interaction-width",
         .syntax = "WIDTH",
         .standard = "=",
         .help = "Thickness of the dashes of interactions in Å, 0.02 to 1",
         .topic = Topic::style,
         .value = numberOf<&P::look, &R::contacts, &ContactOptions::width>(0.02, 1),
         .needs = "interactions"},
    };
    for (Option& row : rows) row.save = differing;
    return under(Topic::interactions, Facet::scene, std::move(rows));
}

std::string printRules(const P& d) {
    return lines(d.look.rules, [](const Rule& rule) {
        const auto [option, value] = ruleText(rule);
        return option + "=" + value + (rule.on ? "" : "\toff");
    });
}

Altlocs parseAltlocs(T text) {
    if (text == "chosen" || text == "all") return {text == "all" ? Altlocs::Mode::all : Altlocs::Mode::chosen, '\0'};
    if (text.size() == 1) return {Altlocs::Mode::letter, text.front()};
    refuse(text, "chosen, all, or a letter such as A", std::vector<std::string>{"chosen", "all"});
}

std::string altlocsText(const Altlocs& altlocs) {
    if (altlocs.mode == Altlocs::Mode::letter) return std::string(1, altlocs.letter);
    return altlocs.mode == Altlocs::Mode::all ? "all" : "chosen";
}

std::vector<Option> chosen() {
    const auto rule = [](T key, const char* syntax, const char* help, Rule (*parse)(T)) {
        return Option{.key = key,
                      .syntax = syntax,
                      .help = help,
                      .topic = Topic::rules,
                      .facet = Facet::scene,
                      .value = {[parse](T text, P& d) { addTo(d.look.rules, text, kMostRules, parse); }},
                      .kind = list};
    };
    const auto shown = [](T key, const char* standard, const char* help, const char* label, Option::Access access) {
        return Option{.key = key,
                      .syntax = "show|hide",
                      .standard = standard,
                      .help = help,
                      .topic = Topic::atoms,
                      .facet = Facet::scene,
                      .value = std::move(access),
                      .save = always,
                      .control = {.label = label, .choices = {{"hidden", "hide"}, {"shown", "show"}}}};
    };
    return {
        rule("show", "SEL=STYLE", "Draw the atoms of a selection in a style; repeatable", parseShow),
        rule("hide", "SEL", "Hide the atoms of a selection; repeatable", parseHide),
        rule("color-by", "SEL=SCHEME|COLOR",
             "Colour the atoms of a selection; repeatable. These three apply in the given order, the last one wins",
             parseColorBy),
        {.key = "rules", .facet = Facet::scene, .value = {{}, printRules}, .kind = rules, .save = always},
        shown("water", "hide", "Water molecules", "Water", switchOf<kShowHide, &P::drawn, &DrawnAtomsOptions::water>()),
        shown("hydrogens", "show", "Hydrogen atoms", "Hydrogens",
              switchOf<kShowHide, &P::drawn, &DrawnAtomsOptions::hydrogens>()),
        {.key = "altlocs",
         .syntax = "chosen|all|LETTER",
         .standard = "chosen",
         .help =
             "Alternate locations: chosen (highest occupancy of each residue), all, or a named one where a residue\n"
             "has it. A cartoon follows the chosen ones",
         .topic = Topic::atoms,
         .facet = Facet::scene,
         .value = valueOf<&P::drawn, &DrawnAtomsOptions::altlocs>(parseAltlocs, altlocsText),
         .save = differing,
         .control = {.label = "Alternate locations", .choices = {{"chosen", "chosen"}, {"all", "all"}}}},
    };
}

}  // namespace

std::vector<Option> sceneRows() { return joined({whole(), colors(), meshes(), interactions(), chosen()}); }

}  // namespace nacre::app
