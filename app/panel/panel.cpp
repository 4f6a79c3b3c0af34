// The panel's events, and a frame of it from end to end. What stands in it is in chrome.cpp and the pages.

#include "app/panel/panel.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kSideBySidePoints = 640;  // of width: under it the panel is a sheet
constexpr float kPanelPoints = 316, kFingerPanelPoints = 360, kSheetPoints = 420, kMarginPoints = 10;
constexpr float kStillPoints = 20;  // a second: a list that glides slower stands

constexpr std::pair<ImGuiKey, SpecialKey> kKeys[] = {{ImGuiKey_LeftArrow, SpecialKey::left},
                                                     {ImGuiKey_RightArrow, SpecialKey::right},
                                                     {ImGuiKey_UpArrow, SpecialKey::up},
                                                     {ImGuiKey_DownArrow, SpecialKey::down},
                                                     {ImGuiKey_Home, SpecialKey::home},
                                                     {ImGuiKey_Escape, SpecialKey::escape},
                                                     {ImGuiKey_Backspace, SpecialKey::backspace},
                                                     {ImGuiKey_Enter, SpecialKey::enter},
                                                     {ImGuiKey_Tab, SpecialKey::tab},
                                                     {ImGuiKey_Delete, SpecialKey::remove},
                                                     {ImGuiKey_End, SpecialKey::end},
                                                     {ImGuiKey_PageUp, SpecialKey::pageUp},
                                                     {ImGuiKey_PageDown, SpecialKey::pageDown}};
constexpr std::pair<ImGuiKey, char32_t> kLetters[] = {{ImGuiKey_Space, U' '}, {ImGuiKey_A, U'a'}, {ImGuiKey_C, U'c'},
                                                      {ImGuiKey_V, U'v'},     {ImGuiKey_X, U'x'}, {ImGuiKey_Y, U'y'},
                                                      {ImGuiKey_Z, U'z'}};

std::recursive_mutex turns;

#if IMGUI_VERSION_NUM < 18700
int indexOf(SpecialKey key) { return static_cast<int>(keyOf(key) - 0x110000); }
int indexOf(char32_t letter) { return 256 + static_cast<int>(letter & 0x7f); }
#endif

}  // namespace

/// Dear ImGui works on one context, named by a global variable: panels on other threads wait for their turn.
class Panel::Turn {
public:
    explicit Turn(ImGuiContext* context) : lock_(turns) { ImGui::SetCurrentContext(context); }

private:
    std::lock_guard<std::recursive_mutex> lock_;
};

Panel::Panel(double pixelsPerPoint, PanelHost host, PanelHand hand)
    : host_(std::move(host)),
      hand_(hand),
      pixelsPerPoint_(pixelsPerPoint),
      shown_(hand == PanelHand::mouse ? Shown::open : Shown::folded) {
    const std::lock_guard lock(turns);
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    addPanelFont(scale());
    state_ = std::make_unique<State>(darkTheme(), scale(), forFingers(), host_.fontWith);
    setBrightness(Brightness::system);
#if IMGUI_VERSION_NUM < 18700
    for (const auto& [theirs, ours] : kKeys) io.KeyMap[theirs] = indexOf(ours);
    for (const auto& [theirs, ours] : kLetters) io.KeyMap[theirs] = indexOf(ours);
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

// --- events

void Panel::pointer(glm::dvec2 at) {
    const Turn turn(context_);
    const bool was = ownsPointer();
    ImGui::GetIO().MousePos = ImVec2(static_cast<float>(at.x), static_cast<float>(at.y));
    if (was || ownsPointer()) restless_ = 2;
}

void Panel::button(MouseButton button, bool down) {
    const Turn turn(context_);
    const auto i = static_cast<std::size_t>(button == MouseButton::left ? 0 : button == MouseButton::right ? 1 : 2);
    down_[i] = down;
    if (down) pressed_[i] = true;
    const ImVec2 at = ImGui::GetIO().MousePos;
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (down && !popup && !occupies({at.x, at.y})) closeTop();  // a click beside
    keyboard_ = false;
    restless_ = 3;
}

void Panel::wheel(double steps) {
    const Turn turn(context_);
    ImGui::GetIO().MouseWheel += static_cast<float>(steps);
    restless_ = 3;
}

void Panel::character(char32_t c) {
    const Turn turn(context_);
    ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) io.AddInputCharacter(static_cast<unsigned>(c));
#if IMGUI_VERSION_NUM < 18700
    if (c == U' ' && !io.WantTextInput) shortcut(U' ');  // presses what has the focus
#endif
    restless_ = 3;
}

void Panel::shortcut(char32_t letter) {
    const Turn turn(context_);
#if IMGUI_VERSION_NUM < 18700
    ImGuiIO& io = ImGui::GetIO();
    for (const auto& [theirs, ours] : kLetters)
        if (ours == letter) {
            io.KeysDown[indexOf(ours)] = true;  // until the next frame is drawn
            io.KeyCtrl = letter != U' ';
        }
#else
    (void)letter;
#endif
    restless_ = 3;
}

void Panel::key(SpecialKey key, bool down, Modifiers with) {
    const Turn turn(context_);
    ImGuiIO& io = ImGui::GetIO();
    restless_ = 3;
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (key == SpecialKey::tab && !io.WantTextInput && !popup) {
        if (!down) return;
        // Into the panel, and on to its next control.
        keyboard_ = shown_ == Shown::open || help_ || saving_ || start_;
        key = with.shift ? SpecialKey::up : SpecialKey::down;
        pressedKey_ = key;
    }
    if (key == SpecialKey::escape && down && !popup && !io.WantTextInput) keyboard_ = false;
    if (state_->alongSequence && keyboard_ && (key == SpecialKey::left || key == SpecialKey::right)) {
        if (down) state_->sequenceStep = key == SpecialKey::left ? -1 : 1;
        state_->sequenceExtends = with.shift;
        return;
    }
#if IMGUI_VERSION_NUM < 18700
    io.KeysDown[indexOf(key)] = down;
    io.KeyShift = with.shift;
    io.KeyCtrl = with.control;
#else
    for (const auto& [theirs, ours] : kKeys)
        if (ours == key) io.AddKeyEvent(theirs, down);
#endif
}

bool Panel::occupies(glm::dvec2 pixel) const {
    return std::any_of(occupied_.begin(), occupied_.end(), [&](const Rectangle& r) { return r.holds(pixel); });
}

bool Panel::ownsPointer() const {
    const Turn turn(context_);
    const ImVec2 at = ImGui::GetIO().MousePos;
    return ImGui::IsAnyItemActive() || help_ || saving_ || recording_ || start_ || occupies({at.x, at.y}) ||
           ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool Panel::ownsKeys() const {
    const Turn turn(context_);
    return ImGui::GetIO().WantTextInput || keyboard_ ||
           ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/// A press is told to Dear ImGui when the finger leaves again, for before that it may turn out to scroll.
bool Panel::touch(const TouchEvent& event) {
    const Turn turn(context_);
    const glm::dvec2 pixel = event.at * pixelsPerPoint_;
    if (event.phase == TouchPhase::began) {
        gliding_ = 0;
        if (!occupies(pixel)) return closeTop();
        if (finger_) return true;
        finger_ = Finger{event.finger, event.at, event.at, false, playBar_.holds(pixel)};
        if (finger_->holds) pressed_[0] = down_[0] = true;
    }
    if (!finger_ || finger_->id != event.finger) return false;
    if (finger_->holds) {
        ImGui::GetIO().MousePos = ImVec2(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
        restless_ = 3;
        down_[0] = event.phase == TouchPhase::began || event.phase == TouchPhase::moved;
        if (!down_[0]) finger_.reset();
        return true;
    }
    if (event.phase == TouchPhase::began) return true;
    finger_->scrolls |= glm::distance(event.at, finger_->start) > TouchGestures::kSlop;
    if (finger_->scrolls) scroll_ += static_cast<float>((finger_->at.y - event.at.y) * pixelsPerPoint_);
    finger_->at = event.at;
    restless_ = 3;
    if (event.phase == TouchPhase::moved) return true;
    if (event.phase == TouchPhase::ended && !finger_->scrolls) {
        ImGui::GetIO().MousePos = ImVec2(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
        pressed_[0] = true;
    }
    if (event.phase == TouchPhase::ended && finger_->scrolls) gliding_ = dragged_;
    finger_.reset();
    return true;
}

// --- a frame

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
    // A click that came and went between two frames is still a click.
    for (int i = 0; i < 3; ++i) {
        io.MouseDown[i] = down_[i] || pressed_[i];
        pressed_[i] = false;
    }
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
    drawReading(viewer, now);
    if (!viewer.failure().empty()) drawFailure(viewer);
    if (viewer.question()) drawQuestion(viewer, now);
    scroll_ = 0;
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

/// Keys that were pressed for one frame go up again.
void Panel::endKeys() {
#if IMGUI_VERSION_NUM < 18700
    ImGuiIO& io = ImGui::GetIO();
    for (const auto& [theirs, ours] : kLetters) io.KeysDown[indexOf(ours)] = false;
    if (pressedKey_) {
        io.KeysDown[indexOf(*pressedKey_)] = false;
        io.KeyShift = false;
    }
    io.KeyCtrl = false;
#endif
    pressedKey_.reset();
}

/// A list that a finger let go while it moved goes on for a while.
void Panel::glide(float passed) {
    if (finger_) {
        dragged_ = 0.6f * dragged_ + 0.4f * scroll_ / passed;
        return;
    }
    dragged_ = 0;
    if (gliding_ == 0) return;
    constexpr auto kSeconds = static_cast<float>(CameraMotion::kInertiaSeconds);
    scroll_ += gliding_ * passed;
    gliding_ *= std::exp(-passed / kSeconds);
    if (std::abs(gliding_) < kStillPoints * scale()) gliding_ = 0;
    restless_ = std::max(restless_, 2);
}

void Panel::remember() {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    occupied_.push_back({at.x, at.y, at.x + size.x, at.y + size.y});
}

/// The window that is being laid out scrolls with the finger.
void Panel::followFinger() {
    if (scroll_ == 0 || ImGui::GetScrollMaxY() <= 0) return;
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + scroll_, 0.0f, ImGui::GetScrollMaxY()));
    scroll_ = 0;
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
