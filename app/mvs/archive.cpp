#include "app/mvs/archive.h"

#include <zip.h>

#include <algorithm>
#include <map>

#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

constexpr zip_int64_t kMostEntries = 10'000;
constexpr std::uint64_t kMostBytes = 512ull << 20, kFreely = 1 << 20, kMostRatio = 100;

[[noreturn]] void refuseArchive(const std::string& name, const std::string& why) {
    throw Error("cannot read scene", name, why);
}

/// Whether a path is relative and has no steps upwards.
bool isInside(std::string_view entry) {
    if (entry.empty() || entry.front() == '/' || entry.find('\\') != std::string_view::npos ||
        entry.find(':') != std::string_view::npos)
        return false;
    for (std::size_t at = 0; at <= entry.size();) {
        const std::size_t end = std::min(entry.find('/', at), entry.size());
        if (entry.substr(at, end - at) == "..") return false;
        at = end + 1;
    }
    return true;
}

}  // namespace

struct SceneArchive::Zip {
    std::string bytes;
    zip_t* archive = nullptr;
    std::map<std::string, zip_uint64_t, std::less<>> entries;
    ~Zip() {
        if (archive) zip_discard(archive);
    }
};

bool looksLikeArchive(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

SceneArchive::SceneArchive(std::string name, std::string bytes)
    : name_(std::move(name)), zip_(std::make_unique<Zip>()) {
    zip_->bytes = std::move(bytes);
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(zip_->bytes.data(), zip_->bytes.size(), 0, &error);
    zip_->archive = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr;
    const std::string why = zip_error_strerror(&error);
    zip_error_fini(&error);
    if (!zip_->archive) {
        if (source) zip_source_free(source);
        refuseArchive(name_, "it is no zip: " + nacre::printable(why, 100));
    }
    const zip_int64_t count = zip_get_num_entries(zip_->archive, 0);
    if (count > kMostEntries) refuseArchive(name_, "it has more than " + std::to_string(kMostEntries) + " entries");
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* entry = zip_get_name(zip_->archive, static_cast<zip_uint64_t>(i), ZIP_FL_ENC_GUESS);
        if (!entry) refuseArchive(name_, "an entry has no name");
        const std::string_view path = entry;
        if (path.ends_with("/")) continue;
        if (!isInside(path)) refuseArchive(name_, "the entry '" + nacre::printable(path) + "' leads out of it");
        zip_->entries.emplace(path, static_cast<zip_uint64_t>(i));
    }
    if (!holds("index.mvsj")) refuseArchive(name_, "it is a zip without index.mvsj");
}

SceneArchive::~SceneArchive() = default;

bool SceneArchive::holds(const std::string& entry) const { return zip_->entries.contains(entry); }

std::string SceneArchive::read(const std::string& entry) const {
    const auto found = zip_->entries.find(entry);
    if (found == zip_->entries.end()) refuseArchive(name_, "it has no entry '" + nacre::printable(entry) + "'");
    zip_stat_t facts;
    zip_stat_init(&facts);
    if (zip_stat_index(zip_->archive, found->second, 0, &facts) != 0 || !(facts.valid & ZIP_STAT_SIZE) ||
        !(facts.valid & ZIP_STAT_COMP_SIZE))
        refuseArchive(name_, "the size of '" + nacre::printable(entry) + "' is not stated");
    if (facts.size > kMostBytes || (facts.size > kFreely && facts.size / kMostRatio > facts.comp_size))
        refuseArchive(name_, "'" + nacre::printable(entry) + "' inflates to " + std::to_string(facts.size) +
                                 " bytes, more than allowed");
    zip_file_t* file = zip_fopen_index(zip_->archive, found->second, 0);
    if (!file)
        refuseArchive(name_, "'" + nacre::printable(entry) + "' cannot be opened: " +
                                 nacre::printable(zip_error_strerror(zip_get_error(zip_->archive)), 100));
    std::string bytes(facts.size, '\0');
    std::size_t at = 0;
    while (at < bytes.size()) {
        const zip_int64_t got = zip_fread(file, bytes.data() + at, bytes.size() - at);
        if (got <= 0) break;
        at += static_cast<std::size_t>(got);
    }
    const bool whole = zip_fclose(file) == 0 && at == bytes.size();
    if (!whole) refuseArchive(name_, "'" + nacre::printable(entry) + "' is damaged");
    return bytes;
}

}  // namespace nacre::app::mvs
