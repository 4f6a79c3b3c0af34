#include "app/download/load_map.h"

#include <algorithm>
#include <filesystem>

#include "app/download/download.h"
#include "app/files/cache_folder.h"
#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "app/input/map_input.h"
#include "app/input/read_input.h"
#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

bool isId(const std::string& id, std::size_t least, std::size_t most, bool digitsAlone) {
    return id.size() >= least && id.size() <= most &&
           std::all_of(id.begin(), id.end(), [&](char c) { return isDigit(c) || (!digitsAlone && isLetter(c)); });
}

/// The beginning of an address. @throws Error
std::string baseOf(const Environment& environment, const char* variable, const char* usual) {
    std::string url = environment(variable);
    if (url.empty()) return usual;
    if (!startsWith(url, "http://") && !startsWith(url, "https://"))
        throw Error("cannot download", variable, "'" + printable(url) + "' is not an http or https address");
    while (url.back() == '/') url.pop_back();
    return url;
}

}  // namespace

std::optional<MapSource> mapSourceOf(const std::string& name, const Environment& environment) {
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos) return {};
    const std::string database = name.substr(0, colon), id = lowerCase(name.substr(colon + 1));
    if (database == "emdb") {
        std::string number = startsWith(id, "emd-") ? id.substr(4) : id;
        if (!isId(number, 4, 6, true)) throw Error("cannot download", name, "an EMDB ID is a number: emdb:3001");
        return MapSource{"emdb-" + number + ".map.gz",
                         baseOf(environment, "NACRE_EMDB_URL", "https://ftp.ebi.ac.uk/pub/databases/emdb/structures") +
                             "/EMD-" + number + "/map/emd_" + number + ".map.gz"};
    }
    if (database != "pdb-map" && database != "pdb-diff") return {};
    if (!isId(id, 4, 4, false) || !isDigit(id[0]))
        throw Error("cannot download", name, "a PDB ID has four characters: " + database + ":3nzd");
    const std::string file = id + (database == "pdb-diff" ? "_diff" : "") + ".ccp4";
    return MapSource{"pdb-map-" + file,
                     baseOf(environment, "NACRE_PDB_MAP_URL", "https://www.ebi.ac.uk/pdbe/entry-files") + "/" + file};
}

void loadMaps(const PictureDescription& picture, const std::function<void(double)>& onDownload) {
    const InputOptions& input = picture.input;
    for (const std::string& name : picture.maps.files) {
        const std::optional<MapSource> source = mapSourceOf(name);
        if (!source && !picture.given.contains("map")) {  // a saved view names it
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
        settings.limits.maxBytes = std::max<std::uint64_t>(settings.limits.maxBytes, mapLimits().maxBytes);
        settings.onProgress = onDownload;
        downloadFile(name, source->cacheName, source->url, settings, [&](const std::string& from, std::string bytes) {
            DensityMap map = readMap(from, std::move(bytes), mapLimits());
            map.difference = map.difference || startsWith(name, "pdb-diff:");
            keepMap(name, std::make_shared<const DensityMap>(std::move(map)));
        });
    }
}

}  // namespace nacre::app
