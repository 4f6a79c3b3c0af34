#include "app/input/read_input.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string_view>

#include "app/files/messages.h"
#include "app/input/fit_inputs.h"
#include "app/input/input_files.h"
#include "app/input/map_input.h"
#include "app/picture/input_names.h"
#include "engine/error.h"
#include "engine/molecule/chemistry/hydrogens.h"
#include "engine/molecule/displacement.h"
#include "engine/molecule/join_models.h"
#include "engine/molecule/memory_bound.h"
#include "engine/molecule/superpose.h"
#include "engine/molecule/trajectory/morph.h"

namespace nacre::app {
namespace {

constexpr std::string_view kSample = "sample:";
constexpr std::uint64_t kUsualMemory = std::uint64_t{2} << 30;  // if the system does not report it

int findModel(const Molecule& molecule, std::uint32_t atom) {
    return molecule.chains[molecule.residues[molecule.atoms[atom].residue].chain].model;
}

/// Reads an open file; errors use its name. @throws Error
Molecule readOpened(const InputOptions& input, ReadOptions options) {
    options.uploaded = true;
    std::error_code error;
    const std::string path = openedPath(input);
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (error) throw Error("cannot read molecule", input.path, error.message());
    if (size > options.maxBytes)
        throw Error("cannot read molecule", input.path,
                    "the file has " + std::to_string(size >> 20) + " MB, more than the limit of " +
                        std::to_string(options.maxBytes >> 20) + " MB");
    std::string bytes(size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return readMolecule(input.path, std::move(bytes), options);
}

}  // namespace

std::uint64_t memoryShare(unsigned parts) {
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
    if (pages <= 0 || size <= 0) return kUsualMemory / parts;
    return static_cast<std::uint64_t>(pages) / parts * static_cast<std::uint64_t>(size);
}

Molecule completed(const InputOptions& input, Molecule molecule) {
    if (molecule.lacksPositions && input.trajectory.path.empty() && !input.describedOnly)
        throw Error("cannot draw molecule", input.path,
                    "it is a topology without positions: name a file that has them with --trajectory");
    if (!input.addHydrogens) return molecule;
    if (!input.trajectory.path.empty())
        throw Error("cannot add hydrogens", input.path,
                    "the trajectory " + input.trajectory.path + " has none of them");
    return withMissingHydrogens(molecule);
}

std::uint64_t memoryLimit(const InputOptions& input) {
    return input.memoryMegabytes ? static_cast<std::uint64_t>(*input.memoryMegabytes) << 20 : memoryShare(2);
}

MapLimits mapLimits(const InputOptions& input) { return {static_cast<std::size_t>(memoryLimit(input) / 2)}; }

Molecule readLocally(const InputOptions& input, std::uint64_t bytes,
                     const std::function<std::string(const std::string&)>& readFile,
                     const std::function<void(double)>& onModel) {
    if (input.path.starts_with(kSample)) {
        if (input.format) throw Error("cannot read molecule", input.path, "a sample takes no --format");
        if (input.model != 1 && input.model != kAllModels)
            throw Error("cannot read molecule", input.path, "a sample has one model");
        return completed(input, sampleMolecule(std::string_view(input.path).substr(kSample.size())));
    }
    ReadOptions options = readWithin(bytes);
    options.format = input.format;
    options.model = input.model;
    options.onModel = onModel;
    options.others = !input.alone;
    if (readFile) return completed(input, readMolecule(input.path, readFile(input.path), options));
    try {
        return completed(input, input.opened ? readOpened(input, options) : readMoleculeFile(input.path, options));
    } catch (const Error&) {
        if (!isMap(input)) throw;
        return {};  // a map without a molecule: takeMap() draws it
    }
}

Molecule joinInputs(const InputOptions& input, std::vector<Molecule> molecules,
                    const std::function<void(const std::string&)>& tell) {
    for (std::size_t i = 0; i < molecules.size(); ++i)
        for (Chain& chain : molecules[i].chains) chain.model = static_cast<int>(i + 1);
    std::vector<FileSummary> files;
    for (const Molecule& molecule : molecules) files.push_back(molecule.file);
    Molecule whole = joinModels(input.path, std::move(molecules), kMaxAtoms);
    whole.modelsAreInputs = true;
    whole.inputs = inputNames(input);
    whole.inputFiles = std::move(files);
    whole.assemblies.clear();  // they apply to one molecule only
    fitInputs(input, whole, tell);
    return whole;
}

Molecule joinConformations(const InputOptions& input, std::vector<Molecule> molecules,
                           const std::function<void(const std::string&)>& tell) {
    Molecule whole = std::move(molecules.front());
    const std::size_t atoms = whole.atoms.size(), count = molecules.size();
    const auto shown = static_cast<std::size_t>(std::max(input.model, 1)) - 1;
    if (input.model == kAllModels || shown >= count)
        throw Error("cannot show conformations", input.path,
                    input.model == kAllModels
                        ? "they are shown one by one: leave out --conformations, or --model all"
                        : "there is no model " + std::to_string(input.model) + ": there are " + std::to_string(count));
    std::vector<std::vector<glm::vec3>> positions(1);
    for (const Atom& atom : whole.atoms) positions[0].push_back(atom.position);
    for (std::size_t i = 1; i < count; ++i) {
        const std::string& name = input.further[i - 1].path;
        Conformation next = fitConformation(whole, molecules[i], name);
        if (next.matched < atoms)
            tell(std::to_string(next.matched) + " of " + std::to_string(atoms) + " atoms have a counterpart in " +
                 name + "; the others go with those around them");
        positions.push_back(std::move(next.positions));
    }
    whole.others.clear();
    whole.othersMissing.clear();
    if (shown > 0) movePositions(whole, positions[shown]);
    for (std::size_t i = 0; i < count; ++i)
        if (i != shown) whole.others.add({std::move(positions[i]), nullptr});
    whole.file.models = static_cast<std::int64_t>(count);
    whole.file.records.reset();
    return whole;
}

MotionOptions motionOptions(const TrajectoryOptions& options, const Molecule& molecule) {
    MotionOptions motion;
    motion.whole = options.whole;
    motion.smoothed = static_cast<std::size_t>(options.smooth);
    if (options.fit) {
        const std::vector<bool> fitted = selectAtoms(molecule, *options.fit);
        for (std::uint32_t i = 0; i < fitted.size(); ++i)
            if (fitted[i]) motion.fitted.push_back(i);
        if (motion.fitted.size() < 3)
            throw Error("cannot fit frames", options.path, "--fit-frames selects fewer than three atoms");
    }
    return motion;
}

std::unique_ptr<Motion> openMotion(const TrajectoryOptions& options, const Molecule& molecule) {
    for (const std::string& notice : trajectoryNotices(options)) sayNotice(notice);
    auto opened = std::make_unique<Motion>(openTrajectory(options.path), molecule, motionOptions(options, molecule));
    if (opened->trajectory().cutOff())
        sayWarning(options.path + " ends within a frame: the " + std::to_string(opened->frames()) +
                   " whole ones are read");
    return opened;
}

namespace {

/// Indices of the chosen atoms of one model. @param model  as Chain::model
std::vector<std::uint32_t> listChosen(const Molecule& molecule, const std::vector<bool>& chosen, int model) {
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t i = 0; i < chosen.size(); ++i)
        if (chosen[i] && findModel(molecule, i) == model) atoms.push_back(i);
    return atoms;
}

}  // namespace

void fitModels(const InputOptions& input, Molecule& molecule) {
    const TrajectoryOptions& frames = input.trajectory;
    if (!frames.path.empty() || !frames.fit) return;
    const std::vector<bool> chosen = selectAtoms(molecule, *frames.fit);
    const auto refuse = [&](const std::string& why) { throw Error("cannot fit models", input.path, why); };
    if (input.model != kAllModels) {
        if (input.model == 1) return;
        if (molecule.others.empty() || molecule.others[0].whole) refuse("its models have different atoms");
        std::vector<glm::dvec3> fixed, moving;
        for (std::uint32_t i = 0; i < chosen.size(); ++i) {
            if (!chosen[i]) continue;
            fixed.emplace_back(molecule.others[0].positions[i]);
            moving.emplace_back(molecule.atoms[i].position);
        }
        if (fixed.size() < 3) refuse("--fit-frames selects fewer than three atoms");
        const Superposition onto = superpose(fixed, moving);
        for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
            molecule.atoms[i].position = glm::vec3(onto(glm::dvec3(molecule.atoms[i].position)));
            turnDisplacement(molecule, i, onto.rotation);
        }
        return;
    }
    std::set<int> models;
    for (const Chain& chain : molecule.chains) models.insert(chain.model);
    const std::vector<std::uint32_t> first = listChosen(molecule, chosen, *models.begin());
    if (first.size() < 3) refuse("--fit-frames selects fewer than three atoms");
    const auto collectPlaces = [&](const std::vector<std::uint32_t>& atoms) {
        std::vector<glm::dvec3> places;
        for (const std::uint32_t atom : atoms) places.emplace_back(molecule.atoms[atom].position);
        return places;
    };
    const std::vector<glm::dvec3> fixed = collectPlaces(first);
    std::map<int, Superposition> onto;
    for (const int model : models) {
        const std::vector<std::uint32_t> atoms = listChosen(molecule, chosen, model);
        if (atoms.size() != first.size()) refuse("model " + std::to_string(model) + " has other atoms to fit by");
        onto[model] = superpose(fixed, collectPlaces(atoms));
    }
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i) {
        glm::vec3& position = molecule.atoms[i].position;
        const Superposition& motion = onto.at(findModel(molecule, i));
        position = glm::vec3(motion(glm::dvec3(position)));
        turnDisplacement(molecule, i, motion.rotation);
    }
}

void moveToFrame(const TrajectoryOptions& options, Molecule& molecule) {
    if (options.path.empty()) return;
    const std::unique_ptr<Motion> motion = openMotion(options, molecule);
    if (static_cast<std::uint64_t>(options.frame) > motion->frames())
        throw Error(
            "cannot read trajectory", options.path,
            "there is no frame " + std::to_string(options.frame) + "; it has " + std::to_string(motion->frames()));
    movePositions(molecule, motion->positions(static_cast<std::size_t>(options.frame - 1)));
    sayTorn(*motion, options.path);
}

bool sayTorn(const Motion& motion, const std::string& path) {
    if (motion.torn())
        sayWarning("frame " + std::to_string(*motion.torn() + 1) + " of " + path +
                   " is fitted with molecules that the periodic box cuts: use --whole");
    if (motion.boxless())
        sayNote("frame " + std::to_string(*motion.boxless() + 1) + " of " + path +
                " has no periodic box: --whole does nothing there");
    return motion.torn() || motion.boxless();
}

void movePositions(Molecule& molecule, const std::vector<glm::vec3>& positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) molecule.atoms[i].position = positions[i];
}

}  // namespace nacre::app
