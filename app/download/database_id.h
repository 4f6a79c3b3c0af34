#pragma once
// Identifiers such as `pdb:1BNA`, `pubchem:aspirin` and `afdb:P69905`, and their addresses, best first.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/files/cache_folder.h"
#include "engine/molecule/read.h"

namespace nacre::app {

enum class Database { pdb, pubchem, afdb };

struct DatabaseId {
    Database database{};
    std::string id;     ///< validated: pdb in lower case, afdb in upper case, pubchem a number or a name
    std::string input;  ///< as the user wrote it, for messages
};

/// One address of a structure.
struct Source {
    std::string cacheName;  ///< file name: lower-case letters, digits, '-', '_', '.'
    Format format{};
    std::string url;
    std::string jsonKey;  ///< not empty: `url` returns a list of predictions, whose key of this name has the address
    std::string note;     ///< not empty: a note for the user about molecules from this source
};

/// Empty if the text names no database: then it is a file name. @throws Error if the identifier is invalid for that
/// database
std::optional<DatabaseId> parseDatabaseId(const std::string& input);

/// A suggestion for a missing file: an identifier ("4HHB": "pdb:4hhb", "P69905": "afdb:P69905"), a sample ("dna"), or a
/// similar or longer name in its folder. Empty if there is none.
std::string meantInput(const std::string& path);

/// Environment variables by name; empty if not set.
using Environment = std::function<std::string(const char*)>;
/// First part of an address: from a variable, or the default. @throws Error
std::string readBaseUrl(const Environment& environment, const char* variable, const char* usual);

/// Addresses to try, in order. NACRE_PDB_URL, NACRE_PUBCHEM_URL and NACRE_AFDB_URL replace their first parts. @throws
/// Error if one is no http or https address
std::vector<Source> listSources(const DatabaseId& id, const Environment& environment = environmentVariable);

}  // namespace nacre::app
