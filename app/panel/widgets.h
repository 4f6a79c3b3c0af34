#pragma once
// Controls of the panel. Each has a name and is described for screen readers and tests.

#include <imgui.h>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "app/panel/controls.h"
#include "app/panel/fonts.h"
#include "app/panel/icons.h"
#include "app/panel/theme.h"

namespace nacre::app {

/// A button that answers a dialog.
struct Answer {
    const char* label;
    Icon icon = Icon::none;
    bool enabled = true;
};

class Widgets {
public:
    static constexpr std::size_t kMostTyped = 511;

    Widgets(const Theme& theme, float pixelsPerPoint, bool fingers)
        : theme_(&theme), scale_(pixelsPerPoint), fingers_(fingers) {}

    const Theme& theme() const { return *theme_; }
    void setTheme(const Theme& theme) { theme_ = &theme; }
    float px(float points) const { return points * scale_; }
    bool forFingers() const { return fingers_; }
    /// Height of a row of controls, pixels.
    float rowHeight() const { return ImGui::GetFrameHeight(); }

    /// An icon with a word. @param width  pixels; 0: fits its content; negative: up to the right edge
    bool button(Icon icon, const char* label, float width = 0, bool primary = false, bool enabled = true);
    /// A button in a grid of words, as wide as one column or several. @param more  not the first
    bool word(const char* label, bool more = true, Icon icon = Icon::none);
    /// The answers of a dialog, at its lower right as desktops have them. @param buttons  the emphasised one last
    /// @returns the pressed one
    std::optional<std::size_t> answers(std::span<const Answer> buttons);
    /// One line of a list: icon and text from the left, truncated if needed. @param width  as for button()
    /// @param shown  instead of the label, if not empty @param chosen  emphasised
    bool row(Icon icon, const std::string& label, float width, bool faint = false, const std::string& shown = {},
             bool chosen = false);
    /// An icon above a word, in a toolbar or as a tab. @param value  its state: "on", "selected"
    /// @param alone  the word is a tooltip
    bool tool(Icon icon, const char* label, ImVec2 size, bool on = false, bool enabled = true,
              const char* role = "button", bool alone = false);
    /// An icon with its name as a tooltip.
    bool sign(Icon icon, const char* name, bool enabled = true);
    /// A heading that expands the section below. @returns whether it is open
    bool unfold(const char* label);
    bool toggle(const char* label, bool& on);
    /// One of several choices: a drop-down list with a mouse, an expanding list with touch.
    /// @returns whether the choice changed
    bool choose(const char* name, std::span<const char* const> choices, std::string& current, float width = -1);
    /// As above by index: a number, or a value of an enumeration.
    template <typename Place>
    requires(!std::is_class_v<Place>) bool choose(const char* name, std::span<const char* const> choices,
                                                  Place& current, float width = -1) {
        std::string word = choices[static_cast<std::size_t>(current)];
        if (!choose(name, choices, word, width)) return false;
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (word == choices[i]) current = static_cast<Place>(i);
        return true;
    }
    /// A number (sliders.cpp). @param format  its text: "Fog %.2f", or, for an integer, text without a number
    bool slide(const char* name, float& value, float low, float high, const char* format, bool byRatio = false);
    bool slideWhole(const char* name, int& value, int low, int high, const char* format);
    /// A number on a logarithmic scale. Its width is that of ImGui::SetNextItemWidth().
    bool slideRate(const char* name, float& value, float low, float high, const char* format);
    /// A line of text, kMostTyped bytes at most. @returns as Dear ImGui; edited() tells whether it changed
    bool field(const char* name, const char* hint, std::string& text, float width = -1, int flags = 0);
    bool edited() const { return edited_; }
    /// Whether a keyboard is available.
    bool typable() const { return !fingers_ || askText; }
    /// Distinguishable colours as swatches in rows. @returns the one clicked
    std::optional<ImU32> swatches(std::optional<ImU32> chosen, std::size_t perLine);
    /// As above, with a field for any colour below. @param name  of the field
    std::optional<ImU32> pickColor(const char* name, std::optional<ImU32> chosen);
    /// A swatch that opens the swatches. @param color  sRGB-coded  @param many  shows that there are several colours
    /// @returns whether the colour changed
    bool chooseColor(const char* name, std::array<float, 3>& color, float side = 0, bool many = false);
    /// Four squares of colours over a swatch. @param corner  upper left
    void showManyColors(ImVec2 corner, float side = 0) const;
    /// A swatch. @returns whether it was clicked
    bool swatch(const char* name, ImU32 color, bool chosen, float side = 0);

    void heading(const char* words);
    /// @param right  right end of its lines, from the window's left; 0: the window's
    void title(const std::string& words, float right = 0) { text(words, TextSize::heading, theme_->text, right); }
    void caption(const std::string& words) { text(words, TextSize::caption, theme_->faint); }
    void paragraph(const std::string& words) { text(words, TextSize::body, theme_->text); }
    void warning(const std::string& words) { text(words, TextSize::body, theme_->warning); }
    /// Shows the folder of a file, on desktops. @param path  as typed
    void openFolder(const char* path);
    /// A progress bar with text below. @param share  0 to 1
    void progress(double share, const std::string& words);
    /// One line of text, shortened in its middle if needed.
    void name(const std::string& text, float width = 0);
    /// Continues on the same line if this width fits there.
    void wrapLine(float width);
    float buttonWidth(const char* label) const;

    /// Describes the last item.
    void note(const char* role, const std::string& name, const std::string& value = {}, bool enabled = true);

    std::vector<Control> controls;  ///< of this frame so far
    std::string window;             ///< window of the following controls
    /// The control that receives the keyboard focus when drawn: its index in `controls`, and its name.
    std::optional<std::pair<std::size_t, std::string>> focusNext;
    /// For touch: shows the system's keyboard for a field's name and text; `typed` is the result.
    std::function<void(const std::string& name, const std::string& text)> askText;
    std::optional<std::pair<std::string, std::string>> typed;

    /// Gives the keyboard focus to the last item.
    static void focusLast();
    /// Draws a focus ring around the last item, if it is custom-drawn and focused by keys.
    void ringFocus() const;
    /// Tooltip of the last item.
    void explain(const std::string& text) const;

    /// A custom-drawn button.
    struct Pressed {
        bool pressed;
        ImVec2 low;  ///< its corner
        ImU32 ink;   ///< of its contents
    };
    enum class Face { field, clear, accent };
    Pressed press(const char* id, const char* name, ImVec2 size, Face face = Face::field, bool enabled = true);
    /// Text aligned to whole pixels.
    void write(ImVec2 at, ImU32 color, const std::string& text) const;

private:
    struct SliderText;
    void text(const std::string& text, TextSize size, const ImVec4& color, float right = 0);
    template <typename Number, typename Slide>
    bool slider(const char* name, const Number& value, Number low, Number high, const SliderText* text, bool byRatio,
                const char* told, Slide&& slide);
    void drawTrack(float share, bool below) const;
    bool drawSliderText(const SliderText& text) const;
    bool askedField(const char* name, const char* hint, std::string& text, float width);

    bool edited_ = false;   // of the last field
    std::string unfolded_;  // the only open list, for touch
    const Theme* theme_;
    float scale_;
    bool fingers_;
};

enum class Cut { middle, end };
/// A text, shortened to a width in pixels of the current font.
std::string shortened(const std::string& text, float width, Cut cut = Cut::middle);

}  // namespace nacre::app
