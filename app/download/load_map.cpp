#include "app/download/load_map.h"

#include <algorithm>
#include <filesystem>

#include "app/download/database_id.h"
#include "app/download/download.h"
#include "app/files/cache_folder.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "app/input/map_input.h"
#include "app/input/read_input.h"
#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

/// Addresses of `emdb:3001`, `pdb-map:3nzd` (2Fo-Fc) and `pdb-diff:3nzd` (Fo-Fc). NACRE_EMDB_URL, NACRE_EMDB_API_URL
/// and NACRE_PDB_MAP_URL replace their first parts.
struct MapSource {
    std::string cacheName, url;
    std::string levelUrl;  ///< JSON about an EMDB entry's map; empty: none
};

bool isId(const std::string& id, std::size_t least, std::size_t most, bool digitsAlone) {
    return id.size() >= least && id.size() <= most &&
           std::all_of(id.begin(), id.end(), [&](char c) { return isDigit(c) || (!digitsAlone && isLetter(c)); });
}

/// First or primary level in "map" / "contour_list" / "contour".
std::optional<double> levelIn(const std::string& bytes) {
    const auto json = parseJson<nlohmann::json>(bytes);
    const nlohmann::json::json_pointer contours("/map/contour_list/contour");
    if (json.is_discarded() || !json.is_object() || !json.contains(contours)) return std::nullopt;
    std::optional<double> level;
    for (const auto& contour : json[contours]) {
        const auto found = contour.is_object() ? contour.find("level") : contour.end();
        if (found == contour.end() || !found->is_number()) continue;
        const bool primary = contour.value("primary", nlohmann::json(false)) == true;
        if (primary || !level) level = found->get<double>();
        if (primary) break;
    }
    return level;
}

/// On failure the default level of cryo-EM maps applies.
std::optional<double> depositedLevel(const std::string& name, const MapSource& source,
                                     const DownloadSettings& settings) {
    std::optional<double> level;
    try {
        downloadFile(name, source.cacheName + ".json", source.levelUrl, settings,
                     [&](const std::string&, const std::string& bytes) {
                         if (parseJson<nlohmann::json>(bytes).is_discarded())
                             throw Error("cannot read", name, "the answer is no JSON");
                         level = levelIn(bytes);
                     });
    } catch (const Error& error) {
        sayNotice(name + ": the depositors' level is not known, the default is that of the top 1 % (" + error.what() +
                  ")");
    }
    return level;
}

/// Empty if the text names no such database; then it is a file. @throws Error if the identifier is invalid
std::optional<MapSource> findMapSource(const std::string& name) {
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos) return {};
    const std::string database = name.substr(0, colon), id = lowerCase(name.substr(colon + 1));
    if (database == "emdb") {
        std::string number = startsWith(id, "emd-") ? id.substr(4) : id;
        if (!isId(number, 4, 6, true)) throw Error("cannot download", name, "an EMDB ID is a number: emdb:3001");
        return MapSource{
            "emdb-" + number + ".map.gz",
            readBaseUrl(environmentVariable, "NACRE_EMDB_URL", "https://ftp.ebi.ac.uk/pub/databases/emdb/structures") +
                "/EMD-" + number + "/map/emd_" + number + ".map.gz",
            readBaseUrl(environmentVariable, "NACRE_EMDB_API_URL", "https://www.ebi.ac.uk/emdb/api") +
                "/entry/map/EMD-" + number};
    }
    if (database != "pdb-map" && database != "pdb-diff") return {};
    if (!isId(id, 4, 4, false) || !isDigit(id[0]))
        throw Error("cannot download", name, "a PDB ID has four characters: " + database + ":3nzd");
    const std::string file = id + (database == "pdb-diff" ? "_diff" : "") + ".ccp4";
    return MapSource{
        "pdb-map-" + file,
        readBaseUrl(environmentVariable, "NACRE_PDB_MAP_URL", "https://www.ebi.ac.uk/pdbe/entry-files") + "/" + file,
        ""};
}

}  // namespace

void loadMaps(const PictureDescription& picture, const std::function<void(double)>& onDownload) {
    const InputOptions& input = picture.input;
    const auto isGiven = [&](const char* key) { return picture.given.contains(key); };
    const bool given = isGiven("map") || isGiven("map-color-from") || isGiven("surface-color-from");
    for (const std::string& name : mapFiles(picture.maps)) {
        const std::optional<MapSource> source = findMapSource(name);
        if (!source && !given) {  // named by a saved view
            InputOptions named = input;
            named.path = std::filesystem::absolute(name).string();
            named.hash.clear();
            if (const std::string notice = outsideNotice(named); !notice.empty()) sayNotice(notice);
        }
        if (!source || keptMap(name)) continue;
        const bool forbidden = !input.namedBy.empty() && !input.allowDownload;
        DownloadSettings settings;
        settings.cacheFolder = cacheFolder(input.cache, "downloads");
        settings.offline = input.offline || forbidden;
        settings.limits = httpLimits();
        settings.limits.maxBytes = std::max<std::uint64_t>(settings.limits.maxBytes, mapLimits(input).maxBytes);
        settings.onProgress = onDownload;
        DensityMap map;
        downloadFile(name, source->cacheName, source->url, settings, [&](const std::string& from, std::string bytes) {
            map = readMap(from, std::move(bytes), mapLimits(input));
        });
        map.difference = map.difference || startsWith(name, "pdb-diff:");
        if (!source->levelUrl.empty()) map.depositedLevel = depositedLevel(name, *source, settings);
        keepMap(name, std::make_shared<const DensityMap>(std::move(map)));
    }
}

}  // namespace nacre::app
