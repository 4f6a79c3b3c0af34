#include "app/download/database_id.h"

#include <xxhash.h>

#include <algorithm>
#include <filesystem>

#include "engine/error.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

constexpr std::size_t kLongestName = 300;
constexpr std::size_t kMostCidDigits = 10;
constexpr std::size_t kMostNeighbours = 1000;  // entries examined next to a missing file

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }
bool isUpperOrDigit(char c) { return isUpper(c) || isDigit(c); }
bool isLowerOrDigit(char c) { return isLower(c) || isDigit(c); }

[[noreturn]] void refuse(const std::string& input, const std::string& why) {
    throw Error("cannot download", input, why);
}

/// "1bna", in lower case.
bool isShortPdbId(std::string_view id) {
    return id.size() == 4 && isDigit(id[0]) && std::all_of(id.begin() + 1, id.end(), isLowerOrDigit);
}

/// "1bna", or "pdb_" and eight letters and digits. A long form with a short equivalent becomes the short one.
std::string pdbId(const std::string& input, const std::string& text) {
    constexpr std::string_view kLong = "pdb_", kShortAsLong = "pdb_0000";
    std::string id = lowerCase(text);
    if (isShortPdbId(id)) return id;
    const bool isLong = id.size() == kLong.size() + 8 && id.rfind(kLong, 0) == 0 &&
                        std::all_of(id.begin() + kLong.size(), id.end(), isLowerOrDigit);
    if (!isLong)
        refuse(input, "a PDB identifier is a digit and three letters or digits (1BNA), or pdb_ and eight of them");
    const std::string tail = id.substr(kShortAsLong.size());
    return id.rfind(kShortAsLong, 0) == 0 && isShortPdbId(tail) ? tail : id;
}

/// Whether a text matches UniProt's pattern of accessions: https://www.uniprot.org/help/accession_numbers
bool isUniprotAccession(const std::string& id) {
    const auto letterBlock = [&](std::size_t at) {
        return isUpper(id[at]) && isUpperOrDigit(id[at + 1]) && isUpperOrDigit(id[at + 2]) && isDigit(id[at + 3]);
    };
    bool valid = (id.size() == 6 || id.size() == 10) && isUpper(id[0]) && isDigit(id[1]);
    if (valid && (id[0] == 'O' || id[0] == 'P' || id[0] == 'Q'))
        valid =
            id.size() == 6 && isUpperOrDigit(id[2]) && isUpperOrDigit(id[3]) && isUpperOrDigit(id[4]) && isDigit(id[5]);
    else if (valid)
        valid = letterBlock(2) && (id.size() == 6 || letterBlock(6));
    return valid;
}

std::string uniprotAccession(const std::string& input, const std::string& text) {
    std::string id = upperCase(text);
    if (!isUniprotAccession(id)) refuse(input, "a UniProt accession looks like P69905 or A0A024R1R8");
    return id;
}

bool isNumber(const std::string& text) { return !text.empty() && std::all_of(text.begin(), text.end(), isDigit); }

std::string pubchemId(const std::string& input, const std::string& text) {
    if (isNumber(text)) {
        if (text.size() > kMostCidDigits || text[0] == '0') refuse(input, "a PubChem CID is a number from 1");
        return text;
    }
    if (text.empty() || text.size() > kLongestName)
        refuse(input, "a compound's name has 1 to " + std::to_string(kLongestName) + " bytes");
    const auto isControl = [](char c) { return (c >= 0 && c < ' ') || c == 127; };
    if (std::any_of(text.begin(), text.end(), isControl) || text.find_first_not_of(". ") == std::string::npos)
        refuse(input, "not a compound name");
    return text;
}

/// Percent-encodes all but RFC 3986's unreserved characters.
std::string percentEncoded(std::string_view text) {
    std::string coded;
    for (const char c : text) {
        if (isUpperOrDigit(c) || isLower(c) || c == '-' || c == '_' || c == '.' || c == '~') {
            coded += c;
            continue;
        }
        coded += formatted("%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
    return coded;
}

/// File name part for a PubChem compound: a hash, since compound names may be longer than file names and contain any
/// character.
std::string pubchemFileName(const std::string& id) {
    if (isNumber(id)) return "pubchem-cid-" + id;
    const std::string name = lowerCase(id);
    const XXH128_hash_t hash = XXH3_128bits(name.data(), name.size());
    return formatted("pubchem-name-%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                     static_cast<unsigned long long>(hash.low64));
}

std::vector<Source> pdbSources(const std::string& id, const Environment& environment) {
    const std::string bcif = readBaseUrl(environment, "NACRE_PDB_URL", "https://models.rcsb.org");
    const std::string mmcif = readBaseUrl(environment, "NACRE_PDB_URL", "https://files.rcsb.org/download");
    return {{"pdb-" + id + ".bcif.gz", Format::bcif, bcif + "/" + id + ".bcif.gz", "", ""},
            {"pdb-" + id + ".cif.gz", Format::mmcif, mmcif + "/" + id + ".cif.gz", "", ""}};
}

std::vector<Source> pubchemSources(const std::string& id, const Environment& environment) {
    const std::string compound =
        readBaseUrl(environment, "NACRE_PUBCHEM_URL", "https://pubchem.ncbi.nlm.nih.gov/rest/pug") + "/compound/" +
        (isNumber(id) ? "cid/" + id : "name/" + percentEncoded(id)) + "/record/SDF?record_type=";
    const std::string file = pubchemFileName(id);
    return {{file + "-3d.sdf", Format::sdf, compound + "3d", "", ""},
            {file + "-2d.sdf", Format::sdf, compound + "2d", "",
             "PubChem has no 3D structure of this compound: this is its 2D drawing"}};
}

std::vector<Source> afdbSources(const std::string& id, const Environment& environment) {
    const std::string list =
        readBaseUrl(environment, "NACRE_AFDB_URL", "https://alphafold.ebi.ac.uk") + "/api/prediction/" + id;
    return {{"afdb-" + lowerCase(id) + ".bcif", Format::bcif, list, "bcifUrl", ""},
            {"afdb-" + lowerCase(id) + ".cif", Format::mmcif, list, "cifUrl", ""}};
}

}  // namespace

std::string meantInput(const std::string& path) {
    namespace fs = std::filesystem;
    const std::string lower = lowerCase(path), capital = upperCase(path);
    const std::vector<std::string> samples = sampleNames();
    if (std::find(samples.begin(), samples.end(), lower) != samples.end()) return "sample:" + lower;
    const fs::path folder = fs::path(path).parent_path();
    const std::string name = fs::path(path).filename().string();
    std::vector<std::string> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end;
         !name.empty() && !error && entry != end && files.size() < kMostNeighbours; entry.increment(error))
        if (entry->is_regular_file(error)) files.push_back(entry->path().filename().string());
    std::sort(files.begin(), files.end());  // independent of the system's listing order
    for (const std::string& file : files)
        if (lowerCase(file).starts_with(lowerCase(name) + ".") && formatOfFileName(file))
            return (folder / file).string();
    if (isShortPdbId(lower)) return "pdb:" + lower;
    if (isUniprotAccession(capital)) return "afdb:" + capital;
    const std::string near = nearestWord(name, files);
    return near.empty() ? near : (folder / near).string();
}

std::string readBaseUrl(const Environment& environment, const char* variable, const char* usual) {
    std::string url = environment(variable);
    if (url.empty()) return usual;
    if (!url.starts_with("http://") && !url.starts_with("https://"))
        throw Error("cannot download", variable,
                    "'" + nacre::printable(url, 200) + "' is not an http or https address");
    while (url.back() == '/') url.pop_back();
    return url;
}

std::optional<DatabaseId> parseDatabaseId(const std::string& input) {
    const std::size_t colon = input.find(':');
    if (colon == std::string::npos) return std::nullopt;
    const std::string database = lowerCase(input.substr(0, colon));
    const std::string id = input.substr(colon + 1);
    if (database == "pdb") return DatabaseId{Database::pdb, pdbId(input, id), input};
    if (database == "pubchem") return DatabaseId{Database::pubchem, pubchemId(input, id), input};
    if (database == "afdb") return DatabaseId{Database::afdb, uniprotAccession(input, id), input};
    return std::nullopt;
}

std::vector<Source> listSources(const DatabaseId& id, const Environment& environment) {
    switch (id.database) {
        case Database::pdb:
            return pdbSources(id.id, environment);
        case Database::pubchem:
            return pubchemSources(id.id, environment);
        case Database::afdb:
            return afdbSources(id.id, environment);
    }
    return {};
}

}  // namespace nacre::app
