#include "app/input/trajectory_input.h"

#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "engine/error.h"

namespace nacre::app {

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
