#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/error.h"
#include "engine/molecule/read.h"

namespace nacre::test {

/// Whether a message is one line of clean text that a user can read.
inline void expectCleanMessage(const std::string& message) {
    EXPECT_FALSE(message.empty());
    EXPECT_LT(message.size(), 700u);
    for (const char c : message) {
        const auto byte = static_cast<unsigned char>(c);
        EXPECT_TRUE(byte >= 0x20 && byte != 0x7F) << "control character " << int(byte) << " in: " << message;
    }
}

/// The message of the Error that reading ends in; a failure, and empty, if it reads.
inline std::string catchError(const std::string& name, const std::string& bytes, const ReadOptions& options = {}) {
    try {
        const Molecule molecule = readMolecule(name, bytes, options);
        ADD_FAILURE() << name << " reads, with " << molecule.atoms.size() << " atoms: " << bytes.substr(0, 200);
    } catch (const Error& error) {
        expectCleanMessage(error.what());
        return error.what();
    }
    return "";
}

/// Reading fails, and the message holds each of these parts.
inline void expectError(const std::string& name, const std::string& bytes, std::initializer_list<const char*> parts,
                        const ReadOptions& options = {}) {
    const std::string message = catchError(name, bytes, options);
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

/// Reading leaves something out, and says so in just this sentence.
inline void expectLeftOut(const std::string& name, const std::string& bytes, const std::string& sentence) {
    const Molecule molecule = readMolecule(name, bytes);
    EXPECT_EQ(std::count(molecule.warnings.begin(), molecule.warnings.end(), sentence), 1) << sentence << ": " << bytes;
}

}  // namespace nacre::test
