#include "app/download/download.h"

#include <charconv>
#include <exception>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/download/partial_file.h"
#include "app/files/json_text.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr int kAttempts = 3;  // attempts after lost connections; each resumes where the last one ended
constexpr std::uint64_t kLargestList = 4u << 20;
constexpr long kLongestPatience = 3600;

/// Bytes in memory; an interrupted download can be resumed by the next attempt.
class MemoryBody : public HttpBody {
public:
    std::uint64_t size() const override { return bytes_.size(); }
    std::string validator() const override { return validator_; }
    void restart(const std::string& validator) override {
        bytes_.clear();
        validator_ = validator;
    }
    void append(std::string_view bytes) override { bytes_ += bytes; }
    std::string& bytes() { return bytes_; }

private:
    std::string bytes_, validator_;
};

/// A failed transfer, and its address.
struct FailureAt : HttpFailure {
    FailureAt(std::string url, const std::string& why) : HttpFailure(why, false), address(std::move(url)) {}
    std::string address;
};

/// Failures by reason: each reason once, after all consecutive addresses that failed for it.
class Causes {
public:
    void add(const std::string& address, const std::string& why) {
        const bool same = !list_.empty() && list_.back().second == why;
        if (!same) return list_.push_back({{address}, why});
        auto& addresses = list_.back().first;
        if (addresses.back() != address) addresses.push_back(address);
    }
    std::string text(bool withAddresses) const {
        std::string all;
        for (const auto& [addresses, why] : list_) {
            if (!all.empty()) all += "; ";
            for (std::size_t i = 0; withAddresses && i < addresses.size(); ++i)
                all += (i == 0 ? "" : ", ") + addresses[i];
            all += (withAddresses && !addresses.front().empty() ? ": " : "") + why;
        }
        return all;
    }

private:
    std::vector<std::pair<std::vector<std::string>, std::string>> list_;
};

void get(const std::string& url, const HttpLimits& limits, HttpBody& body, const DownloadSettings& settings) {
    const auto progress = [&](std::uint64_t done, std::uint64_t all) {
        if (settings.onProgress && all > 0) settings.onProgress(static_cast<double>(done) / static_cast<double>(all));
    };
    for (int attempt = 1;; ++attempt) try {
            httpGet(url, limits, body, progress);
            return;
        } catch (const HttpFailure& failure) {
            if (!failure.brokeOff || attempt == kAttempts) throw FailureAt(url, failure.what());
        }
}

/// The file's own address, from AlphaFold DB's list of predictions. Like a redirect, it must not lead from https to
/// http.
std::string findAddress(const Source& source, const std::string& accession, const DownloadSettings& settings) {
    if (source.jsonKey.empty()) return source.url;
    MemoryBody body;
    HttpLimits limits = settings.limits;
    limits.maxBytes = kLargestList;
    get(source.url, limits, body, settings);
    const auto list = parseJson<nlohmann::json>(body.bytes());
    const auto fail = [&](const char* why) { throw FailureAt(source.url, why); };
    if (!list.is_array()) fail("the answer is not a list of predictions");
    if (list.empty()) fail("there is no such entry");
    const nlohmann::json* chosen = &list.front();
    for (const auto& entry : list)  // the list may include isoforms and complexes
        if (entry.is_object() && entry.value("uniprotAccession", nlohmann::json()) == accession) {
            chosen = &entry;
            break;
        }
    const auto url = chosen->is_object() ? chosen->value(source.jsonKey, nlohmann::json()) : nlohmann::json();
    const bool secure = source.url.rfind("https://", 0) == 0;
    if (!url.is_string() || url.get<std::string>().rfind(secure ? "https://" : "http://", 0) != 0)
        fail("the list of predictions names no usable address");
    return url;
}

Molecule read(const Source& source, const std::string& name, std::string bytes, ReadOptions options) {
    options.format = source.format;
    Molecule molecule = readMolecule(name, std::move(bytes), options);
    if (!source.note.empty()) molecule.warnings.push_back(source.note);
    return molecule;
}

/// Whether the bytes are a structure at all, regardless of the wanted model.
bool readable(const Source& source, const std::string& bytes) try {
    read(source, "", bytes, {});
    return true;
} catch (const Error&) {
    return false;
}

/// A structure without the requested part, such as a tenth model.
struct NotInIt {
    std::exception_ptr why;
};

/// Reads a cached file. Removes an unreadable one, which counts as missing.
std::optional<Molecule> readKept(const DiskCache& cache, const Source& source, const ReadOptions& options,
                                 const DownloadSettings& settings) {
    std::optional<std::string> bytes = cache.read(source.cacheName);
    if (!bytes) return std::nullopt;
    try {
        Molecule molecule = read(source, cache.entryPath(source.cacheName), *bytes, options);
        if (settings.onContent) settings.onContent(cache.entryPath(source.cacheName), std::move(*bytes), source.format);
        return molecule;
    } catch (const Error&) {
        if (readable(source, *bytes)) throw;
        cache.remove(source.cacheName);
        return std::nullopt;
    }
}

/// The answer of an address as a molecule; cached if valid. @throws HttpFailure, Error, NotInIt
Molecule fetch(const DiskCache& cache, const Source& source, const std::string& url, const ReadOptions& options,
               const DownloadSettings& settings) {
    MemoryBody memory;
    std::optional<PartialFile> file;
    if (cache.on() && cache.makeFolder()) file.emplace(cache, source.cacheName, url);
    get(url, settings.limits, file ? static_cast<HttpBody&>(*file) : memory, settings);
    const std::string bytes = file ? file->content() : std::move(memory.bytes());
    try {
        Molecule molecule = read(source, url, bytes, options);
        if (file) file->commit();
        if (settings.onContent) settings.onContent(url, bytes, source.format);
        return molecule;
    } catch (const Error&) {
        const bool whole = readable(source, bytes);
        if (file) whole ? file->commit() : file->discard();
        if (whole) throw NotInIt{std::current_exception()};
        throw;
    }
}

}  // namespace

HttpLimits httpLimits(const Environment& environment) {
    HttpLimits limits{.certificates = environment("NACRE_CA_FILE")};
    const std::string seconds = environment("NACRE_DOWNLOAD_TIMEOUT");
    if (seconds.empty()) return limits;
    long value = 0;
    const char* const end = seconds.data() + seconds.size();
    const auto parsed = std::from_chars(seconds.data(), end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end || value < 1 || value > kLongestPatience)
        throw Error("cannot download", "NACRE_DOWNLOAD_TIMEOUT",
                    "expected seconds from 1 to " + std::to_string(kLongestPatience) + ", not '" + seconds + "'");
    limits.patience = std::chrono::seconds(value);
    return limits;
}

namespace {

DiskCache downloadCache(const DownloadSettings& settings) {
    return {settings.cacheFolder, kDownloadCacheBytes, {"pdb-", "pubchem-", "afdb-", "emdb-", "mvs-"}};
}

void requireOnline(const std::string& input, const DiskCache& cache, const DownloadSettings& settings) {
    if (settings.offline)
        throw Error("cannot download", input,
                    !cache.on()        ? "--offline, and there is no cache"
                    : settings.verbose ? "--offline, and it is not in the cache, " + cache.folder()
                                       : "--offline, and it is not in the cache");
}

}  // namespace

void downloadFile(const std::string& input, const std::string& cacheName, const std::string& url,
                  const DownloadSettings& settings, const std::function<void(const std::string&, std::string)>& read) {
    const DiskCache cache = downloadCache(settings);
    if (std::optional<std::string> kept = cache.read(cacheName)) try {
            return read(cache.entryPath(cacheName), std::move(*kept));
        } catch (const Error&) {
            cache.remove(cacheName);
        }
    requireOnline(input, cache, settings);
    MemoryBody memory;
    std::optional<PartialFile> file;
    if (cache.on() && cache.makeFolder()) file.emplace(cache, cacheName, url);
    try {
        get(url, settings.limits, file ? static_cast<HttpBody&>(*file) : memory, settings);
    } catch (const FailureAt& failure) {
        const bool told = settings.verbose && failure.address != input;
        throw Error("cannot download", input, (told ? failure.address + ": " : "") + failure.what());
    }
    try {
        read(url, file ? file->content() : std::move(memory.bytes()));
    } catch (const Error&) {
        if (file) file->discard();
        throw;
    }
    if (file) file->commit();
}

Molecule downloadMolecule(const DatabaseId& id, const ReadOptions& options, const DownloadSettings& settings) {
    const DiskCache cache = downloadCache(settings);
    const std::vector<Source> sources = listSources(id, settings.environment);
    for (const Source& source : sources)
        if (auto molecule = readKept(cache, source, options, settings)) return std::move(*molecule);
    requireOnline(id.input, cache, settings);
    Causes causes;
    for (const Source& source : sources) try {
            return fetch(cache, source, findAddress(source, id.id, settings), options, settings);
        } catch (const NotInIt& problem) {
            std::rethrow_exception(problem.why);
        } catch (const FailureAt& failure) {
            causes.add(failure.address, failure.what());
        } catch (const Error& error) {
            causes.add("", error.what());
        }
    throw Error("cannot download", id.input, causes.text(settings.verbose));
}

}  // namespace nacre::app
