// Draws a whole frame of the panel. Its contents are in chrome.cpp, windows.cpp and the pages.

#include "app/panel/panel.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <ranges>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kSmallestPhonePoints = 320, kPhonePoints = 480;  // width
constexpr float kPhoneTarget = 44;                               // height of what is pressed there
constexpr float kSideBySidePoints = 600;                         // width; below, the panel is a sheet
constexpr float kPanelPoints = 316, kFingerPanelPoints = 360, kSheetPoints = 420, kMarginPoints = 10;

/// Places the panel; the molecule gets the rest.
void placePanel(PanelState& s) {
    const Widgets& ui = s.ui;
    const float margin = ui.px(kMarginPoints), width = s.window.width(), height = s.window.height();
    s.sheet = width < ui.px(kSideBySidePoints) || height > 1.15f * width;
    s.panel = s.window;
    s.takeStyle();
    if (s.sheet) {
        s.panel.top = std::round(s.window.bottom -
                                 std::clamp(0.46f * height, std::min(ui.px(250), 0.7f * height), ui.px(kSheetPoints)));
    } else {
        s.panel.left += margin, s.panel.top += margin, s.panel.bottom -= margin;
        s.panel.right = s.panel.left + ui.px(ui.forFingers() ? kFingerPanelPoints : kPanelPoints);
    }
}

/// Collects all displayed text: characters that the font lacks come with the next frame.
void readTexts(PanelState& s, const Words& words) {
    for (const Control& control : s.ui.controls)
        for (const std::string* text : {&control.name, &control.value}) s.foreign.read(visualText(*text));
    s.foreign.read(words.title);
    for (const Label& label : words.labels) s.foreign.read(label.text);
    if (s.foreign.news()) s.restless = std::max(s.restless, 2);
}

/// Rebuilds the fonts, with those of the system.
void addFonts(PanelState& s) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    s.foreign.find();
    fonts.Clear();
    addPanelFont(s.ui.px(1), s.foreign.fonts());
    fonts.Build();
    fonts.ClearInputData();  // files that the atlas does not own
    s.foreign.noteMissing(*fonts.Fonts[0]);
    s.glyphsChanged = true;
}

/// Dear ImGui's lists as one overlay.
void collect(Overlay& overlay) {
    overlay.vertices.clear();
    overlay.indices.clear();
    overlay.batches.clear();
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        const auto firstVertex = static_cast<std::uint32_t>(overlay.vertices.size());
        for (const ImDrawVert& v : list.VtxBuffer)
            overlay.vertices.push_back({v.pos.x, v.pos.y, v.uv.x, v.uv.y, v.col});
        OverlayEye eye = OverlayEye::both;
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback) eye = commandEye(command);
            if (command.ElemCount == 0 || command.UserCallback) continue;
            const ImVec4& clip = command.ClipRect;
            overlay.batches.push_back({clip.x, clip.y, clip.z, clip.w,
                                       static_cast<std::uint32_t>(overlay.indices.size()), command.ElemCount, eye});
            for (unsigned i = 0; i < command.ElemCount; ++i)
                overlay.indices.push_back(firstVertex + command.VtxOffset +
                                          list.IdxBuffer[static_cast<int>(command.IdxOffset + i)]);
        }
    }
}

}  // namespace

// --- open parts

void PanelState::toggle() {
    shown = shown != Shown::open ? Shown::open : ui.forFingers() ? Shown::folded : Shown::hidden;
    keyboard = false;
    restless = 2;  // Dear ImGui needs another frame to measure
}

namespace {

/// A card: its window's name, whether it is open, and functions that close and draw it.
struct Card {
    const char* name;
    bool (*open)(const PanelState&);
    void (*close)(PanelState&);
    void (*draw)(PanelFrame&);
    bool needsDocument = false;
};

// In stacking order, topmost last. Questions and the start screen of an empty window cannot be closed.
constexpr Card kCards[] = {
    {"Start", [](const PanelState& s) { return s.start || s.empty; }, [](PanelState& s) { s.start = false; },
     drawStart},
    {"Record", [](const PanelState& s) { return s.recording; }, [](PanelState& s) { s.recording = false; }, drawRecord,
     true},
    {"Save", [](const PanelState& s) { return s.saving; }, [](PanelState& s) { s.saving = false; }, drawSave, true},
    {"Help", [](const PanelState& s) { return s.help; }, [](PanelState& s) { s.help = false; }, drawHelp},
    {"Browse", [](const PanelState& s) { return s.browser.open; }, [](PanelState& s) { s.browser.open = false; },
     drawBrowse},
    {"Quit", [](const PanelState& s) { return s.quitting; }, [](PanelState& s) { s.quitting = false; }, drawQuit},
    {"Commands", [](const PanelState& s) { return s.palette.open; }, [](PanelState& s) { s.palette = {}; },
     drawPalette},
    {"Actions", [](const PanelState& s) { return s.context.has_value(); }, [](PanelState& s) { s.context.reset(); },
     drawContext},
    {"Dropped", [](const PanelState& s) { return !s.dropped.empty(); }, [](PanelState& s) { s.dropped.clear(); },
     drawDropped},
    {"Question", [](const PanelState& s) { return s.asks; }, [](PanelState&) {}, drawQuestion},
};

}  // namespace

bool PanelState::closeTop() {
    for (const Card& card : kCards | std::views::reverse) {
        if (!card.open(*this)) continue;
        card.close(*this);
        if (card.open(*this)) return false;  // it cannot be closed, and covers the others
        restless = 2;
        return true;
    }
    return false;
}

const char* PanelState::topCard() const {
    for (const Card& card : kCards | std::views::reverse)
        if (card.open(*this)) return card.name;
    return "";
}

void PanelState::askWhere(const std::string& what, const std::string& suggested, PathChosen chosen,
                          const char* button) {
    if (host.browses || !host.saveDialog) return browse(what, suggested, std::move(chosen), button);
    host.saveDialog(what, suggested, std::move(chosen));
}

void PanelState::setBrightness(Panel::Brightness to) {
    brightness = to;
    const bool dark = to == Panel::Brightness::system ? host.dark : to == Panel::Brightness::dark;
    ui.setTheme(dark ? darkTheme() : lightTheme());
    styled = nullptr;
    takeStyle();
    canvasDue = true;
    restless = 2;
}

/// A window as narrow as a phone's may be on a phone: its targets have the same size.
void PanelState::takeStyle() {
    const float points = window.width() / ui.px(1);
    const bool large = ui.forFingers() || (sheet && points >= kSmallestPhonePoints && points < kPhonePoints);
    if (styled == &ui.theme() && large == largeTargets) return;
    styled = &ui.theme();
    largeTargets = large;
    setPanelStyle(ui.theme(), ui.px(1), ui.forFingers(), large ? (ui.forFingers() ? kFingerPoints : kPhoneTarget) : 0);
    restless = std::max(restless, 2);
}

/// The picture's background follows the theme, if the user wants that and chose no other one.
void PanelState::followCanvas(Viewer& viewer, double now) {
    if (!viewer.document() || !std::exchange(canvasDue, false)) return;
    constexpr std::array<float, 4> kWhite{1, 1, 1, 1}, kDark{0x14 / 255.0f, 0x17 / 255.0f, 0x1b / 255.0f, 1};
    const bool dark = darkCanvas && ui.theme().dark;
    PictureDescription look = viewer.view();
    if (dark && look.background == kDark) canvasIsOurs = true;
    if (look.background != (dark ? kWhite : kDark) || (!dark && !canvasIsOurs)) return;
    canvasIsOurs = dark;
    look.background = dark ? kDark : kWhite;
    viewer.setLook(look, now, true);
}

bool PanelState::occupies(glm::dvec2 pixel) const {
    return std::any_of(occupied.begin(), occupied.end(), [&](const Rectangle& r) { return r.holds(pixel); });
}

Rectangle PanelState::freeRoom() const {
    if (sheet) return {window.left, window.top, window.right, panel.top - bar};
    return {std::max(panel.right, window.left), window.top, window.right, window.bottom - bar};
}

// --- the panel

Panel::Panel(double pixelsPerPoint, PanelHost host, PanelHand hand, int textPercent) {
    const std::lock_guard lock(Turn::turns);
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.KeyRepeatDelay = FLT_MAX;            // the system repeats keys
    io.ConfigInputTextCursorBlink = false;  // an idle window draws nothing
    state_ = std::make_unique<PanelState>(std::move(host), pixelsPerPoint, hand == PanelHand::fingers, textPercent);
    input_ = std::make_unique<PanelInput>(context_, *state_);
    addPanelFont(state_->ui.px(1));
    state_->setBrightness(Brightness::system);
#if IMGUI_VERSION_NUM < 18700
    if (state_->host.clipboard && state_->host.setClipboard) {
        io.ClipboardUserData = &state_->host;
        io.GetClipboardTextFn = [](void* p) { return static_cast<PanelHost*>(p)->clipboard(); };
        io.SetClipboardTextFn = [](void* p, const char* text) { static_cast<PanelHost*>(p)->setClipboard(text); };
    }
#endif
}

Panel::~Panel() {
    const Turn turn(context_);
    ImGui::DestroyContext(context_);
}

OverlayGlyphs Panel::glyphs() const {
    const Turn turn(context_);
    unsigned char* coverage = nullptr;
    int width = 0, height = 0;
    state_->glyphsChanged = false;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&coverage, &width, &height);
    return {static_cast<std::uint32_t>(width),
            static_cast<std::uint32_t>(height),
            {coverage, coverage + std::ptrdiff_t{width} * height}};
}

bool Panel::glyphsChanged() const { return state_->glyphsChanged; }
void Panel::setInsets(const Insets& insets) { state_->insets = insets, state_->restless = 2; }
void Panel::togglePanel() { state_->toggle(); }
void Panel::toggleHelp() { state_->help = !state_->help, state_->opened(); }
void Panel::showStart() { state_->start = true, state_->input.clear(), state_->opened(); }
void Panel::showPalette() { state_->palette = {}, state_->palette.open = true, state_->opened(); }
void Panel::showSave() { state_->saving = true, state_->opened(); }
void Panel::setSavePath(const std::string& path) { state_->setSavePath(path); }
void Panel::showRecord() { state_->recording = static_cast<bool>(state_->host.record), state_->opened(); }
void Panel::askToOpen(const std::vector<std::string>& paths) { state_->dropped = paths, state_->opened(); }
void Panel::askWhere(const std::string& title, const std::string& suggested, PathChosen chosen) {
    state_->askWhere(title, suggested, std::move(chosen));
}
void Panel::showPage(std::string_view label) { state_->page = label, state_->restless = 2; }
bool Panel::opensTogether() const { return state_->start && state_->together; }
void Panel::keepView(const Viewer& viewer) { app::keepView(*state_, viewer); }
std::size_t Panel::keptViews() const { return state_->movie.keys.size(); }
std::size_t Panel::unrecordedViews() const { return state_->movie.keysRecorded ? 0 : keptViews(); }
bool Panel::asksToQuit() const { return state_->quitting; }

void Panel::askToQuit(const std::string& unsaved) {
    state_->quitting = true;
    state_->unsaved = unsaved;
    state_->opened();
}

bool Panel::helpOpen() const { return state_->help; }
bool Panel::panelOpen() const { return state_->shown == PanelState::Shown::open; }
bool Panel::closeTop() { return state_->closeTop(); }
bool Panel::restless() const { return state_->restless > 0; }
const std::vector<Control>& Panel::controls() const { return state_->ui.controls; }

void Panel::setBrightness(Brightness brightness) {
    const Turn turn(context_);
    state_->setBrightness(brightness);
}

Panel::Brightness Panel::brightness() const { return state_->brightness; }
bool Panel::darkCanvas() const { return state_->darkCanvas; }
int Panel::textPercent() const { return state_->textPercent; }
std::string_view Panel::page() const { return state_->page; }
void Panel::setDarkCanvas(bool on) { state_->darkCanvas = state_->canvasDue = on; }

const Overlay* Panel::draw(Viewer& viewer, PixelSize size, double now) {
    const Turn turn(context_);
    PanelState& s = *state_;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(size.width), static_cast<float>(size.height));
    io.DeltaTime = static_cast<float>(std::clamp(now - last_, 1e-3, 0.1));
    last_ = now;
    input_->beginFrame(io.DeltaTime);
    s.window = {s.insets.left, s.insets.top, std::max(io.DisplaySize.x - s.insets.right, s.insets.left + 1),
                std::max(io.DisplaySize.y - s.insets.bottom, s.insets.top + 1)};
    if (const auto at = viewer.picking().takeAsked()) {
        s.context = ImVec2(static_cast<float>(at->x * s.pixelsPerPoint), static_cast<float>(at->y * s.pixelsPerPoint));
        s.opened();
    }
    s.asks = viewer.reading().question() != nullptr;
    s.empty = !viewer.document() && !viewer.reading().loader().busy() && !s.asks;
    const bool empty = s.empty, over = s.over() && !s.asks && !s.context;
    if (std::string top = s.topCard(); s.focusedCard != top) {
        s.focusedCard = std::move(top);
        if (over)
            s.opened();
        else if (!s.keyboard)
            ImGui::SetWindowFocus(nullptr);  // no focus ring unless the user moved the focus
    }
    placePanel(s);
    s.followCanvas(viewer, now);
    // A phone has no room for panel and help at once.
    const bool open = panelOpen() && !empty && !(over && s.ui.forFingers());
    Insets covered;
    if (open && s.sheet) covered.bottom = io.DisplaySize.y - s.panel.top;
    if (open && !s.sheet) covered.left = s.panel.right;
    covered.bottom += s.bar;
    covered.right += s.legendRoom;
    viewer.frames().setCovered(covered, now);
    if (!open) s.panel = {s.window.left, s.window.bottom, s.window.left, s.window.bottom};

    if (s.foreign.news()) addFonts(s);
    ImGui::NewFrame();
    s.occupied.clear();
    s.ui.controls.clear();
    s.sequence.focused &= s.page == "Parts" && open && !over;
    PanelFrame f{s, s.ui, s.host, viewer, now};
    if (open) drawPanel(f);
    if (s.shown == PanelState::Shown::folded && !over) drawMenuButton(f);
    if (!over) drawPlayBar(f);
    drawRecording(f);
    previewMovie(f);
    drawReading(f);
    if (!viewer.messages().failure().empty() && !(empty || s.start)) drawFailure(f);
    for (const Card& card : kCards)
        if (card.open(s) && (!card.needsDocument || viewer.document())) card.draw(f);
    s.scroll = 0;
    if (s.opening > 0) --s.opening;
    s.ui.typed.reset();  // its field vanished before taking it
    drawOutline(f);
    drawWords(f);
    drawAnnotations(f);
    ImGui::Render();
    // A focused field waits for keys, which request frames.
    if (ImGui::IsAnyItemActive() && !io.WantTextInput) s.restless = std::max(s.restless, 1);
    if (!ImGui::IsAnyItemActive()) s.editing = false;
    input_->endFrame();
    collect(overlay_);
    readTexts(s, viewer.view().words);
    return &overlay_;
}

}  // namespace nacre::app
