#pragma once
// What `pdb:1BNA`, `pubchem:aspirin` and `afdb:P69905` mean: which addresses hold the structure, best first.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/read.h"

namespace nacre::app {

enum class Database { pdb, pubchem, afdb };

struct DatabaseId {
    Database database{};
    std::string id;     ///< checked: pdb in lower case, afdb in upper case, pubchem a number or a name
    std::string input;  ///< as the user wrote it, for messages
};

/// One place that a structure may come from.
struct Source {
    std::string cacheName;  ///< file name: lower-case letters, digits, '-', '_', '.'
    Format format{};
    std::string url;
    std::string jsonKey;  ///< not empty: `url` gives a list of predictions, and this key of it the address
    std::string note;     ///< not empty: what the user should know of a molecule from here
};

/// Empty if the text names no database: a file name, then.
/// @throws Error if the identifier is none of that database's
std::optional<DatabaseId> parseDatabaseId(const std::string& input);

/// What was probably meant by the name of a file that is not there: the INPUT of an identifier ("4HHB": "pdb:4hhb",
/// "P69905": "afdb:P69905") or of a sample ("dna"), or a file of its folder whose name is near or begins so. Empty if
/// nothing is near.
std::string meantInput(const std::string& path);

/// Environment variables by name; empty where one is not set.
using Environment = std::function<std::string(const char*)>;
std::string environmentVariable(const char* name);

/// Where to look, in this order. NACRE_PDB_URL, NACRE_PUBCHEM_URL and NACRE_AFDB_URL replace the addresses' beginnings.
/// @throws Error if one of them is no http or https address
std::vector<Source> sourcesOf(const DatabaseId& id, const Environment& environment = environmentVariable);

}  // namespace nacre::app
