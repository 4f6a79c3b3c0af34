// Weights of the features of bond orders, fitted by the averaged perceptron (M. Collins, EMNLP 2002) to coordinates and
// orders of 12,266 ligands in crystals of the Protein Data Bank, with orders from the chemical component dictionary,
// and of a fullerene.

#include "engine/molecule/chemistry/order_features.h"

namespace nacre {

// clang-format off
const std::array<float, kOrderWeights> kOrderWeight = {
    // kByLength: 0 a double bond, 1 a single one
    -4.7f, -4.6f, -4.8f, -5.0f, -5.3f, -5.6f, -6.1f, -5.7f,  // C-C
    -3.4f, -3.4f, -3.7f, -4.1f, -4.3f, -4.3f, -4.7f, -4.5f,  // C-N
    -2.7f, -2.1f, -2.6f, -3.2f, -3.9f, -4.0f, -4.2f, -4.4f,  // C-O
    -0.7f, 6.3f, -1.5f, 0.3f, -1.6f, -0.6f, -2.9f, -25.0f,  // C-S
    -2.9f, -3.1f, -2.6f, -3.0f, -3.4f, -3.0f, -5.0f, -20.3f,  // N-N
    1.1f, 3.7f, -0.2f, 0.3f, -0.2f, 0.3f, -12.7f, -25.0f,  // N-O
    14.0f, 14.0f, 6.0f, 0, -6.0f, -12.0f, -20.0f, -25.0f,  // others
    // kInFive: torsion of the ring
    1.0f, -0.1f, -1.2f, -0.9f, -0.1f, 0.1f,  // C-C
    1.5f, 1.0f, 0.8f, 0.9f, 0.2f, -1.0f,  // C-N
    0, -0.1f, 0.3f, -1.5f, -0.2f, -1.0f,  // others
    // kInSix
    0.4f, 0, -0.7f, -1.2f, -1.2f, -1.8f,  // C-C
    1.5f, 1.3f, 1.0f, 0.4f, 0.6f, -0.1f,  // C-N
    -1.3f, 1.8f, -0.1f, 0, 0, -2.3f,  // others
    // kInOther: rings of up to 4, up to 9, larger ones
    -2.0f, -2.1f, -1.3f,  // C-C
    -0.3f, 0.1f, -5.3f,  // C-N
    -1.0f, -0.8f, 0,  // others
    // kLeadsOut: from no, one, two flat rings
    -0.9f, -0.7f, -0.1f,  // C-C
    -1.1f, -1.1f, -3.7f,  // C-N
    0.8f, 1.2f, 0,  // C-O
    -4.6f, -4.0f, 0,  // others
    // kTwisted
    -0.2f, -0.4f, -0.8f, -0.5f, -1.4f,  // C-C
    -1.0f, -1.3f, -1.3f, -1.1f, -1.8f,  // C-N
    -0.6f, -0.1f, -2.1f, -1.4f, -3.3f,  // others
    // kUntwisted
    1.6f, 0.7f, 0.9f,  // C-C, C-N, others
    // kCarbonyl: one to four N and O at the carbon
    -0.8f, 1.1f, 1.7f, 0,
    // kImine: one to four N and O at the carbon
    -0.1f, 0.4f, 1.1f, 0,  // N at the end
    -1.0f, -0.6f, -0.3f, 0,  // N of two
    0.5f, 0.2f, -3.5f, 0,  // N of three
    // kTriple: 0 a triple bond, 1 a double one
    1.9f, 1.3f, 0, -4.1f, -2.9f,  // C-C
    0.7f, 4.0f, -2.6f, -3.1f, 0.3f,  // C-N
    0, 0, 0, 0, 0,  // others
    // kCarbonThree: mean angle
    8.2f, 7.9f, 8.4f, 9.0f, 8.7f, 9.2f, 10.0f,  // acyclic
    -13.5f, -1.4f, 8.1f, 7.3f, 9.5f, 14.3f, 9.8f,  // five, flat
    -8.0f, 8.6f, 7.1f, 8.6f, 7.8f, 9.3f, 9.6f,  // five, bent
    7.8f, 8.0f, 9.3f, 9.5f, 9.6f, 10.5f, 9.7f,  // six, flat
    3.5f, 8.8f, 6.7f, 8.7f, 8.9f, 9.2f, 10.2f,  // six, bent
    2.5f, -7.1f, -2.2f, 4.8f, 8.9f, 11.3f, 10.2f,  // other ring
    0, 2.6f, 8.7f, 9.2f, 9.3f, 9.4f, 9.8f,  // where rings meet
    // kCarbonHetero: none to three N, O and S
    -5.7f, -6.0f, -5.9f, -6.0f,
    // kCarbonTwo: angle
    2.7f, 2.7f, 3.0f, 3.2f, 3.5f, 3.5f, 3.5f, 2.8f,  // acyclic
    2.8f, 3.1f, 3.5f, 2.9f, 10.0f, 15.7f, 28.6f, 50.0f,  // five, flat
    2.0f, 2.6f, 2.6f, 4.3f, 10.0f, 15.7f, 28.6f, 50.0f,  // five, bent
    4.3f, 3.1f, 3.0f, 3.4f, 3.5f, 3.4f, 23.5f, 50.0f,  // six, flat
    2.3f, 2.9f, 3.0f, 3.3f, 3.4f, 3.3f, 24.6f, 38.9f,  // six, bent
    3.0f, 2.9f, 3.0f, 3.4f, 3.6f, 3.8f, 4.7f, 49.6f,  // other ring
    // kCarbonEnd
    0.9f,
    // kCarbonLinear: angle
    1.8f, -0.3f, -0.1f, -2.9f,
    // kNitrogenThree: mean angle
    1.4f, 1.2f, 0.4f, 0.7f, 0.3f, -0.3f, -1.4f,  // acyclic
    1.2f, 1.7f, 1.1f, 1.8f, 1.6f, 0.3f, 1.1f,  // five, flat
    2.0f, 0, 1.4f, 2.2f, -1.5f, 1.0f, 2.9f,  // five, bent
    0, 0.6f, 3.9f, -1.2f, 2.8f, 0.4f, 0.7f,  // six, flat
    2.0f, 2.6f, 4.9f, 1.1f, 1.8f, 0.9f, 0.5f,  // six, bent
    0.3f, 0.1f, 0.4f, 0, 0.3f, 0.5f, 0.9f,  // other ring
    // kNitrogenTwo: angle
    2.1f, 1.7f, 1.8f, 2.1f, 1.8f, 1.8f, 1.9f, 2.1f,  // acyclic
    -0.4f, -0.7f, -0.8f, -0.2f, -0.2f, -0.6f, -0.2f, 0,  // five, flat
    0.2f, -0.1f, 0.2f, 0.6f, 1.3f, 0, 0, 0,  // five, bent
    0.5f, 0.4f, 0.1f, 0.1f, -0.3f, -0.4f, -1.1f, 1.5f,  // six, flat
    0.4f, -0.5f, -0.5f, -0.4f, -0.5f, -0.2f, -0.1f, 0,  // six, bent
    -2.7f, -1.4f, -2.3f, 0.1f, 0.2f, -0.3f, -0.2f, 0.4f,  // other ring
    // kNitrogenBesideN: none to two
    1.7f, 2.2f, 3.3f,
    // kNitrogenLinear: angle
    1.6f, 1.0f, 0, 0,
    // kNitrogenEnd: no and two pi bonds
    0.7f, -0.9f,
    // kEnd: neighbours of its atom
    0, -1.1f, -0.6f, 0,  // O
    0, 0.7f, 2.5f, 0,  // S and Se
};
// clang-format on

}  // namespace nacre
