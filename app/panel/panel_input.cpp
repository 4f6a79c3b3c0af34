#include "app/panel/panel_input.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kStillPoints = 20;  // points per second: a slower list stops gliding

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

bool popupOpen() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }

#if IMGUI_VERSION_NUM < 18700
int indexOf(SpecialKey key) { return static_cast<int>(toKey(key) - 0x110000); }
int indexOf(char32_t letter) { return 256 + static_cast<int>(letter & 0x7f); }
#endif

}  // namespace

PanelInput::PanelInput(ImGuiContext* context, PanelState& state) : context_(context), s_(state) {
#if IMGUI_VERSION_NUM < 18700
    // Index of each key for Dear ImGui.
    ImGuiIO& io = ImGui::GetIO();
    for (const auto& [theirs, ours] : kKeys) io.KeyMap[theirs] = indexOf(ours);
    for (const auto& [theirs, ours] : kLetters) io.KeyMap[theirs] = indexOf(ours);
#endif
}

/// Announces an event that a frame must show before the next event is handled.
void PanelInput::await(bool focusMoves) {
    focusMoves_ = focusMoves || (focusMoves_ && frames_ < 2);
    frames_ = 0;
    s_.restless = 3;
}

void PanelInput::pointer(glm::dvec2 at) {
    const Turn turn(context_);
    const bool was = ownsPointer();
    ImGui::GetIO().MousePos = ImVec2(static_cast<float>(at.x), static_cast<float>(at.y));
    if (was || ownsPointer()) s_.restless = 2;
}

void PanelInput::button(MouseButton button, bool down) {
    const Turn turn(context_);
    const auto i = static_cast<std::size_t>(button == MouseButton::left ? 0 : button == MouseButton::right ? 1 : 2);
    down_[i] = down;
    if (down) pressed_[i] = true;
    if (down) s_.opening = 0;  // the pressed control has the focus
    const ImVec2 at = ImGui::GetIO().MousePos;
    const bool popup = popupOpen();
    if (down && !popup && !s_.occupies({at.x, at.y})) s_.closeTop();  // a click outside
    s_.keyboard = false;
    await(true);
}

void PanelInput::wheel(double steps) {
    const Turn turn(context_);
    ImGui::GetIO().MouseWheel += static_cast<float>(steps);
    s_.restless = 3;
}

void PanelInput::character(char32_t c) {
    const Turn turn(context_);
    ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) io.AddInputCharacter(static_cast<unsigned>(c));
#if IMGUI_VERSION_NUM < 18700
    if (c == U' ' && !io.WantTextInput) shortcut(U' ');  // presses the focused control
#endif
    s_.restless = 3;
}

void PanelInput::typed(const std::string& name, const std::string& text) {
    s_.ui.typed = {name, text};
    s_.restless = 3;
}

bool PanelInput::shortcut(char32_t letter) {
    const Turn turn(context_);
    const auto known = std::ranges::find_if(kLetters, [&](const auto& of) { return of.second == letter; });
    if (known == std::end(kLetters)) return false;
#if IMGUI_VERSION_NUM < 18700
    ImGuiIO& io = ImGui::GetIO();
    io.KeysDown[indexOf(letter)] = true;  // until the next frame is drawn
    io.KeyCtrl = letter != U' ';
#endif
    await(true);
    return true;
}

void PanelInput::hold(SpecialKey key, bool down) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeysDown[indexOf(key)] = down;
#else
    for (const auto& [theirs, ours] : kKeys)
        if (ours == key) ImGui::GetIO().AddKeyEvent(theirs, down);
#endif
}

void PanelInput::key(SpecialKey key, bool down, Modifiers with) {
    const Turn turn(context_);
    ImGuiIO& io = ImGui::GetIO();
    const bool popup = popupOpen();
    const bool held = down ? !held_.insert(key).second : held_.erase(key) != 0;
    if (!down && !held) return;  // the key was pressed elsewhere
    await(key == SpecialKey::tab || key == SpecialKey::enter || key == SpecialKey::escape);
    if (key == SpecialKey::tab && !popup) {
        // Focuses the panel, then its next control. A card keeps the focus.
        const auto next = down ? nextStop(s_.ui.controls, with.shift, s_.topCard()) : std::nullopt;
        if (!next) return;
        s_.keyboard = true;
        s_.ui.focusNext = {*next, s_.ui.controls[*next].name};
        return;
    }
    if (s_.palette.open && (key == SpecialKey::up || key == SpecialKey::down)) {
        if (down) s_.palette.chosen += key == SpecialKey::up ? -1 : 1;
        return;
    }
    if (key == SpecialKey::escape && down && !popup && !io.WantTextInput) s_.keyboard = false;
    if (s_.sequence.focused && s_.keyboard && (key == SpecialKey::left || key == SpecialKey::right)) {
        if (down) s_.sequence.step = key == SpecialKey::left ? -1 : 1;
        s_.sequence.extends = with.shift;
        return;
    }
#if IMGUI_VERSION_NUM < 18700
    // Before Dear ImGui 1.87, Enter activates fields and sliders only, and Space presses.
    if (key == SpecialKey::enter && !io.WantTextInput) {
        const auto focus = std::ranges::find_if(s_.ui.controls, [](const Control& c) { return c.focused; });
        const bool typing = focus != s_.ui.controls.end() && (focus->role == "field" || focus->role == "slider");
        if (!typing && down) {
            shortcut(U' ');
            return;
        }
    }
    io.KeyShift = with.shift;
    io.KeyCtrl = with.control;
#endif
    // A repeated key is released in between.
    if (down && held) again_ = key;
    hold(key, down && !held);
}

/// Whether Escape closes a dialog, and not an open list in it.
bool PanelInput::escapes() const {
    const Turn turn(context_);
    return s_.over() && !popupOpen();
}

std::optional<ViewerCommand> PanelInput::press(SpecialKey special, bool down, Modifiers with) {
    const bool owned = ownsKeys(), leaves = special == SpecialKey::escape && escapes();
    if (!leaves && (owned || !down || special == SpecialKey::tab)) key(special, down, with);
    if (!down || (owned && !leaves)) return std::nullopt;
    return findCommand({toKey(special), with});
}

std::optional<ViewerCommand> PanelInput::type(char32_t c) {
    if (ownsKeys()) return character(c), std::nullopt;
    const bool capital = c >= U'A' && c <= U'Z';
    return findCommand({capital ? c - U'A' + U'a' : c, {capital, false}});
}

std::optional<ViewerCommand> PanelInput::press(const KeyEvent& event) {
    if (ownsKeys() && shortcut(event.key)) return std::nullopt;
    const std::optional<ViewerCommand> command = findCommand(event);
    return s_.over() && command != ViewerCommand::quit ? std::nullopt : command;
}

bool PanelInput::ownsPointer() const {
    const Turn turn(context_);
    const ImVec2 at = ImGui::GetIO().MousePos;
    return ImGui::IsAnyItemActive() || s_.over() || s_.occupies({at.x, at.y}) || popupOpen();
}

bool PanelInput::ownsKeys() const {
    const Turn turn(context_);
    return ImGui::GetIO().WantTextInput || s_.keyboard || popupOpen() || s_.over();
}

bool PanelInput::answered(bool focus) const { return s_.opening == 0 && frames_ >= (focus && focusMoves_ ? 2 : 1); }

bool PanelInput::touch(const TouchEvent& event) {
    const Turn turn(context_);
    const glm::dvec2 pixel = event.at * s_.pixelsPerPoint;
    if (event.phase == TouchPhase::began) {
        gliding_ = 0;
        if (!s_.occupies(pixel)) return s_.closeTop();
        if (finger_) return true;
        finger_ = Finger{event.finger, event.at, event.at, false, s_.playBar.holds(pixel)};
        if (finger_->holds) pressed_[0] = down_[0] = true;
    }
    if (!finger_ || finger_->id != event.finger) return false;
    if (finger_->holds) {
        ImGui::GetIO().MousePos = ImVec2(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
        s_.restless = 3;
        down_[0] = event.phase == TouchPhase::began || event.phase == TouchPhase::moved;
        if (!down_[0]) finger_.reset();
        return true;
    }
    if (event.phase == TouchPhase::began) return true;
    finger_->scrolls |= glm::distance(event.at, finger_->start) > TouchGestures::kSlop;
    if (finger_->scrolls) s_.scroll += static_cast<float>((finger_->at.y - event.at.y) * s_.pixelsPerPoint);
    finger_->at = event.at;
    s_.restless = 3;
    if (event.phase == TouchPhase::moved) return true;
    if (event.phase == TouchPhase::ended && !finger_->scrolls) taps_.push_back(pixel);
    if (event.phase == TouchPhase::ended && finger_->scrolls) gliding_ = dragged_;
    finger_.reset();
    return true;
}

/// A press and release between two frames still count as a click. A tap is pressed in one frame and released in the
/// next, at the same place; a further tap waits.
void PanelInput::pressButtons() {
    ImGuiIO& io = ImGui::GetIO();
    for (std::size_t i = 0; i < std::size(down_); ++i) {
        io.MouseDown[i] = down_[i] || pressed_[i];
        pressed_[i] = false;
    }
    const auto moveTo = [&](const glm::dvec2& at) {
        io.MousePos = ImVec2(static_cast<float>(at.x), static_cast<float>(at.y));
    };
    if (tap_) {
        moveTo(*tap_);
        tap_.reset();
    } else if (!taps_.empty() && !io.MouseDown[0]) {
        tap_ = taps_.front();
        taps_.pop_front();
        moveTo(*tap_);
        io.MouseDown[0] = true;
    }
    if (tap_ || !taps_.empty()) s_.restless = std::max(s_.restless, 3);
}

void PanelInput::beginFrame(float seconds) {
    pressButtons();
    if (s_.restless > 0) --s_.restless;
    // The finger was lifted.
    if (s_.ui.forFingers() && s_.restless == 0 && !finger_) ImGui::GetIO().MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
    glide(seconds);
}

/// Releases keys that were pressed for one frame.
void PanelInput::endFrame() {
    frames_ = std::min(frames_ + 1, 2);
#if IMGUI_VERSION_NUM < 18700
    ImGuiIO& io = ImGui::GetIO();
    for (const auto& [theirs, ours] : kLetters) io.KeysDown[indexOf(ours)] = false;
    io.KeyCtrl = false;
#endif
    if (!again_) return;
    hold(*std::exchange(again_, std::nullopt), true);
    await(false);
}

/// A list released while moving continues to glide.
void PanelInput::glide(float seconds) {
    if (finger_) {
        dragged_ = 0.6f * dragged_ + 0.4f * s_.scroll / seconds;
        return;
    }
    dragged_ = 0;
    if (gliding_ == 0) return;
    constexpr auto kSeconds = static_cast<float>(CameraMotion::kInertiaSeconds);
    s_.scroll += gliding_ * seconds;
    gliding_ *= std::exp(-seconds / kSeconds);
    if (std::abs(gliding_) < s_.ui.px(kStillPoints)) gliding_ = 0;
    s_.restless = std::max(s_.restless, 2);
}

}  // namespace nacre::app
