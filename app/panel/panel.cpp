// The panel's events, and a frame of it from end to end. What stands in it is in panel_content.cpp.

#include "app/panel/panel.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>

#include "app/panel/panel_style.h"

namespace nacre::app {
namespace {

constexpr std::pair<ImGuiKey, SpecialKey> kKeys[] = {
    {ImGuiKey_LeftArrow, SpecialKey::left},     {ImGuiKey_RightArrow, SpecialKey::right},
    {ImGuiKey_UpArrow, SpecialKey::up},         {ImGuiKey_DownArrow, SpecialKey::down},
    {ImGuiKey_Home, SpecialKey::home},          {ImGuiKey_Escape, SpecialKey::escape},
    {ImGuiKey_Backspace, SpecialKey::backspace}};

std::recursive_mutex turns;

}  // namespace

/// Dear ImGui works on one context, named by a global variable: panels on other threads wait for their turn.
class Panel::Turn {
public:
    explicit Turn(ImGuiContext* context) : lock_(turns) { ImGui::SetCurrentContext(context); }

private:
    std::lock_guard<std::recursive_mutex> lock_;
};

Panel::Panel(double pixelsPerPoint, std::function<void(ViewerCommand)> run, PanelHand hand)
    : run_(std::move(run)), hand_(hand), pixelsPerPoint_(pixelsPerPoint), open_(hand == PanelHand::mouse) {
    const std::lock_guard lock(turns);
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    addPanelFont(scale());
    setPanelStyle(scale(), forFingers());
#if IMGUI_VERSION_NUM < 18700
    for (const auto& [theirs, ours] : kKeys) io.KeyMap[theirs] = static_cast<int>(keyOf(ours) - 0x110000);
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
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&coverage, &width, &height);
    return {static_cast<std::uint32_t>(width),
            static_cast<std::uint32_t>(height),
            {coverage, coverage + std::ptrdiff_t{width} * height}};
}

// --- events

void Panel::pointer(glm::dvec2 at) {
    const Turn turn(context_);
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
    const Turn turn(context_);
    ImGui::GetIO().MouseWheel += static_cast<float>(steps);
    restless_ = 3;
}

void Panel::character(char32_t c) {
    const Turn turn(context_);
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
    restless_ = 3;
}

void Panel::key(SpecialKey key, bool down) {
    const Turn turn(context_);
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeysDown[keyOf(key) - 0x110000] = down;
#else
    for (const auto& [theirs, ours] : kKeys)
        if (ours == key) ImGui::GetIO().AddKeyEvent(theirs, down);
#endif
    restless_ = 3;
}

bool Panel::occupies(glm::dvec2 pixel) const {
    return std::any_of(occupied_.begin(), occupied_.end(), [&](const Rectangle& r) {
        return pixel.x >= r.left && pixel.x < r.right && pixel.y >= r.top && pixel.y < r.bottom;
    });
}

bool Panel::ownsPointer() const {
    const Turn turn(context_);
    const ImVec2 at = ImGui::GetIO().MousePos;
    return ImGui::IsAnyItemActive() || occupies({at.x, at.y});
}

bool Panel::ownsKeys() const {
    const Turn turn(context_);
    return ImGui::GetIO().WantTextInput;
}

/// A press is told to Dear ImGui when the finger leaves again, for before that it may turn out to scroll.
bool Panel::touch(const TouchEvent& event) {
    const Turn turn(context_);
    const glm::dvec2 pixel = event.at * pixelsPerPoint_;
    if (event.phase == TouchPhase::began) {
        if (!occupies(pixel)) return false;
        if (!finger_) finger_ = Finger{event.finger, event.at, event.at, false};
        return true;
    }
    if (!finger_ || finger_->id != event.finger) return false;
    finger_->scrolls |= glm::distance(event.at, finger_->start) > TouchGestures::kSlop;
    if (finger_->scrolls) scroll_ += static_cast<float>((finger_->at.y - event.at.y) * pixelsPerPoint_);
    finger_->at = event.at;
    restless_ = 3;
    if (event.phase == TouchPhase::moved) return true;
    if (event.phase == TouchPhase::ended && !finger_->scrolls) {
        ImGui::GetIO().MousePos = ImVec2(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
        pressed_[0] = true;
    }
    finger_.reset();
    return true;
}

// --- a frame

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
    if (forFingers() && restless_ == 0) io.MousePos = ImVec2(-FLT_MAX, -FLT_MAX);  // the finger is gone
    ImGui::NewFrame();
    occupied_.clear();
    // A phone has no room for panel and help at once.
    if (open_ && !(help_ && forFingers())) drawPanel(viewer, now);
    if (!open_ && !help_ && forFingers()) drawMenuButton();
    if (help_) drawHelp();
    if (viewer.question()) drawQuestion(viewer, now);
    scroll_ = 0;
    drawWords(viewer);
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

/// The window that is being laid out scrolls with the finger.
void Panel::followFinger() {
    if (scroll_ == 0) return;
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
