// What stands in the panel and in the help.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/panel/panel.h"
#include "app/panel/panel_style.h"
#include "app/shared/looks.h"
#include "app/shared/mesh_options.h"
#include "app/shared/notices.h"
#include "app/shared/option_text.h"
#include "app/shared/option_values.h"
#include "app/viewer/presets.h"

namespace nacre::app {
namespace {

constexpr float kPanelPoints = 268, kFingerPanelPoints = 320, kColumnPoints = 132, kFingerColumnPoints = 152;
constexpr float kFingerHelpPoints = 112, kQuestionPoints = 340;
constexpr int kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;

/// Selections that a finger chooses from; the molecule's chains come besides.
constexpr const char* kSelections[] = {"ligand", "protein", "nucleic", "ion", "backbone", "sidechain", "hetatm"};
constexpr std::size_t kMostChains = 40;

void heading(const char* text) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", text);
}

void row(const char* left, const char* right) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(left);
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", right);
    ImGui::PopTextWrapPos();
}

void drawKeys() {
    const std::span<const Binding> bindings = keyBindings();
    if (!ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) return;
    const std::size_t half = (bindings.size() + 1) / 2;
    const auto cells = [](const Binding& b) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(b.keys);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", b.what);
    };
    for (std::size_t i = 0; i < half; ++i) {
        ImGui::TableNextRow();
        cells(bindings[i]);
        if (i + half < bindings.size()) cells(bindings[i + half]);
    }
    ImGui::EndTable();
}

}  // namespace

/// A window that keeps its size to its content and to what the insets leave.
void Panel::beginWindow(const char* name, int moreFlags) {
    ImGui::Begin(name, nullptr, kFlags | moreFlags);
    remember();
    if (forFingers()) followFinger();
}

void Panel::drawMenuButton() {
    ImGui::SetNextWindowPos(ImVec2(insets_.left + 12 * scale(), insets_.top + 12 * scale()));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    beginWindow("Menu", ImGuiWindowFlags_NoScrollbar);
    if (ImGui::Button("Menu")) togglePanel();
    ImGui::End();
    ImGui::PopStyleVar();
}

void Panel::drawPanel(Viewer& viewer, double now) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float margin = 12 * scale();
    const float width = std::min((forFingers() ? kFingerPanelPoints : kPanelPoints) * scale(),
                                 std::max(display.x - insets_.left - insets_.right - 2 * margin, 1.0f));
    const float height = std::max(display.y - insets_.top - insets_.bottom - 2 * margin, 1.0f);
    ImGui::SetNextWindowPos(ImVec2(insets_.left + margin, insets_.top + margin));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, height));
    beginWindow("Nacre", 0);
    if (forFingers()) {
        if (ImGui::Button("Close")) togglePanel();
        ImGui::SameLine();
        if (ImGui::Button("Help")) toggleHelp();
        ImGui::SameLine();
        if (ImGui::Button("Whole")) run_(ViewerCommand::fit);
    }
    if (const Document* document = viewer.document()) {
        const std::string& input = document->view.input;
        ImGui::TextWrapped("%s", input.starts_with("sample:")
                                     ? input.c_str()
                                     : std::filesystem::path(input).filename().string().c_str());
        ImGui::TextDisabled("%zu atoms, %zu bonds drawn", document->scene.drawnAtoms, document->scene.drawnBonds);
    } else {
        ImGui::TextWrapped("%s", viewer.loading()    ? "Reading ..."
                                 : viewer.question() ? "Nothing is read yet"
                                 : forFingers()      ? "Open a structure from the file manager"
                                                     : "Drop a structure file here");
    }
    SavedView look = viewer.view();
    const std::string before = savedViewJson(look);
    drawLook(look);
    drawShown(look);
    drawEffects(look, viewer.document() ? viewer.document()->scene.radius : 1);
    drawRules(look, viewer.document() ? viewer.document()->molecule.get() : nullptr);
    bool turning = viewer.autoRotating();
    if (ImGui::Checkbox("Turn by itself", &turning)) run_(ViewerCommand::autoRotate);
    if (!forFingers()) {
        ImGui::Spacing();
        if (ImGui::Button("Whole")) run_(ViewerCommand::fit);
        ImGui::SameLine();
        if (ImGui::Button("Save PNG")) run_(ViewerCommand::savePicture);
        ImGui::SameLine();
        if (ImGui::Button("Help ?")) help_ = !help_;
    }
    if (viewer.document() && viewer.occlusion() < 1) {
        char text[64];
        std::snprintf(text, sizeof text, "occlusion %.0f %%", 100 * viewer.occlusion());
        ImGui::ProgressBar(static_cast<float>(viewer.occlusion()), ImVec2(-1, 0), text);
    }
    ImGui::End();
    if (savedViewJson(look) != before) viewer.setLook(look, now);
    if (aim_) viewer.aim(*std::exchange(aim_, std::nullopt), now);
}

/// One of the choices: a drop-down list for a mouse, one that unfolds in place for fingers.
/// @returns whether another one was taken
bool Panel::choose(const char* label, std::span<const char* const> choices, std::string& current) {
    bool taken = false;
    const auto offer = [&](const char* choice, const ImVec2& size) {
        if (!ImGui::Selectable(choice, current == choice, 0, size)) return;
        taken = current != choice;
        current = choice;
        unfolded_.clear();
    };
    if (!forFingers()) {
        if (!ImGui::BeginCombo(label, current.c_str())) return false;
        for (const char* choice : choices) offer(choice, ImVec2(0, 0));
        ImGui::EndCombo();
        return taken;
    }
    const bool open = unfolded_ == label;
    if (ImGui::Button((current + label).c_str(), ImVec2(-1, 0))) unfolded_ = open ? "" : label;
    if (!open) return false;
    ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0, 0.5f));
    ImGui::Indent();
    for (const char* choice : choices) offer(choice, ImVec2(0, kFingerPoints * scale()));
    ImGui::Unindent();
    ImGui::PopStyleVar();
    return taken;
}

void Panel::drawLook(SavedView& look) {
    const float column = (forFingers() ? kFingerColumnPoints : kColumnPoints) * scale();
    heading("Style");
    constexpr std::pair<const char*, std::optional<Style>> kStyles[] = {
        {"By size", std::nullopt},     {"Space-filling", Style::spacefill}, {"Ball and stick", Style::ballAndStick},
        {"Licorice", Style::licorice}, {"Cartoon", Style::cartoon},         {"Surface", Style::surface}};
    for (const auto& [label, style] : kStyles) {
        if (ImGui::RadioButton(label, look.look.style == style)) {
            look.look.style.reset();
            if (style) setStyle(*style, look.look);
        }
        const bool endsRow = label == kStyles[1].first || label == kStyles[3].first || label == kStyles[5].first;
        if (!forFingers() && !endsRow) ImGui::SameLine(column);
    }
    heading("Look, colours, background, preset");
    ImGui::PushItemWidth(-1);
    std::vector<const char*> names;
    for (const Look& named : looks()) names.push_back(named.name.c_str());
    std::string chosen = "Looks";
    if (choose("##look", names, chosen)) applyLook(lookOf(chosen), look);
    std::string color = coloringText(look.look.color), background = backgroundText(look.background);
    if (choose("##colours", colorChoices(), color)) look.look.color = parseColoring(color);
    if (choose("##background", backgroundChoices(), background)) look.background = parseColor(background);
    drawPresets(look);
    ImGui::PopItemWidth();
}

void Panel::drawPresets(SavedView& look) {
    std::vector<const char*> names;
    for (const Preset& preset : presets()) names.push_back(preset.name);
    std::string chosen = "Presets";
    if (!choose("##preset", names, chosen)) return;
    for (const Preset& preset : presets())
        if (chosen == preset.name) applyPreset(preset, look);
}

void Panel::drawShown(SavedView& look) {
    const float column = (forFingers() ? kFingerColumnPoints : kColumnPoints) * scale();
    heading("Show");
    ImGui::Checkbox("Water", &look.drawn.water);
    ImGui::SameLine(column);
    ImGui::Checkbox("Hydrogens", &look.drawn.hydrogens);
    ImGui::Checkbox("Legend", &look.words.legend);
    ImGui::SameLine(column);
    bool bar = look.words.scaleBar != ScaleBar::off;
    if (ImGui::Checkbox("Scale bar", &bar)) look.words.scaleBar = bar ? ScaleBar::angstrom : ScaleBar::off;
    ImGui::Checkbox("Light", &look.lighting);
    ImGui::SameLine(column);
    bool occlusion = look.occlusionDirections > 0;
    if (ImGui::Checkbox("Occlusion", &occlusion))
        look.occlusionDirections = occlusion ? SavedView{}.occlusionDirections : 0;
    bool perspective = look.camera.projection == Projection::perspective;
    if (ImGui::Checkbox("Perspective", &perspective))
        look.camera.projection = perspective ? Projection::perspective : Projection::orthographic;
}

/// A mouse comes with a keyboard: the selection is typed. Fingers choose one.
void Panel::drawRules(SavedView& look, const Molecule* molecule) {
    heading(forFingers() ? "Selection" : "Selection, as \"chain A\" or \"ligand\"");
    if (forFingers()) {
        std::vector<std::string> chains;
        if (molecule)
            for (const Chain& chain : molecule->chains)
                if (chain.model == molecule->chains.front().model && !chain.name.empty() && chains.size() < kMostChains)
                    chains.push_back("chain '" + chain.name + "'");
        std::vector<const char*> choices(std::begin(kSelections), std::end(kSelections));
        for (const std::string& chain : chains) choices.push_back(chain.c_str());
        choose("##selection", choices, picked_);
        drawRuleButtons(look, picked_);
    } else {
        ImGui::PushItemWidth(-1);
        ImGui::InputText("##selection", selection_, sizeof selection_);
        ImGui::PopItemWidth();
        drawRuleButtons(look, selection_);
    }
    if (!ruleError_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
        ImGui::TextWrapped("%s", ruleError_.c_str());
        ImGui::PopStyleColor();
    }
    for (const Label& label : look.words.labels) ImGui::TextWrapped("label %s", labelText(label).c_str());
    for (const Measure& measure : look.words.measures) ImGui::TextWrapped("measure %s", measure.text.c_str());
    if (!look.words.labels.empty() || !look.words.measures.empty())
        if (ImGui::Button("Forget labels")) look.words.labels.clear(), look.words.measures.clear();
    std::vector<Rule>& rules = look.look.rules;
    if (rules.empty()) return;
    for (const Rule& rule : rules) {
        const auto [option, value] = ruleText(rule);
        ImGui::TextWrapped("%s %s", option.c_str(), value.c_str());
    }
    if (ImGui::Button("Undo rule")) rules.pop_back();
}

void Panel::drawRuleButtons(SavedView& look, const std::string& selection) {
    const auto add = [&](Rule (*parse)(std::string_view), const std::string& value) {
        try {
            look.look.rules.push_back(parse(value));
            ruleError_.clear();
        } catch (const std::exception& error) {
            ruleError_ = error.what();
        }
    };
    if (ImGui::Button("Hide")) add(parseHide, selection);
    ImGui::SameLine();
    if (ImGui::Button("Balls")) add(parseShow, selection + "=ball-and-stick");
    ImGui::SameLine();
    if (ImGui::Button("Sticks")) add(parseShow, selection + "=licorice");
    ImGui::SameLine();
    if (ImGui::Button("Red")) add(parseColorBy, selection + "=#e04030");
    const auto aim = [&](std::optional<Selection> Aim::*which) {
        try {
            aim_.emplace();
            (*aim_).*which = parseSelection(selection);
            ruleError_.clear();
        } catch (const std::exception& error) {
            aim_.reset();
            ruleError_ = error.what();
        }
    };
    if (ImGui::Button("Label")) {
        try {
            look.words.labels.push_back(parseLabel(selection + "={residue} {number}"));
            ruleError_.clear();
        } catch (const std::exception& error) {
            ruleError_ = error.what();
        }
    }
    ImGui::SameLine();
    if (ImGui::Button("Look at")) aim(&Aim::lookAt);
    ImGui::SameLine();
    if (ImGui::Button("Close in")) aim(&Aim::zoomTo);
}

/// In the middle of the window, over everything else.
void Panel::drawQuestion(Viewer& viewer, double now) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(kQuestionPoints * scale(), std::max(display.x - 24 * scale(), 1.0f));
    ImGui::SetNextWindowPos(ImVec2(display.x / 2, display.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, display.y));
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(scale(), 1.0f));  // it may lie over the panel
    ImGui::PushStyleColor(ImGuiCol_Border, kFaint);
    beginWindow("Question", 0);
    ImGui::TextWrapped("%s", viewer.question()->what());
    ImGui::Spacing();
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    std::optional<bool> answer;
    if (ImGui::Button(viewer.question()->yes().c_str(), ImVec2(half, 0))) answer = true;
    ImGui::SameLine();
    if (ImGui::Button("Cancel", ImVec2(half, 0))) answer = false;
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    if (!answer) return;
    viewer.answer(*answer, now);
    restless_ = 2;
}

void Panel::drawHelp() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 left(insets_.left, insets_.top);
    const ImVec2 room(std::max(display.x - insets_.left - insets_.right, 1.0f),
                      std::max(display.y - insets_.top - insets_.bottom, 1.0f));
    ImGui::SetNextWindowPos(ImVec2(left.x + room.x / 2, left.y + room.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    // For fingers, lines are broken at the window's edge, which therefore has to be known.
    const float width = forFingers() ? std::min(room.x, 420 * scale()) : 0;
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(forFingers() ? width : room.x, room.y));
    beginWindow("Help", 0);
    if (ImGui::BeginTable("pointer", 2, ImGuiTableFlags_SizingFixedFit)) {
        if (forFingers()) {
            ImGui::TableSetupColumn("fingers", ImGuiTableColumnFlags_WidthFixed, kFingerHelpPoints * scale());
            ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed,
                                    ImGui::GetContentRegionAvail().x - (kFingerHelpPoints + 16) * scale());
        }
        for (const PointerBinding& b : pointerBindings()) row(forFingers() ? b.touch : b.mouse, b.what);
        ImGui::EndTable();
    }
    ImGui::Separator();
    if (!forFingers())
        drawKeys();
    else if (ImGui::Button("Close", ImVec2(-1, 0)))
        toggleHelp();
    if (ImGui::Button("Licences", ImVec2(forFingers() ? -1.0f : 0.0f, 0))) licences_ = !licences_;
    if (licences_) ImGui::TextUnformatted(notices());
    ImGui::End();
}

}  // namespace nacre::app
