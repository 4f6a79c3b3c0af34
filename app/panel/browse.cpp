// File dialog for systems without one: to open a file, or to choose where an image is saved.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "app/panel/panel_state.h"
#include "app/viewer/file_kind.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

constexpr float kBrowsePoints = 560, kListPoints = 300;
constexpr std::size_t kMostEntries = 2000;

/// Folders first, then files by name. Reports unreadable folders.
void list(Browser& b) {
    b.entries.clear();
    b.error.clear();
    b.listed = true;
    std::error_code failed;
    for (fs::directory_iterator each(b.folder, failed), end; !failed && each != end; each.increment(failed)) {
        std::error_code unknown;
        const std::string name = each->path().filename().string();
        const bool folder = each->is_directory(unknown);
        if (name.starts_with('.') || (!folder && (b.saving() || !mayOpen(name)))) continue;
        b.entries.push_back({name, folder});
    }
    if (failed) b.error = "Cannot read " + b.folder + ": " + failed.message();
    std::sort(b.entries.begin(), b.entries.end(), [](const auto& x, const auto& y) {
        return std::tuple(!x.folder, lowerCase(x.name)) < std::tuple(!y.folder, lowerCase(y.name));
    });
    b.more = b.entries.size() > kMostEntries ? b.entries.size() - kMostEntries : 0;
    b.entries.resize(b.entries.size() - b.more);
}

void go(PanelFrame& f, const fs::path& folder) {
    Browser& b = f.s.browser;
    b.folder = folder.lexically_normal().string();
    if (!b.saving()) b.typed.clear();
    b.listed = false;
    f.s.restless = 3;
}

void take(PanelFrame& f, const fs::path& path) {
    f.s.browser.open = false;
    f.s.restless = 3;
    if (f.s.browser.saving())
        std::exchange(f.s.browser.chosen, nullptr)(path.string());
    else
        openInput(f, path.string());
}

/// Home, the current folder, and folders of recent files.
void drawPlaces(PanelFrame& f) {
    std::vector<std::pair<std::string, fs::path>> places;
    std::error_code failed;
    if (const char* home = std::getenv("HOME")) places.emplace_back("Home", home);
    places.emplace_back("Current folder", fs::current_path(failed));
    constexpr std::size_t kMostPlaces = 6;
    if (f.host.recent)
        for (const RecentFile& recent : f.host.recent()) {
            const fs::path folder = fs::path(recent.input).parent_path();
            const bool known = std::ranges::any_of(places, [&](const auto& p) { return p.second == folder; });
            if (folder.is_absolute() && !known && places.size() < kMostPlaces)
                places.emplace_back(folder.filename().string(), folder);
        }
    bool more = false;
    for (const auto& [word, folder] : places)
        if (f.ui.word(word.c_str(), std::exchange(more, true))) go(f, folder);
}

/// Typed text filters the names. @returns the first matching file or folder
std::optional<fs::path> drawEntries(PanelFrame& f, const std::string& sought) {
    const Browser& b = f.s.browser;
    std::optional<fs::path> first, clicked;
    int id = 0;
    for (const Browser::Entry& entry : b.entries) {
        if (lowerCase(entry.name).find(sought) == std::string::npos) continue;
        const fs::path path = fs::path(b.folder) / entry.name;
        if (!first) first = path;
        ImGui::PushID(id++);
        if (f.ui.row(entry.folder ? Icon::open : Icon::none, entry.name + (entry.folder ? "/" : ""), -1))
            clicked = path;
        ImGui::PopID();
    }
    if (id == 0 && b.error.empty()) f.ui.caption(b.saving() ? "No folders here." : "No structure files here.");
    if (b.more > 0) f.ui.caption(std::to_string(b.more) + " more are not listed.");
    std::error_code unknown;
    if (clicked) fs::is_directory(*clicked, unknown) ? go(f, *clicked) : take(f, *clicked);
    return first;
}

}  // namespace

void PanelState::browse(const std::string& what, const std::string& suggested, PathChosen chosen, const char* button) {
    std::error_code failed;
    const fs::path from = fs::absolute(suggested.empty() ? "." : suggested, failed);
    browser = {};
    browser.open = true;
    browser.title = what;
    browser.button = button;
    browser.chosen = std::move(chosen);
    browser.folder = (suggested.empty() ? from : from.parent_path()).lexically_normal().string();
    if (browser.saving()) browser.typed = from.filename().string();
    opened();
}

void drawBrowse(PanelFrame& f) {
    Browser& b = f.s.browser;
    if (!b.listed) list(b);
    if (beginCard(f, "Browse", b.title.c_str(), kBrowsePoints)) b.open = false;
    f.ui.name(b.folder);
    drawPlaces(f);
    const fs::path folder(b.folder);
    focusField(f);
    const bool entered = f.ui.field(b.saving() ? "File name" : "Name or folder", b.saving() ? "name" : "type to search",
                                    b.typed, -1, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::BeginChild("Files", ImVec2(0, std::min(f.ui.px(kListPoints), f.s.window.height() / 2)), false,
                      ImGuiWindowFlags_NavFlattened);
    if (folder.has_relative_path() && f.ui.row(Icon::up, "Parent folder", -1)) go(f, folder.parent_path());
    const std::optional<fs::path> first = drawEntries(f, b.saving() ? "" : lowerCase(b.typed));
    ImGui::EndChild();
    if (!b.error.empty()) f.ui.warning(b.error);
    std::error_code unknown;
    const fs::path typed = folder / b.typed;
    if (b.saving() && !b.typed.empty() && fs::is_regular_file(typed, unknown))
        f.ui.warning("A file of this name exists and is replaced.");
    const Answer answers[] = {{"Cancel"}, {b.button}};
    const auto pressed = f.ui.answers(answers);
    if (pressed == 1u || entered) {
        if (!b.typed.empty() && fs::is_directory(typed, unknown))
            go(f, typed);
        else if (!b.typed.empty() && (b.saving() || fs::exists(typed, unknown)))
            take(f, typed);
        else if (first && !b.typed.empty())
            fs::is_directory(*first, unknown) ? go(f, *first) : take(f, *first);
    }
    if (pressed == 0u) b.open = false;
    endGrown(f);
}

}  // namespace nacre::app
