// Finds every command and option by words: typed, chosen with the arrow keys or a click. "outlines 2" sets an option.

#include <algorithm>

#include "app/panel/panel_state.h"
#include "app/picture/options.h"
#include "app/viewer/presets.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

constexpr float kPalettePoints = 520;
constexpr std::size_t kMostRows = 10;
constexpr Topics kSettable = kAppearance | Topic::camera | Topic::background | Topic::lighting | Topic::occlusion |
                             Topic::effects | Topic::words;

struct Row {
    std::string name, about;  ///< as shown; `about` to its right
    std::string words;        ///< further words to search
    std::function<void(PanelFrame&)> run;
    std::string lowerName{}, lower{};  ///< the name, and all words, in lower case
};

Row makeRow(const Binding& binding) {
    return {binding.what, binding.keys, "", [command = binding.command](PanelFrame& f) { f.host.run(command); }};
}

/// A row for one choice of an option's control.
Row makeRow(const Option& option, const Option::Control::Choice& choice) {
    return {std::string(option.control.label ? option.control.label : option.key) + ": " + choice.label,
            "--" + std::string(option.key) + " " + choice.value, option.help + " " + choice.meaning,
            [&option, &choice](PanelFrame& f) { option.value.parse(choice.value, f.look); }};
}

std::string controlLabel(const Option& option) {
    std::string label = option.control.label ? option.control.label : std::string(option.key);
    label = label.substr(0, label.find_last_not_of(": ", label.find('%') - 1) + 1);  // a slider's label is "Fog %.2f"
    std::ranges::replace(label, '-', ' ');
    label[0] = upperCase(label.substr(0, 1))[0];
    return label;
}

/// Whether the option of a shown picture accepts a typed value.
bool takesTypedValue(const Option& option) {
    if (!option.value.parse || option.kind == Option::Kind::list) return false;
    if (option.topic == Topic::look) return !option.syntax.empty() && !option.value.print;  // a pocket, an interface
    return has(kSettable, option.topic) && option.value.print;
}

/// A row that asks for the option's value.
Row rowOfTyped(const Option& option) {
    return {controlLabel(option) + " ...", "--" + std::string(option.key) + " " + option.syntax, option.help,
            [&option](PanelFrame& f) {
                f.s.palette = {true, option.value.print ? option.value.print(f.look) : "", 0, &option};
                f.s.opened();
            }};
}

std::vector<Row> allRows() {
    std::vector<Row> rows;
    for (const Binding& binding : keyBindings()) {
        const bool known = !rows.empty() && rows.back().name == binding.what;  // listed under another key
        if (binding.listed && !known && binding.command != ViewerCommand::palette) rows.push_back(makeRow(binding));
    }
    for (const std::string_view page : Panel::pages())
        rows.push_back({"Page: " + std::string(page), "", "show open tab", [page](PanelFrame& f) { f.s.page = page; }});
    for (const Preset& preset : presets())
        rows.push_back({std::string("Preset: ") + preset.name, "", "look style",
                        [&preset](PanelFrame& f) { applyPreset(preset, f.look); }});
    for (const Option& option : options()) {
        for (const auto& choice : option.control.choices) rows.push_back(makeRow(option, choice));
        if (takesTypedValue(option) && option.control.choices.empty()) rows.push_back(rowOfTyped(option));
    }
    for (Row& row : rows) {
        row.lowerName = lowerCase(row.name);
        row.lower = row.lowerName + " " + lowerCase(row.about + " " + row.words);
    }
    return rows;
}

/// "contours 2": rows that set an option, by its key or label, to the rest of the text. @param typed  in original case
void addSettings(const std::string& typed, std::vector<Row>& rows) {
    const std::string sought = lowerCase(typed);
    for (const Option& option : options()) {
        if (!takesTypedValue(option)) continue;
        const std::string label = controlLabel(option), key(option.key);
        const std::string& what = sought.starts_with(key + " ") ? key : label;
        if (!sought.starts_with(lowerCase(what) + " ") || sought.size() < what.size() + 2) continue;
        const std::string value = typed.substr(what.size() + 1);
        PictureDescription tried;
        try {
            option.value.parse(value, tried);
        } catch (const std::exception&) {
            continue;
        }
        rows.push_back({label + ": " + value, "--" + std::string(option.key) + " " + value, "",
                        [&option, value](PanelFrame& f) { option.value.parse(value, f.look); }});
    }
}

/// The rows that have all words: those that begin with them first, then those that have them in their name.
std::vector<Row> foundRows(const std::string& typed) {
    static const std::vector<Row> kRows = allRows();
    const std::string sought = lowerCase(typed);
    std::vector<std::pair<int, const Row*>> found;
    for (const Row& row : kRows) {
        bool every = true, inName = true;
        for (std::size_t from = 0; from < sought.size();) {
            const std::size_t end = std::min(sought.find(' ', from), sought.size());
            const std::string word = sought.substr(from, end - from);
            every &= row.lower.find(word) != std::string::npos;
            inName &= row.lowerName.find(word) != std::string::npos;
            from = end + 1;
        }
        if (every) found.emplace_back(row.lowerName.starts_with(sought) ? 0 : inName ? 1 : 2, &row);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Row> rows;
    addSettings(typed, rows);
    for (const auto& [rank, row] : found) rows.push_back(*row);
    return rows;
}

/// Applies a row's change to the view; flies there if the change aims the camera.
void run(PanelFrame& f, const std::function<void(PanelFrame&)>& change) {
    beginLook(f);
    change(f);
    if (f.look.aim.zoomTo) f.s.aim.emplace(std::exchange(f.look.aim, f.before.aim));
    takeLook(f);
}

/// Asks for the value of an option without a control.
void drawValue(PanelFrame& f) {
    CommandPalette& palette = f.s.palette;
    const Option& option = *palette.option;
    const bool closed = beginCard(f, "Commands", controlLabel(option).c_str(), kPalettePoints);
    focusField(f);
    const bool entered =
        f.ui.field(("Value of " + std::string(option.key)).c_str(), option.syntax.c_str(), palette.sought, -1,
                   ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (entered) ImGui::SetKeyboardFocusHere(-1);  // after an invalid value
    std::string help = option.help;
    std::ranges::replace(help, '\n', ' ');
    f.ui.caption(help);
    std::string error;
    try {
        PictureDescription tried = f.viewer.view();
        if (!palette.sought.empty()) option.value.parse(palette.sought, tried);
    } catch (const std::exception& wrong) {
        error = wrong.what();
    }
    if (!error.empty()) f.ui.warning(error);
    ImGui::Spacing();
    const bool can = error.empty() && !palette.sought.empty();
    const Answer answers[] = {{"Cancel"}, {"Set", Icon::none, can}};
    const std::optional<std::size_t> pressed = f.ui.answers(answers);
    endGrown(f);
    const bool takes = can && (entered || pressed == 1u);
    if (!takes && !closed && pressed != 0u) return;
    const std::string value = palette.sought;
    palette = {};
    f.s.restless = 3;
    if (!takes) return;
    run(f, [&](PanelFrame& frame) {
        if (option.topic == Topic::look) frame.look.look.rules.clear(), frame.look.words.labels.clear();
        option.value.parse(value, frame.look);
    });
}

}  // namespace

void drawPalette(PanelFrame& f) {
    CommandPalette& palette = f.s.palette;
    if (palette.option) return drawValue(f);
    bool done = beginCard(f, "Commands", "Commands and options", kPalettePoints);
    focusField(f);
    const bool entered = f.ui.field("Find", "outlines, save, by chain, contours 2", palette.sought, -1,
                                    ImGuiInputTextFlags_EnterReturnsTrue);
    if (f.ui.edited()) palette.chosen = 0;
    std::vector<Row> rows = foundRows(palette.sought);
    const std::size_t all = rows.size();
    rows.resize(std::min(all, kMostRows));
    palette.chosen = std::clamp(palette.chosen, 0, std::max(static_cast<int>(rows.size()) - 1, 0));
    std::optional<std::size_t> pressed;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool chosen = static_cast<int>(i) == palette.chosen;
        if (f.ui.row(Icon::none, rows[i].name, -1, false, {}, chosen)) pressed = i;
        ImGui::PushFont(findFont(TextSize::caption));
        const ImVec2 high = ImGui::GetItemRectMax(), size = ImGui::CalcTextSize(rows[i].about.c_str());
        const float room = high.x - ImGui::GetItemRectMin().x - f.ui.px(40);
        if (ImGui::CalcTextSize(rows[i].name.c_str()).x * 1.3f + size.x < room)
            f.ui.write(ImVec2(high.x - size.x - f.ui.px(6), high.y - f.ui.rowHeight() / 2 - size.y / 2),
                       ImGui::GetColorU32(f.ui.theme().faint), rows[i].about);
        ImGui::PopFont();
        ImGui::PopID();
    }
    if (rows.empty()) f.ui.caption("Nothing matches these words.");
    if (all > rows.size()) f.ui.caption(std::to_string(all - rows.size()) + " more");
    if (entered && !rows.empty()) pressed = static_cast<std::size_t>(palette.chosen);
    endGrown(f);
    if (!pressed && !done) return;
    palette.open = false;
    f.s.restless = 3;
    if (!pressed) return;
    run(f, rows[*pressed].run);
}

}  // namespace nacre::app
