#include "app/desktop/panel.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/headless/option_values.h"
#include "app/viewer/presets.h"

namespace nacre::app {
namespace {

constexpr float kTextPoints = 15;
constexpr float kPanelPoints = 268;
constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf"};

// White and light grey on nearly black: 15:1 and 9:1, where WCAG 2.1 asks for 7:1 at its strictest.
const ImVec4 kText(0.96f, 0.97f, 0.98f, 1), kFaint(0.74f, 0.77f, 0.80f, 1), kGround(0.09f, 0.10f, 0.12f, 1);
const ImVec4 kAccent(0.16f, 0.43f, 0.72f, 1), kField(0.20f, 0.22f, 0.26f, 1), kWarning(1.0f, 0.80f, 0.45f, 1);
constexpr ImU32 kMark = IM_COL32(255, 190, 30, 255), kMarkEdge = IM_COL32(20, 22, 26, 230);

void setStyle(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    ImGui::StyleColorsDark(&style);
    style.WindowRounding = 8;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = 5;
    style.WindowPadding = ImVec2(14, 12);
    style.FramePadding = ImVec2(8, 4);
    style.ItemSpacing = ImVec2(8, 6);
    style.WindowBorderSize = style.PopupBorderSize = 0;
    style.ScaleAllSizes(scale);
    ImVec4* colors = style.Colors;
    colors[ImGuiCol_Text] = kText;
    colors[ImGuiCol_TextDisabled] = kFaint;
    colors[ImGuiCol_WindowBg] = colors[ImGuiCol_PopupBg] = kGround;
    colors[ImGuiCol_FrameBg] = colors[ImGuiCol_Button] = kField;
    colors[ImGuiCol_FrameBgHovered] = colors[ImGuiCol_ButtonHovered] = ImVec4(0.27f, 0.31f, 0.37f, 1);
    colors[ImGuiCol_FrameBgActive] = colors[ImGuiCol_ButtonActive] = colors[ImGuiCol_Header] = kAccent;
    colors[ImGuiCol_HeaderHovered] = colors[ImGuiCol_HeaderActive] = kAccent;
    colors[ImGuiCol_CheckMark] = ImVec4(0.45f, 0.75f, 1.0f, 1);
    colors[ImGuiCol_PlotHistogram] = kAccent;
    colors[ImGuiCol_Separator] = ImVec4(0.30f, 0.33f, 0.38f, 1);
}

/// "0 1 2" of the choices as a drop-down list. @returns whether another one was taken
bool choose(const char* label, std::span<const char* const> choices, std::string& current) {
    bool taken = false;
    if (!ImGui::BeginCombo(label, current.c_str())) return false;
    for (const char* choice : choices)
        if (ImGui::Selectable(choice, current == choice)) {
            taken = current != choice;
            current = choice;
        }
    ImGui::EndCombo();
    return taken;
}

void heading(const char* text) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", text);
}

}  // namespace

Panel::Panel(double pixelsPerPoint, std::function<void(ViewerCommand)> run)
    : context_(ImGui::CreateContext()), run_(std::move(run)), pixelsPerPoint_(pixelsPerPoint) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    const auto scale = static_cast<float>(pixelsPerPoint);
    for (const char* font : kFonts)
        if (std::filesystem::exists(font)) {
            io.Fonts->AddFontFromFileTTF(font, kTextPoints * scale);
            break;
        }
    if (io.Fonts->Fonts.empty()) io.Fonts->AddFontDefault();
    setStyle(scale);
    constexpr std::pair<ImGuiKey, SpecialKey> kKeys[] = {
        {ImGuiKey_LeftArrow, SpecialKey::left},     {ImGuiKey_RightArrow, SpecialKey::right},
        {ImGuiKey_UpArrow, SpecialKey::up},         {ImGuiKey_DownArrow, SpecialKey::down},
        {ImGuiKey_Home, SpecialKey::home},          {ImGuiKey_Escape, SpecialKey::escape},
        {ImGuiKey_Backspace, SpecialKey::backspace}};
    for (const auto& [theirs, ours] : kKeys) io.KeyMap[theirs] = static_cast<int>(keyOf(ours) - 0x110000);
}

Panel::~Panel() { ImGui::DestroyContext(context_); }

OverlayGlyphs Panel::glyphs() const {
    unsigned char* coverage = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&coverage, &width, &height);
    return {static_cast<std::uint32_t>(width),
            static_cast<std::uint32_t>(height),
            {coverage, coverage + std::ptrdiff_t{width} * height}};
}

// --- events

void Panel::pointer(glm::dvec2 at) {
    const bool was = ownsPointer();
    ImGui::GetIO().MousePos = ImVec2(static_cast<float>(at.x), static_cast<float>(at.y));
    if (was || ownsPointer()) restless_ = 2;
}

void Panel::button(MouseButton button, bool down) {
    const auto i = static_cast<std::size_t>(button == MouseButton::left ? 0 : button == MouseButton::right ? 1 : 2);
    down_[i] = down;
    if (down) pressed_[i] = true;
    restless_ = 3;
}

void Panel::wheel(double steps) {
    ImGui::GetIO().MouseWheel += static_cast<float>(steps);
    restless_ = 3;
}

void Panel::character(char32_t c) {
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
    restless_ = 3;
}

void Panel::key(SpecialKey key, bool down) {
    ImGui::GetIO().KeysDown[keyOf(key) - 0x110000] = down;
    restless_ = 3;
}

bool Panel::ownsPointer() const {
    const ImVec2 at = ImGui::GetIO().MousePos;
    return ImGui::IsAnyItemActive() || std::any_of(occupied_.begin(), occupied_.end(), [&](const Rectangle& r) {
               return at.x >= r.left && at.x < r.right && at.y >= r.top && at.y < r.bottom;
           });
}

bool Panel::ownsKeys() const { return ImGui::GetIO().WantTextInput; }

// --- layout

const Overlay* Panel::draw(Viewer& viewer, PixelSize size, double now) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(size.width), static_cast<float>(size.height));
    io.DeltaTime = static_cast<float>(std::clamp(now - last_, 1e-3, 0.1));
    last_ = now;
    // A click that came and went between two frames is still a click.
    for (int i = 0; i < 3; ++i) {
        io.MouseDown[i] = down_[i] || pressed_[i];
        pressed_[i] = false;
    }
    if (restless_ > 0) --restless_;
    ImGui::NewFrame();
    occupied_.clear();
    if (open_) drawPanel(viewer, now);
    if (help_) drawHelp();
    drawAnnotations(viewer.annotations());
    ImGui::Render();
    if (ImGui::IsAnyItemActive()) restless_ = std::max(restless_, 1);
    collect();
    return &overlay_;
}

void Panel::remember() {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    occupied_.push_back({at.x, at.y, at.x + size.x, at.y + size.y});
}

void Panel::drawPanel(Viewer& viewer, double now) {
    const auto scale = static_cast<float>(pixelsPerPoint_);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(12 * scale, 12 * scale));
    ImGui::SetNextWindowSizeConstraints(ImVec2(kPanelPoints * scale, 0),
                                        ImVec2(kPanelPoints * scale, std::max(display.y - 24 * scale, 1.0f)));
    ImGui::Begin("Nacre", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    remember();
    if (const Document* document = viewer.document()) {
        const std::string& input = document->view.input;
        ImGui::TextWrapped("%s", input.starts_with("sample:")
                                     ? input.c_str()
                                     : std::filesystem::path(input).filename().string().c_str());
        ImGui::TextDisabled("%zu atoms, %zu bonds drawn", document->scene.drawnAtoms, document->scene.drawnBonds);
    } else {
        ImGui::TextWrapped("%s", viewer.loading() ? "Reading ..." : "Drop a structure file here");
    }
    SavedView look = viewer.view();
    const std::string before = savedViewJson(look);
    drawLook(look);
    drawRules(look);
    bool turning = viewer.autoRotating();
    if (ImGui::Checkbox("Turn by itself", &turning)) run_(ViewerCommand::autoRotate);
    ImGui::Spacing();
    if (ImGui::Button("Whole")) run_(ViewerCommand::fit);
    ImGui::SameLine();
    if (ImGui::Button("Save PNG")) run_(ViewerCommand::savePicture);
    ImGui::SameLine();
    if (ImGui::Button("Help ?")) help_ = !help_;
    if (viewer.document() && viewer.occlusion() < 1) {
        char text[64];
        std::snprintf(text, sizeof text, "occlusion %.0f %%", 100 * viewer.occlusion());
        ImGui::ProgressBar(static_cast<float>(viewer.occlusion()), ImVec2(-1, 0), text);
    }
    ImGui::End();
    if (savedViewJson(look) != before) viewer.setLook(look, now);
}

void Panel::drawLook(SavedView& look) {
    heading("Style");
    constexpr std::pair<const char*, const char*> kStyles[] = {{"By size", ""},
                                                               {"Space-filling", "spacefill"},
                                                               {"Ball and stick", "ball-and-stick"},
                                                               {"Licorice", "licorice"}};
    for (const auto& [label, style] : kStyles) {
        if (ImGui::RadioButton(label, look.style == style)) look.style = style;
        if (label != kStyles[1].first && label != kStyles[3].first)
            ImGui::SameLine(132 * static_cast<float>(pixelsPerPoint_));
    }
    heading("Colours, background, preset");
    ImGui::PushItemWidth(-1);
    choose("##colours", colorChoices(), look.color);
    choose("##background", backgroundChoices(), look.background);
    if (ImGui::BeginCombo("##preset", "Presets")) {
        for (const Preset& preset : presets())
            if (ImGui::Selectable(preset.name)) applyPreset(preset, look);
        ImGui::EndCombo();
    }
    ImGui::PopItemWidth();
    heading("Show");
    const float column = 132 * static_cast<float>(pixelsPerPoint_);
    ImGui::Checkbox("Water", &look.drawn.water);
    ImGui::SameLine(column);
    ImGui::Checkbox("Hydrogens", &look.drawn.hydrogens);
    ImGui::Checkbox("Light", &look.lighting);
    ImGui::SameLine(column);
    bool occlusion = look.occlusionDirections > 0;
    if (ImGui::Checkbox("Occlusion", &occlusion))
        look.occlusionDirections = occlusion ? SavedView{}.occlusionDirections : 0;
    bool perspective = look.camera.projection == Projection::perspective;
    if (ImGui::Checkbox("Perspective", &perspective))
        look.camera.projection = perspective ? Projection::perspective : Projection::orthographic;
    ImGui::SameLine(column);
}

void Panel::drawRules(SavedView& look) {
    ImGui::NewLine();
    heading("Selection, as \"chain A\" or \"ligand\"");
    ImGui::PushItemWidth(-1);
    ImGui::InputText("##selection", selection_, sizeof selection_);
    ImGui::PopItemWidth();
    const auto add = [&](const char* option, const std::string& value) {
        try {
            SavedView trial = look;
            trial.rules.emplace_back(option, value);
            lookOf(trial);
            look.rules = trial.rules;
            ruleError_.clear();
        } catch (const std::exception& error) {
            ruleError_ = error.what();
        }
    };
    const std::string selection = selection_;
    if (ImGui::Button("Hide")) add("hide", selection);
    ImGui::SameLine();
    if (ImGui::Button("Balls")) add("show", selection + "=ball-and-stick");
    ImGui::SameLine();
    if (ImGui::Button("Sticks")) add("show", selection + "=licorice");
    ImGui::SameLine();
    if (ImGui::Button("Red")) add("color-by", selection + "=#e04030");
    if (!ruleError_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
        ImGui::TextWrapped("%s", ruleError_.c_str());
        ImGui::PopStyleColor();
    }
    if (look.rules.empty()) return;
    for (const auto& [option, value] : look.rules) ImGui::TextWrapped("%s %s", option.c_str(), value.c_str());
    if (ImGui::Button("Undo rule")) look.rules.pop_back();
}

void Panel::drawHelp() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(display.x / 2, display.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), display);
    ImGui::Begin("Help", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    remember();
    const auto row = [](const char* left, const char* right) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(left);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", right);
    };
    if (ImGui::BeginTable("pointer", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const PointerBinding& b : pointerBindings()) row(b.mouse, b.what);
        ImGui::EndTable();
    }
    ImGui::Separator();
    const std::span<const Binding> bindings = keyBindings();
    if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
        const std::size_t half = (bindings.size() + 1) / 2;
        for (std::size_t i = 0; i < half; ++i) {
            row(bindings[i].keys, bindings[i].what);
            if (i + half >= bindings.size()) continue;
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(bindings[i + half].keys);
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", bindings[i + half].what);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void Panel::drawAnnotations(const Annotations& a) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();  // beneath panel and help
    const auto scale = static_cast<float>(pixelsPerPoint_);
    const auto place = [&](const glm::dvec2& p) {
        return ImVec2(static_cast<float>(p.x) * scale, static_cast<float>(p.y) * scale);
    };
    for (std::size_t i = 1; i < a.atoms.size(); ++i) {
        list.AddLine(place(a.atoms[i - 1]), place(a.atoms[i]), kMarkEdge, 5 * scale);
        list.AddLine(place(a.atoms[i - 1]), place(a.atoms[i]), kMark, 2 * scale);
    }
    for (const glm::dvec2& atom : a.atoms) {
        list.AddCircle(place(atom), 8 * scale, kMarkEdge, 24, 5 * scale);
        list.AddCircle(place(atom), 8 * scale, kMark, 24, 2 * scale);
    }
    float bottom = ImGui::GetIO().DisplaySize.y - 14 * scale;
    const float line = ImGui::GetTextLineHeight() + 20 * scale;
    for (const auto& [text, strong] :
         {std::pair(a.message, false), std::pair(a.measurement, true), std::pair(a.atom, false)}) {
        if (text.empty()) continue;
        drawStatus(text, bottom, strong);
        bottom -= line;
    }
}

/// One line in a dark box, low in the middle of the window.
void Panel::drawStatus(const std::string& text, float bottom, bool strong) {
    const auto scale = static_cast<float>(pixelsPerPoint_);
    const float widest = ImGui::GetIO().DisplaySize.x - 48 * scale;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest);
    const float left = (ImGui::GetIO().DisplaySize.x - size.x) / 2;
    const ImVec2 pad(12 * scale, 7 * scale);
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled(ImVec2(left - pad.x, bottom - size.y - 2 * pad.y), ImVec2(left + size.x + pad.x, bottom),
                       ImGui::GetColorU32(kGround), 7 * scale);
    list.AddText(nullptr, 0, ImVec2(left, bottom - size.y - pad.y), ImGui::GetColorU32(strong ? kWarning : kText),
                 text.c_str(), nullptr, widest);
}

/// Dear ImGui's lists as one overlay.
void Panel::collect() {
    overlay_.vertices.clear();
    overlay_.indices.clear();
    overlay_.batches.clear();
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        const auto firstVertex = static_cast<std::uint32_t>(overlay_.vertices.size());
        for (const ImDrawVert& v : list.VtxBuffer)
            overlay_.vertices.push_back({v.pos.x, v.pos.y, v.uv.x, v.uv.y, v.col});
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.ElemCount == 0) continue;
            const ImVec4& clip = command.ClipRect;
            overlay_.batches.push_back({clip.x, clip.y, clip.z, clip.w,
                                        static_cast<std::uint32_t>(overlay_.indices.size()), command.ElemCount});
            for (unsigned i = 0; i < command.ElemCount; ++i)
                overlay_.indices.push_back(firstVertex + command.VtxOffset +
                                           list.IdxBuffer[static_cast<int>(command.IdxOffset + i)]);
        }
    }
}

}  // namespace nacre::app
