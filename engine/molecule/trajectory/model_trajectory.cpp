// The models of one file as a trajectory, if all have the same atoms.

#include <algorithm>
#include <string>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/formats/model_reader.h"
#include "engine/molecule/read.h"
#include "engine/molecule/trajectory/trajectory_file.h"

namespace nacre {
namespace {

class ModelTrajectory : public Trajectory {
public:
    ModelTrajectory(std::shared_ptr<const Molecule> molecule, std::size_t own)
        : molecule_(std::move(molecule)), own_(own) {
        format_ = "models";
        atoms_ = molecule_->atoms.size();
        frames_ = molecule_->others.size() + 1;
    }

private:
    void readFrame(std::size_t frame, TrajectoryFrame& result) override {
        if (frame != own_) return takeOther(molecule_->others[frame < own_ ? frame : frame - 1], result.positions);
        std::transform(molecule_->atoms.begin(), molecule_->atoms.end(), result.positions.begin(),
                       [](const Atom& atom) { return atom.position; });
        const FileSummary& file = molecule_->file;
        const auto& repeats = file.boxRepeats;
        if (!file.box || std::find(repeats.begin(), repeats.end(), true) == repeats.end()) return;
        result.box = file.box;
        for (std::size_t k = 0; k < 3; ++k)
            if (!repeats[k]) (*result.box)[k] = glm::vec3(0);
    }

    static void takeOther(OtherModel other, std::vector<glm::vec3>& positions) {
        if (!other.whole) positions = std::move(other.positions);
        for (std::size_t i = 0; other.whole && i < positions.size(); ++i) positions[i] = other.whole->atoms[i].position;
    }

    std::shared_ptr<const Molecule> molecule_;
    std::size_t own_;
};

/// "atom 12 is N of GLY 5"
std::string atomText(const Molecule& molecule, std::size_t atom) {
    const Atom& a = molecule.atoms[atom];
    const Residue& residue = molecule.residues[a.residue];
    std::string text = "atom " + std::to_string(atom + 1) + " is " + std::string(a.name.view());
    if (!residue.name.view().empty())
        text += " of " + std::string(residue.name.view()) + " " + std::to_string(residue.number);
    return text;
}

bool sameAtom(const Molecule& a, const Molecule& b, std::size_t atom) {
    const Atom &x = a.atoms[atom], &y = b.atoms[atom];
    const Residue &r = a.residues[x.residue], &s = b.residues[y.residue];
    return x.name == y.name && x.element == y.element && x.alternate == y.alternate && r.name == s.name &&
           r.number == s.number && r.insertionCode == s.insertionCode &&
           a.chains[r.chain].name == b.chains[s.chain].name;
}

}  // namespace

std::string differenceOfModels(const Molecule& molecule) {
    if (molecule.others.empty()) return "its records are different molecules";
    for (std::size_t i = 0; i < molecule.others.size(); ++i) {
        const std::shared_ptr<const Molecule> other = molecule.others[i].whole;
        if (!other) continue;
        const std::string model = "model " + std::to_string(i + 2);
        const std::size_t count = molecule.atoms.size();
        if (other->atoms.size() != count)
            return model + " has " + std::to_string(other->atoms.size()) + " atoms, the first " + std::to_string(count);
        for (std::size_t atom = 0; atom < count; ++atom)
            if (!sameAtom(molecule, *other, atom))
                return "of " + model + ", " + atomText(*other, atom) + "; of the first, " + atomText(molecule, atom);
    }
    return "";
}

std::unique_ptr<Trajectory> trajectoryOfModels(std::shared_ptr<const Molecule> molecule, int model, bool placesAlone) {
    const bool places = molecule->others.allMove(molecule->atoms.size()) ||
                        (placesAlone && !molecule->others.empty() && differenceOfModels(*molecule).empty());
    if (molecule->modelsAreInputs || molecule->atoms.empty() || model < 1 ||
        static_cast<std::size_t>(model) > molecule->others.size() + 1 || !places)
        return nullptr;
    return std::make_unique<ModelTrajectory>(std::move(molecule), static_cast<std::size_t>(model - 1));
}

std::unique_ptr<Trajectory> openModels(const std::string& path) {
    auto molecule = std::make_shared<const Molecule>(readMoleculeFile(path, {.others = true}));
    const auto fail = [&](const std::string& why) { throw Error("cannot read trajectory", path, why); };
    if (molecule->lacksPositions) fail("it is a topology without positions");
    if (countModels(molecule->file) == 1) return std::make_unique<ModelTrajectory>(std::move(molecule), 0);
    auto models = trajectoryOfModels(molecule, 1, true);
    if (!models) fail(molecule->othersMissing.empty() ? differenceOfModels(*molecule) : molecule->othersMissing);
    return models;
}

}  // namespace nacre
