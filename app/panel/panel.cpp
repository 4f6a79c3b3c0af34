// A frame of the panel from end to end. Its events are in panel_events.cpp. What stands in it is in chrome.cpp and the
// pages.

#include "app/panel/panel.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <mutex>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kSideBySidePoints = 640;  // of width: under it the panel is a sheet
constexpr float kPanelPoints = 316, kFingerPanelPoints = 360, kSheetPoints = 420, kMarginPoints = 10;

}  // namespace

Panel::Panel(double pixelsPerPoint, PanelHost host, PanelHand hand)
    : host_(std::move(host)),
      hand_(hand),
      pixelsPerPoint_(pixelsPerPoint),
      shown_(hand == PanelHand::mouse ? Shown::open : Shown::folded) {
    const std::lock_guard lock(Turn::turns);
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    addPanelFont(scale());
    state_ = std::make_unique<State>(darkTheme(), scale(), forFingers(), host_.fontWith);
    state_->ui.askText = host_.askText;
    setBrightness(Brightness::system);
#if IMGUI_VERSION_NUM < 18700
    mapKeys();
    if (host_.clipboard && host_.setClipboard) {
        io.ClipboardUserData = &host_;
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
    glyphsChanged_ = false;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&coverage, &width, &height);
    return {static_cast<std::uint32_t>(width),
            static_cast<std::uint32_t>(height),
            {coverage, coverage + std::ptrdiff_t{width} * height}};
}

void Panel::setBrightness(Brightness brightness) {
    const Turn turn(context_);
    brightness_ = brightness;
    const bool dark = brightness == Brightness::system ? host_.dark : brightness == Brightness::dark;
    state_->ui.setTheme(dark ? darkTheme() : lightTheme());
    setPanelStyle(state_->ui.theme(), scale(), forFingers());
    restless_ = 2;
}

const std::vector<Control>& Panel::controls() const { return state_->ui.controls; }

void Panel::togglePanel() {
    shown_ = shown_ == Shown::open ? (forFingers() ? Shown::folded : Shown::hidden) : Shown::open;
    keyboard_ = false;
    restless_ = 2;  // Dear ImGui needs a frame to measure
}

bool Panel::closeTop() {
    for (bool* open : {&help_, &saving_, &recording_, &start_})
        if (*open) {
            *open = false;
            restless_ = 2;
            return true;
        }
    return false;
}

/// Where the panel stands, and so where the molecule does.
void Panel::placePanel() {
    const float margin = kMarginPoints * scale();
    const float width = window_.right - window_.left, height = window_.bottom - window_.top;
    sheet_ = width < kSideBySidePoints * scale() || height > 1.15f * width;
    panel_ = window_;
    if (sheet_) {
        panel_.top = std::round(window_.bottom - std::clamp(0.46f * height, std::min(250 * scale(), 0.7f * height),
                                                            kSheetPoints * scale()));
    } else {
        panel_.left += margin, panel_.top += margin, panel_.bottom -= margin;
        panel_.right = panel_.left + (forFingers() ? kFingerPanelPoints : kPanelPoints) * scale();
    }
}

const Overlay* Panel::draw(Viewer& viewer, PixelSize size, double now) {
    const Turn turn(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(size.width), static_cast<float>(size.height));
    io.DeltaTime = static_cast<float>(std::clamp(now - last_, 1e-3, 0.1));
    last_ = now;
    pressButtons();
    if (restless_ > 0) --restless_;
    if (forFingers() && restless_ == 0 && !finger_) io.MousePos = ImVec2(-FLT_MAX, -FLT_MAX);  // the finger is gone
    window_ = {insets_.left, insets_.top, std::max(io.DisplaySize.x - insets_.right, insets_.left + 1),
               std::max(io.DisplaySize.y - insets_.bottom, insets_.top + 1)};
    const bool empty = !viewer.document() && !viewer.loading() && !viewer.question();
    const bool over = empty || start_ || help_ || saving_ || recording_;
    placePanel();
    // A phone has no room for panel and help at once.
    const bool open = shown_ == Shown::open && !empty && !(over && forFingers());
    Insets covered;
    if (open && sheet_) covered.bottom = io.DisplaySize.y - panel_.top;
    if (open && !sheet_) covered.left = panel_.right;
    covered.bottom += bar_;
    covered.right += state_->legendRoom;
    viewer.setCovered(covered, now);
    if (!open) panel_ = {window_.left, window_.bottom, window_.left, window_.bottom};

    if (state_->foreign.news()) addFonts();
    ImGui::NewFrame();
    occupied_.clear();
    state_->ui.controls.clear();
    state_->alongSequence &= page_ == Page::parts && open && !over;
    glide(io.DeltaTime);
    if (open) drawPanel(viewer, now);
    if (shown_ == Shown::folded && !over) drawMenuButton();
    if (!over) drawPlayBar(viewer, now);
    if (empty || start_) drawStart(viewer, now);
    if (saving_ && viewer.document()) drawSave(viewer);
    if (recording_ && viewer.document()) drawRecord(viewer, now);
    if (help_) drawHelp();
    drawRecording();
    preview(viewer, now);
    drawReading(viewer, now);
    if (!viewer.failure().empty() && !(empty || start_)) drawFailure(viewer);
    if (viewer.question()) drawQuestion(viewer, now);
    scroll_ = 0;
    state_->ui.typed.reset();  // its field is gone, if it was not taken
    drawWords(viewer);
    drawAnnotations(viewer.annotations());
    ImGui::Render();
    if (ImGui::IsAnyItemActive()) restless_ = std::max(restless_, 1);
    if (!ImGui::IsAnyItemActive()) editing_ = false;
    endKeys();
    collect();
    readTexts(viewer);
    return &overlay_;
}

/// All that is shown is also told: what of it the font lacks comes with the next frame.
void Panel::readTexts(const Viewer& viewer) {
    ForeignGlyphs& foreign = state_->foreign;
    for (const Control& control : state_->ui.controls)
        for (const std::string* text : {&control.name, &control.value}) foreign.read(visualText(*text));
    const SavedView& view = viewer.view();
    foreign.read(view.words.title);
    for (const Label& label : view.words.labels) foreign.read(label.text);
    if (foreign.news()) restless_ = std::max(restless_, 2);
}

/// The fonts anew, with those of the system.
void Panel::addFonts() {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    state_->foreign.find();
    fonts.Clear();
    addPanelFont(scale(), state_->foreign.fonts());
    fonts.Build();
    fonts.ClearInputData();  // files that are not the atlas's
    glyphsChanged_ = true;
}

void Panel::remember() {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    occupied_.push_back({at.x, at.y, at.x + size.x, at.y + size.y});
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
