// libFuzzer target for what people and files say of a picture: any bytes are taken or refused by one of the exceptions
// that the program shows, and what was taken reads again as it is written.
// --part=NAME fuzzes selection, view, look, job, table or primitives; --list prints them. tools/fuzz runs them all.

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

#include "app/drawing/complete.h"
#include "app/input/color_file.h"
#include "app/input/primitives_file.h"
#include "app/picture/looks.h"
#include "app/picture/option_json.h"
#include "app/picture/options.h"
#include "app/picture/saved_view.h"
#include "app/picture/usage_error.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/build/representation.h"

namespace {

using namespace nacre;

void require(bool holds, const char* what, const std::string& text) {
    if (holds) return;
    std::cerr << "a text was taken that " << what << ": " << text << std::endl;
    std::abort();
}

const Molecule& molecule() {
    static const Molecule kMolecule = sampleMolecule("dna");
    return kMolecule;
}

void selection(const std::string& text) {
    const Selection selection = parseSelection(text);
    const std::vector<bool> chosen = selectAtoms(molecule(), selection);
    require(chosen.size() == molecule().atoms.size(), "chooses among other atoms", text);
    require(selectAtoms(molecule(), parseSelection(selection.text)) == chosen, "reads otherwise when written", text);
}

/// What is saved of a view is the same after it was read again.
void view(const std::string& text) {
    const std::string json = app::savedViewJson(app::parseSavedView(text, "input"));
    require(app::savedViewJson(app::parseSavedView(json, "input")) == json, "is saved as another view", text);
}

/// The keys of a view that are a look's, taken as from a look's file.
void look(const std::string& text) {
    const std::string json = app::lookJson(app::parseSavedView(text, "input"));
    app::PictureDescription drawn;
    app::applyLook(app::lookFromText(json, "input"), drawn);
    require(app::lookJson(drawn) == json, "is another look when applied", text);
}

/// A line of `nacre batch`.
void job(const std::string& text) {
    app::PictureDescription description;
    app::setOptions(app::parseOptionValues(text), description);
    app::completePicture(description);
}

/// Colours of residues and atoms, as CSV or JSON, and what is drawn in them.
void table(const std::string& text) {
    RepresentationOptions look;
    look.colorFrom.push_back(Coloring(ColorScheme::table));
    look.colorFrom[0].table = std::make_shared<const ColorTable>(app::readColorTable(text, "input", ""));
    const std::vector<std::uint32_t> drawn = drawnAtoms(molecule());
    require(makeAppearance(molecule(), drawn, look).seen == drawn.size(), "hides atoms", text);
}

/// Geometry as JSON, and the scene that it makes.
void primitives(const std::string& text) {
    const Primitives read = app::readPrimitives(text, "input", [](const std::string&) { return glm::dvec3(0); });
    Representation scene;
    addPrimitives(read, scene);
    require(std::isfinite(scene.radius), "reaches to infinity", text);
    require(scene.spheres.size() == scene.sphereLooks.size(), "has spheres without looks", text);
    computeBounds(read);
}

void (*part)(const std::string&) = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    constexpr std::pair<const char*, void (*)(const std::string&)> kParts[] = {
        {"selection", selection},  {"view", view}, {"look", look}, {"job", job}, {"table", table},
        {"primitives", primitives}};
    for (int i = 1; i < *count; ++i)
        for (const auto& [name, run] : kParts) {
            if ((*arguments)[i] == std::string("--list")) std::cout << name << "\n";
            if ((*arguments)[i] == std::string("--part=") + name) part = run;
        }
    if (!part) std::exit(2);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    try {
        part(std::string(reinterpret_cast<const char*>(data), size));
    } catch (const Error&) {
    } catch (const app::UsageError&) {
    } catch (const std::invalid_argument&) {
    }
    return 0;
}
