#include "app/desktop/state_files.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/files/json_text.h"
#include "app/viewer/kept_files.h"
#include "engine/srgb.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

/// Path of a state or cache file; empty if the environment names no folder.
std::string makePath(const char* variable, const char* underHome, const char* name) {
    if (const char* set = std::getenv(variable); set && *set == '/') return fs::path(set) / "nacre" / name;
    if (const char* home = std::getenv("HOME"); home && *home == '/')
        return fs::path(home) / underHome / "nacre" / name;
    return {};
}

std::string viewPath() { return makePath("XDG_STATE_HOME", ".local/state", "view.json"); }
std::string windowPath() { return makePath("XDG_STATE_HOME", ".local/state", "window.json"); }
std::string pipelinePath() { return makePath("XDG_CACHE_HOME", ".cache", "pipelines.bin"); }

/// Folder for saved files: empty, the current folder; if a desktop's menu started the program, that folder is not the
/// user's, so uses the user's.
fs::path savingFolder() {
    std::error_code error;
    const bool own = access(".", W_OK) == 0 && fs::current_path(error) != "/";
    const char* home = std::getenv("HOME");
    return own || !home ? fs::path() : fs::path(home);
}

constexpr std::uintmax_t kLargestList = 4u << 20;

std::string toHex(const std::vector<std::uint32_t>& pixels) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const std::uint32_t pixel : pixels)
        for (int shift = 0; shift < 24; shift += 8) {
            text += kDigits[pixel >> (shift + 4) & 15];
            text += kDigits[pixel >> shift & 15];
        }
    return text;
}

/// Empty unless the picture has this size.
std::vector<std::uint32_t> decodePixels(const std::string& hex, std::size_t count) {
    std::vector<std::uint32_t> pixels;
    if (hex.size() != count * 6) return pixels;
    for (std::size_t i = 0; i < hex.size(); i += 6) {
        std::uint32_t pixel = 0xff000000;
        for (std::size_t byte = 0; byte < 3; ++byte) {
            unsigned value = 0;
            const char* at = hex.data() + i + 2 * byte;
            if (std::from_chars(at, at + 2, value, 16).ptr != at + 2) return {};
            pixel |= value << (8 * byte);
        }
        pixels.push_back(pixel);
    }
    return pixels;
}

}  // namespace

constexpr const char* kBrightnesses[] = {"system", "dark", "light"};

WindowState loadWindowState() {
    WindowState state;
    const std::string path = windowPath();
    std::error_code error;
    if (path.empty() || fs::file_size(path, error) > kLargestList || error) return state;
    std::ifstream in(path);
    const auto json = parseJson<nlohmann::json>(std::string(std::istreambuf_iterator<char>(in), {}));
    if (!json.is_object()) return state;
    const auto side = [&](const char* key) {
        const auto value = json.find(key);
        return value != json.end() && value->is_number_unsigned() ? value->get<std::uint64_t>() : 0;
    };
    constexpr std::uint64_t kLeast = 200, kMost = 16384;  // points; other sizes are not a user's
    const std::uint64_t width = side("width"), height = side("height");
    if (std::min(width, height) >= kLeast && std::max(width, height) <= kMost)
        state.width = static_cast<std::uint32_t>(width), state.height = static_cast<std::uint32_t>(height);
    for (std::size_t i = 0; i < std::size(kBrightnesses); ++i)
        if (json.value("theme", nlohmann::json()) == kBrightnesses[i])
            state.brightness = static_cast<Panel::Brightness>(i);
    state.panelOpen = json.value("panel", nlohmann::json()) != false;
    state.darkCanvas = json.value("dark_background", nlohmann::json()) == true;
    state.textPercent = static_cast<int>(std::clamp<std::uint64_t>(side("text_percent"), 100, Panel::kMostTextPercent));
    return state;
}

void saveWindowState(const WindowState& state) {
    nlohmann::ordered_json json;
    if (state.width > 0) json["width"] = state.width, json["height"] = state.height;
    json["theme"] = kBrightnesses[static_cast<std::size_t>(state.brightness)];
    json["panel"] = state.panelOpen;
    json["dark_background"] = state.darkCanvas;
    json["text_percent"] = state.textPercent;
    keepText(windowPath(), jsonText(json));
}

std::string recentPath() { return makePath("XDG_STATE_HOME", ".local/state", "recent.json"); }
std::string samplesPath() { return makePath("XDG_CACHE_HOME", ".cache", "samples.json"); }
std::optional<PictureDescription> loadState() { return loadView(viewPath()); }
void saveState(const PictureDescription& view) { keepView(viewPath(), view); }
std::vector<std::byte> loadPipelineCache() { return loadPipelineCache(pipelinePath()); }
void savePipelineCache(const std::vector<std::byte>& data) { keepPipelineCache(pipelinePath(), data); }

std::string freeName(const std::string& input, const std::string& extension) {
    std::string stem =
        fs::path(input.substr(input.find(':') == std::string::npos ? 0 : input.find(':') + 1)).filename().string();
    if (const std::size_t dot = stem.find('.', 1); dot != std::string::npos) stem.resize(dot);
    if (stem.empty() || stem == "-") stem = "nacre";
    const fs::path folder = savingFolder();
    for (int n = 1;; ++n) {
        std::string name = stem;
        if (n > 1) name.append("-").append(std::to_string(n));
        const fs::path path = folder / (name + extension);
        if (!fs::exists(path)) return path.string();
    }
}

std::string savedMessage(const std::string& path) {
    std::error_code error;
    return "saved " + fs::absolute(path, error).lexically_normal().string();
}

RecentFiles::RecentFiles(std::string path) : path_(std::move(path)) {
    std::error_code none;
    if (path_.empty() || std::filesystem::file_size(path_, none) > kLargestList || none) return;
    std::ifstream in(path_);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const auto list = parseJson<nlohmann::json>(text);
    if (!list.is_array()) return;
    for (const auto& entry : list) {
        if (files_.size() == kMost || !entry.is_object() || !entry.contains("input") || !entry["input"].is_string())
            continue;
        RecentFile file;
        file.input = entry["input"];
        file.name = entry.contains("name") && entry["name"].is_string() ? entry["name"].get<std::string>() : file.input;
        for (const PixelSize size : {kPicture, kBanner}) {
            if (!file.pixels.empty() || !entry.contains("picture") || !entry["picture"].is_string()) continue;
            file.pixels = decodePixels(entry["picture"], std::size_t{size.width} * size.height);
            if (!file.pixels.empty()) file.width = size.width, file.height = size.height;
        }
        files_.push_back(std::move(file));
    }
}

void RecentFiles::add(const std::string& input, const std::string& name, const Picture& picture) {
    RecentFile file;
    file.input = input;
    file.name = name;
    const auto has = [&](PixelSize size) { return picture.width == size.width && picture.height == size.height; };
    if (has(kPicture) || has(kBanner)) {
        file.width = picture.width, file.height = picture.height;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
            std::uint8_t rgb[3];
            codePixel(&picture.rgba[i], false, rgb);
            file.pixels.push_back(0xff000000u | rgb[0] | rgb[1] << 8 | rgb[2] << 16);
        }
    }
    std::erase_if(files_, [&](const RecentFile& other) { return other.input == input; });
    files_.insert(files_.begin(), std::move(file));
    if (files_.size() > kMost) files_.resize(kMost);
    write();
}

void RecentFiles::write() const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const RecentFile& file : files_)
        list.push_back({{"input", file.input}, {"name", file.name}, {"picture", toHex(file.pixels)}});
    keepText(path_, jsonText(list));
}

}  // namespace nacre::app
