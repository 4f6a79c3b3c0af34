#include "app/cli/common_options.h"

#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::size_t kMostRules = 1000;
constexpr std::int64_t kMostOcclusionMegabytes = 65536;

void showHide(CLI::App& app, const std::string& name, bool& target, const std::string& help) {
    addValue(app, name, "show|hide", target ? "show" : "hide", help, [&](const std::string& text) {
        target = parseChoice(text, {"show", "hide"}) == 0;
    });
}

/// An option that may be given many times. Each is taken as it is met, so that their common order is kept.
void rule(CLI::App& app, const std::string& name, const std::string& type, const std::string& help,
          std::vector<Rule>& rules, Rule (*parse)(std::string_view)) {
    addValue(app, name, type, "", help,
             [&rules, parse](const std::string& text) {
                 if (rules.size() == kMostRules)
                     throw std::invalid_argument("more than " + std::to_string(kMostRules) + " rules");
                 rules.push_back(parse(text));
             })
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->trigger_on_parse();
}

void addRules(CLI::App& app, std::vector<Rule>& rules) {
    rule(app, "--show", "SEL=STYLE", "Draw the atoms of a selection in a style; repeatable", rules, parseShow);
    rule(app, "--hide", "SEL", "Leave out the atoms of a selection; repeatable", rules, parseHide);
    rule(app, "--color-by", "SEL=SCHEME|COLOR",
         "Colour the atoms of a selection; repeatable. These three apply in the order they stand in", rules,
         parseColorBy);
}

}  // namespace

CLI::Option* addValue(CLI::App& app, const std::string& name, const std::string& type, const std::string& fallback,
                      const std::string& help, std::function<void(const std::string&)> set) {
    const auto parse = [name, set = std::move(set)](const std::string& text) {
        try {
            set(text);
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError(name.substr(name.find("--")), error.what());
        } catch (const Error& error) {
            throw CLI::ValidationError(name.substr(name.find("--")), error.what());
        }
    };
    return app.add_option_function<std::string>(name, parse, help)->type_name(type)->default_str(fallback);
}

void addOnOff(CLI::App& app, const std::string& name, bool& target, const std::string& help) {
    addValue(app, name, "on|off", "on", help, [&](const std::string& text) {
        target = parseChoice(text, {"on", "off"}) == 0;
    });
}

std::string fileName(const std::string& text) {
    if (text.empty()) throw std::invalid_argument("expected a file name");
    return text;
}

CLI::Option* addInput(CLI::App& app, InputOptions& input) {
    CLI::Option* option = app.add_option(
        "INPUT", input.path,
        "A structure file (PDB, mmCIF, mmJSON, BinaryCIF, MMTF, SDF/MOL, XYZ, MOL2, PQR, GRO, PDBQT, CML;\n"
        "each also .gz), - for standard input, sample:dna, sample:glucose, sample:buckyball, or a download:\n"
        "pdb:1BNA, pubchem:CID|NAME, afdb:UNIPROT");
    option->required()->type_name("");
    addValue(app, "--cache", "DIR|off", "NACRE_CACHE, else ~/.cache/nacre", "Where downloads and occlusion are kept",
             [&](const std::string& text) { input.cache = fileName(text); });
    app.add_flag("--offline", input.offline, "Take downloads from the cache alone");
    addValue(app, "--memory", "MB", "half of the machine's",
             "For the molecule, 1 to 1048576; one that takes more (700 bytes an atom, two a byte of text) is refused",
             [&](const std::string& text) { input.memoryMegabytes = parseInteger(text, 1, 1 << 20); });
    addValue(app, "--format", "NAME", "by content", "One of " + formatNames(), [&](const std::string& text) {
        input.format = formatFromName(text);
        if (!input.format) throw std::invalid_argument("expected one of " + formatNames() + ", not '" + text + "'");
    });
    addValue(app, "--model", "N|all", "1", "Model, frame or record, counted from 1; all: one over the other",
             [&](const std::string& text) { input.model = parseModel(text); });
    return option;
}

void addSize(CLI::App& app, const std::string& fallback, Size& size) {
    addValue(app, "--size", "WxH", fallback, "Pixels, each side 1 to 16384",
             [&](const std::string& text) { size = parseSize(text); });
}

void addDeviceName(CLI::App& app, DeviceOptions& device) {
    addValue(app, "--device", "N|NAME", "the best there is",
             "Number or part of the name, as `nacre devices` lists them", [&](const std::string& text) {
                 if (text.empty()) throw std::invalid_argument("expected a device's number or part of its name");
                 device.device = text;
             });
}

CLI::Option* addContent(CLI::App& app, InputOptions& input, DrawnAtomsOptions& drawn, RepresentationOptions& look) {
    CLI::Option* option = addInput(app, input);
    addValue(app, "--style", "NAME", "spacefill; ball-and-stick under 100 atoms with bonds",
             "spacefill, ball-and-stick or licorice", [&](const std::string& text) { look.style = parseStyle(text); });
    addValue(app, "--color", "SCHEME|COLOR", "element",
             "element, chain, residue, hydrophobicity, charge, secondary-structure, b-factor,\n"
             "plddt (AlphaFold's bands), rainbow (N to C), occupancy, entity; or a colour as for --background",
             [&](const std::string& text) { look.color = parseColoring(text); });
    addValue(app, "--assembly", "ID", "none: the file's atoms as they are",
             "Biological assembly or unit cell, of those that `nacre info` lists", [&](const std::string& text) {
                 if (text.empty()) throw std::invalid_argument("expected an assembly's identifier");
                 look.assembly = text;
             });
    addRules(app, look.rules);
    showHide(app, "--water", drawn.water, "Water molecules");
    showHide(app, "--hydrogens", drawn.hydrogens, "Hydrogen atoms");
    return option;
}

void addOcclusion(CLI::App& app, OcclusionSettings& occlusion) {
    addValue(app, "--occlusion", "K|off", "128", "Ambient occlusion from K directions, 1 to 4096",
             [&](const std::string& text) { occlusion.directions = parseOcclusion(text); });
    addValue(app, "--occlusion-memory", "MB", "64",
             "Device memory for it, 1 to 65536; the more, the finer (says on standard error what was chosen)",
             [&](const std::string& text) { occlusion.megabytes = parseInteger(text, 1, kMostOcclusionMegabytes); });
}

void addVisibility(CLI::App& app, DeviceOptions& device) {
    addValue(
        app, "--visibility", "PATH", "auto", "auto, encoded, fragdepth, deferred or raster-order",
        [&](const std::string& text) {
            constexpr Visibility kPaths[] = {Visibility::automatic, Visibility::encoded, Visibility::fragdepth,
                                             Visibility::deferred, Visibility::rasterOrder};
            device.visibility = kPaths[parseChoice(text, {"auto", "encoded", "fragdepth", "deferred", "raster-order"})];
        });
    addValue(
        app, "--encoded-format", "FORMAT", "auto", "Of encoded depth: auto, r32f, rgba16f, rg16f, a2b10g10r10 or rgba8",
        [&](const std::string& text) {
            constexpr EncodedDepth kRungs[] = {EncodedDepth::automatic,   EncodedDepth::r32f,
                                               EncodedDepth::rgba16f,     EncodedDepth::rg16f,
                                               EncodedDepth::a2b10g10r10, EncodedDepth::rgba8};
            device.encoded = kRungs[parseChoice(text, {"auto", "r32f", "rgba16f", "rg16f", "a2b10g10r10", "rgba8"})];
        });
}

}  // namespace nacre::app
