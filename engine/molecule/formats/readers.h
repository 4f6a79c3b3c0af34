#pragma once
// One function per format. Only read.cpp calls them; each returns at least one atom or throws Error.
// Line ends of text are '\n' by then, and the bonds are those that the file states. Must also compile as C++17.
// The formats whose models stand in common tables read all of them at once where kAllModels asks for them, one
// Molecule each, whose summary is that of the file; otherwise, as the others do, the one model that is asked for.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/error.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

/// What a reader throws at the atom after the last that there is room for.
Error tooManyAtoms(const std::string& name, std::size_t maxAtoms);

Molecule readPdb(const std::string& name, std::string_view text, const ReadOptions&);
/// The model of the options, and all after it up to `lastModel`.
std::vector<Molecule> readMmcif(const std::string& name, std::string_view text, const ReadOptions&, int lastModel = 0);
std::vector<Molecule> readMmjson(const std::string& name, std::string_view text, const ReadOptions&, int lastModel = 0);
std::vector<Molecule> readBcif(const std::string& name, std::string_view bytes, const ReadOptions&, int lastModel = 0);
std::vector<Molecule> readMmtf(const std::string& name, std::string_view bytes, const ReadOptions&, int lastModel = 0);
Molecule readSdf(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readXyz(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readMol2(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readPqr(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readGro(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readPdbqt(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readCml(const std::string& name, std::string_view text, const ReadOptions&);

}  // namespace nacre
