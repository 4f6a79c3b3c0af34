#pragma once
// Peptides by their torsions.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tests/molecule/build_molecule.h"

namespace nacre::test {

/// Where the fourth atom of a chain lies: bond length (Å), bond angle and torsion (degrees) to the three before it.
inline glm::dvec3 placed(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, double length, double angle, double torsion) {
    const glm::dvec3 along = glm::normalize(c - b), normal = glm::normalize(glm::cross(b - a, along));
    const double bend = glm::radians(180 - angle), turn = glm::radians(torsion);
    return c + length * (std::cos(bend) * along + std::sin(bend) * std::cos(turn) * glm::cross(normal, along) +
                         std::sin(bend) * std::sin(turn) * normal);
}

/// A chain of alanines' backbones by its torsions phi and psi, in standard geometry (Engh and Huber, 1991).
inline Molecule buildChain(int residues, double phi, double psi) {
    MoleculeText text;
    glm::dvec3 before(0, 1, 0), n(0), ca(1.458, 0, 0), c = placed(before, n, ca, 1.525, 111, phi);
    for (int i = 1; i <= residues; ++i) {
        const glm::dvec3 nextN = placed(n, ca, c, 1.329, 116.2, psi), o = placed(n, ca, c, 1.231, 120.4, psi + 180);
        text.residue("ALA", i).atom("N", "N", n).atom("CA", "C", ca).atom("C", "C", c).atom("O", "O", o);
        const glm::dvec3 nextCa = placed(ca, c, nextN, 1.458, 121.7, 180);
        const glm::dvec3 nextC = placed(c, nextN, nextCa, 1.525, 111, phi);
        n = nextN, ca = nextCa, c = nextC;
    }
    return text.molecule;
}

}  // namespace nacre::test
