#include "app/input/electrostatics.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/common.hpp>
#include <set>

#include "app/files/output_file.h"
#include "app/input/map_input.h"
#include "app/input/read_input.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/molecule/read.h"
#include "engine/molecule/text.h"

extern char** environ;

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "electrostatic potential";

[[noreturn]] void fail(const std::string& why) { throw Error("cannot calculate the electrostatic potential", "", why); }

/// A folder for the programs' files. It is removed with them, also by signals that end this program.
class WorkFolder {
public:
    WorkFolder() : path_((fs::temp_directory_path() / "nacre-potential-XXXXXX").string()) {
        if (!mkdtemp(path_.data())) fail(path_ + ": " + std::strerror(errno));
        for (const char* name : kFiles) removeOnSignals(*this / name);
        removeOnSignals(path_);
    }
    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
        for (const char* name : kFiles) keepOnSignals(*this / name);
        keepOnSignals(path_);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    const std::string& path() const { return path_; }
    std::string operator/(const std::string& name) const { return path_ + "/" + name; }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream file(*this / name, std::ios::binary);
        file << text;
        if (!file.flush()) fail(*this / name + ": " + std::strerror(errno));
    }

private:
    static constexpr std::array kFiles{"molecule.pdb", "charged.pqr", "charged.log", "solve.in",
                                       "potential.dx", "pdb2pqr.log", "apbs.log",    "io.mc"};
    std::string path_;
};

/// The last non-empty line of a program's messages.
std::string lastLine(const std::string& path) {
    std::ifstream file(path);
    std::string line, last;
    while (std::getline(file, line))
        if (line.find_first_not_of(" \t\r-=*") != std::string::npos) last = line.substr(0, 400);
    return last;
}

/// Runs a program in a folder, without a shell, and waits for its end. Its messages are in "NAME.log".
void runIn(const WorkFolder& folder, std::vector<std::string> words) {
#ifdef __GLIBC__
    const std::string program = words.front(), log = folder / (program + ".log");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = -1;
    const int failure = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure == ENOENT)
        fail("the program " + program + " is not installed (Debian: apt install pdb2pqr apbs); a potential from " +
             "elsewhere is taken by --surface-color-from");
    if (failure != 0) fail(program + ": " + std::strerror(failure));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status)) fail(program + " was ended by signal " + std::to_string(WTERMSIG(status)));
    if (WEXITSTATUS(status) != 0) fail(program + ": " + lastLine(log));
#else
    static_cast<void>(folder);
    fail("this system runs no program " + words.front());
#endif
}

/// Names of at most one character for the chains of a PDB file.
class ChainLetters {
public:
    char of(std::uint32_t chain) {
        constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
        const auto found = std::find(chains_.begin(), chains_.end(), chain);
        const auto at = static_cast<std::size_t>(found - chains_.begin());
        if (found == chains_.end()) chains_.push_back(chain);
        if (at >= kLetters.size()) fail("the molecule has more than " + std::to_string(kLetters.size()) + " chains");
        return kLetters[at];
    }

private:
    std::vector<std::uint32_t> chains_;
};

/// Atoms of the first model's drawn conformer, without water.
std::vector<std::uint32_t> chargedAtoms(const ResidueFacts& facts) {
    constexpr std::size_t kMost = 99'999;  // serial numbers of a PDB file
    const Molecule& molecule = facts.molecule();
    const int first = molecule.chains.empty() ? 1 : molecule.chains.front().model;
    std::vector<std::uint32_t> atoms = facts.conformer();
    std::erase_if(atoms, [&](std::uint32_t i) {
        const Residue& residue = molecule.residues[molecule.atoms[i].residue];
        return molecule.chains[residue.chain].model != first || isWater(residue);
    });
    if (atoms.empty()) fail("the molecule has no atoms beside water");
    if (atoms.size() > kMost)
        fail("the molecule has " + std::to_string(atoms.size()) + " atoms; pdb2pqr takes at most " +
             std::to_string(kMost));
    return atoms;
}

/// Numbers residues anew, which avoids insertion codes, long numbers and missing numbers.
std::string writePdb(const Molecule& molecule, const std::vector<std::uint32_t>& atoms) {
    constexpr int kNumbers = 10'000, kSerials = 100'000;
    ChainLetters letters;
    std::string text;
    int serial = 0, number = 0;
    std::uint32_t last = UINT32_MAX;
    for (const std::uint32_t i : atoms) {
        const Atom& atom = molecule.atoms[i];
        const Residue& residue = molecule.residues[atom.residue];
        if (atom.residue != last) ++number;
        last = atom.residue;
        const std::string symbol(elementSymbol(atom.element));
        std::string name(atom.name.view().substr(0, 4));
        if (name.size() < 4 && symbol.size() < 2) name.insert(0, " ");  // symbols end in the second column
        text += formatted("%-6s%5d %-4s %3.3s %c%4d    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n",
                          atom.hetero ? "HETATM" : "ATOM", ++serial % kSerials, name.c_str(),
                          std::string(residue.name.view()).c_str(), letters.of(residue.chain), number % kNumbers,
                          static_cast<double>(atom.position.x), static_cast<double>(atom.position.y),
                          static_cast<double>(atom.position.z), symbol.c_str());
    }
    return text + "END\n";
}

/// Charges and radii from the file.
std::string writePqr(const Molecule& molecule, const std::vector<std::uint32_t>& atoms) {
    std::string text;
    int serial = 0;
    for (const std::uint32_t i : atoms) {
        const Atom& atom = molecule.atoms[i];
        text += formatted("ATOM %d X UNK 1 %.3f %.3f %.3f %.4f %.4f\n", ++serial, static_cast<double>(atom.position.x),
                          static_cast<double>(atom.position.y), static_cast<double>(atom.position.z),
                          static_cast<double>(molecule.partialCharges[i]), static_cast<double>(molecule.radii[i]));
    }
    return text + "END\n";
}

/// The grid around atoms. APBS requires numbers of nodes of the form 32 n + 1.
struct Grid {
    glm::ivec3 nodes{};
    glm::dvec3 coarse{}, fine{};  ///< lengths, Å
};

/// @param bytes  memory for the solver
Grid gridAbout(const Molecule& charged, std::uint64_t bytes) {
    constexpr double kSpacing = 0.5, kMargin = 20, kCoarser = 1.7;  // Å, Å, and pdb2pqr's ratio of the two lengths
    constexpr int kStep = 32, kMostSteps = 5;
    constexpr std::uint64_t kBytesPerNode = 500;
    glm::dvec3 low(1e9), high(-1e9);
    for (std::size_t i = 0; i < charged.atoms.size(); ++i) {
        const double radius = i < charged.radii.size() ? static_cast<double>(charged.radii[i]) : 0;
        low = glm::min(low, glm::dvec3(charged.atoms[i].position) - radius);
        high = glm::max(high, glm::dvec3(charged.atoms[i].position) + radius);
    }
    Grid grid;
    grid.fine = high - low + kMargin;
    grid.coarse = glm::max(grid.fine, kCoarser * (high - low));
    glm::ivec3 steps{};
    for (int i = 0; i < 3; ++i)
        steps[i] = std::clamp(static_cast<int>(std::ceil(grid.fine[i] / kSpacing / kStep)), 1, kMostSteps);
    const auto nodes = [&] { return glm::ivec3(kStep * steps + 1); };
    const auto needs = [&] {
        const glm::ivec3 n = nodes();
        return kBytesPerNode * static_cast<std::uint64_t>(n.x) * static_cast<std::uint64_t>(n.y) *
               static_cast<std::uint64_t>(n.z);
    };
    while (needs() > bytes) {
        int finest = 0;
        for (int i = 1; i < 3; ++i)
            if (grid.fine[i] / steps[i] < grid.fine[finest] / steps[finest] || steps[finest] == 1) finest = i;
        if (steps[finest] == 1)
            fail("apbs needs " + std::to_string(needs() >> 20) + " MB for the coarsest grid (--memory allows " +
                 std::to_string(bytes >> 20) + " MB)");
        --steps[finest];
    }
    grid.nodes = nodes();
    return grid;
}

std::string solverInput(const Grid& grid) {
    return formatted(
        "read\n  mol pqr charged.pqr\nend\n"
        "elec\n  mg-auto\n  dime %d %d %d\n  cglen %.4f %.4f %.4f\n  fglen %.4f %.4f %.4f\n"
        "  cgcent mol 1\n  fgcent mol 1\n  mol 1\n  lpbe\n  bcfl sdh\n"
        "  ion charge 1 conc 0.150 radius 2.0\n  ion charge -1 conc 0.150 radius 2.0\n"
        "  pdie 2.0\n  sdie 78.54\n  srfm smol\n  chgm spl2\n  sdens 10.0\n  srad 1.4\n  swin 0.3\n"
        "  temp 298.15\n  calcenergy no\n  calcforce no\n  write pot dx potential\nend\nquit\n",
        grid.nodes.x, grid.nodes.y, grid.nodes.z, grid.coarse.x, grid.coarse.y, grid.coarse.z, grid.fine.x, grid.fine.y,
        grid.fine.z);
}

std::string readContents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Builds of APBS for several processors append a number.
std::string potentialFile(const WorkFolder& folder) {
    for (const char* name : {"potential.dx", "potential-PE0.dx"})
        if (fs::exists(folder / name)) return folder / name;
    fail("apbs: " + lastLine(folder / "apbs.log"));
}

/// Lists residues without charged atoms: pdb2pqr omits those unknown to its force field.
std::string leftOut(const Molecule& molecule, const std::vector<std::uint32_t>& atoms, const Molecule& charged) {
    constexpr double kSame = 0.01;  // Å²: hydrogens and a few others move
    constexpr std::size_t kMostNamed = 5;
    std::set<std::uint32_t> missing;
    std::vector<glm::vec3> there;
    for (const Atom& atom : charged.atoms) there.push_back(atom.position);
    const auto byX = [](const glm::vec3& a, const glm::vec3& b) { return a.x < b.x; };
    std::sort(there.begin(), there.end(), byX);
    const auto isThere = [&](const glm::vec3& at) {
        auto near = std::lower_bound(there.begin(), there.end(), at - glm::vec3(0.1f), byX);
        for (; near != there.end() && near->x <= at.x + 0.1f; ++near)
            if (const glm::vec3 off = *near - at;
                static_cast<double>(off.x * off.x + off.y * off.y + off.z * off.z) < kSame)
                return true;
        return false;
    };
    for (const std::uint32_t i : atoms) missing.insert(molecule.atoms[i].residue);
    for (const std::uint32_t i : atoms)
        if (missing.contains(molecule.atoms[i].residue) && isThere(molecule.atoms[i].position))
            missing.erase(molecule.atoms[i].residue);
    std::set<std::string> names;
    for (const std::uint32_t residue : missing) names.emplace(molecule.residues[residue].name.view());
    std::string text;
    std::size_t named = 0;
    for (const std::string& name : names)
        if (++named <= kMostNamed) text += (text.empty() ? "" : ", ") + name;
    return named > kMostNamed ? text + " and others" : text;
}

}  // namespace

std::shared_ptr<const DensityMap> electrostaticPotential(const ResidueFacts& facts, const InputOptions& input) {
    const Molecule& molecule = facts.molecule();
    const std::vector<std::uint32_t> atoms = chargedAtoms(facts);
    const bool stated = !molecule.partialCharges.empty() && !molecule.radii.empty();
    const std::string text = stated ? writePqr(molecule, atoms) : writePdb(molecule, atoms);
    const MapLimits limits = mapLimits(input);
    const std::string key = std::string(kName) + " " + std::to_string(std::hash<std::string>{}(text)) + " " +
                            std::to_string(text.size()) + " " + std::to_string(limits.maxBytes);
    if (auto kept = keptMap(key)) return kept;
    const WorkFolder folder;
    std::string warning;
    if (stated) {
        folder.write("charged.pqr", text);
    } else {
        folder.write("molecule.pdb", text);
        runIn(folder, {"pdb2pqr", "--ff=AMBER", "--whitespace", folder / "molecule.pdb", folder / "charged.pqr"});
        if (!fs::exists(folder / "charged.pqr")) fail("pdb2pqr: " + lastLine(folder / "pdb2pqr.log"));
    }
    const Molecule charged = readMolecule(kName, readContents(folder / "charged.pqr"), {.format = Format::pqr});
    if (!stated)
        if (const std::string names = leftOut(molecule, atoms, charged); !names.empty())
            warning = "it leaves out " + names + ": AMBER's force field has no charges for them";
    folder.write("solve.in", solverInput(gridAbout(charged, limits.maxBytes)));
    runIn(folder, {"apbs", folder / "solve.in"});
    DensityMap map = readMapFile(potentialFile(folder), limits, "potential.dx");
    map.name = kName;
    if (!warning.empty()) map.warnings.push_back(warning);
    auto result = std::make_shared<const DensityMap>(std::move(map));
    keepMap(key, result);
    return result;
}

}  // namespace nacre::app
