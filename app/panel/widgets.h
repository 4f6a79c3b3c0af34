#pragma once
// Controls of the panel, each with a name: what is drawn is also told, for screen readers and for tests.

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

    /// A sign with a word. @param width  pixels; 0: as wide as it has to be; below 0: up to the right edge
    bool button(Icon icon, const char* label, float width = 0, bool primary = false, bool enabled = true);
    /// One of a word in a row of them, which goes on in the next line where it has no room. @param more  not the first
    bool word(const char* label, bool more = true, Icon icon = Icon::none) {
        if (more) wrapLine(buttonWidth(label) + (icon == Icon::none ? 0 : px(23)));
        return button(icon, label);
    }
    /// One line of a list: a sign and words from the left, shortened where they have no room. @param width  as button()
    bool row(Icon icon, const std::string& label, float width, bool faint = false);
    /// A sign above a word, in a toolbar or as a tab. @param value  told of it: "on", "selected"
    bool tool(Icon icon, const char* label, ImVec2 size, bool on = false, bool enabled = true,
              const char* role = "button");
    /// A sign alone, whose name is shown when the pointer rests on it.
    bool sign(Icon icon, const char* name, bool enabled = true);
    /// A heading that unfolds what follows. @returns whether it is open
    bool unfold(const char* label);
    bool toggle(const char* label, bool& on);
    /// One of several choices: a drop-down list for a mouse, one that unfolds in place for fingers.
    /// @returns whether another one was taken
    bool choose(const char* name, std::span<const char* const> choices, std::string& current, float width = -1);
    /// The same by its place: a number, or a value of an enumeration.
    template <typename Place>
    requires(!std::is_class_v<Place>) bool choose(const char* name, std::span<const char* const> choices,
                                                  Place& current, float width = -1) {
        std::string word = choices[static_cast<std::size_t>(current)];
        if (!choose(name, choices, word, width)) return false;
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (word == choices[i]) current = static_cast<Place>(i);
        return true;
    }
    /// A number (sliders.cpp). @param format  says it in words: "Fog %.2f", or, of a whole one, has no number
    bool slide(const char* name, float& value, float low, float high, const char* format, bool byRatio = false);
    bool slideWhole(const char* name, int& value, int low, int high, const char* format);
    /// A number that counts by its ratio. Its width is what ImGui::SetNextItemWidth() said.
    bool slideRate(const char* name, float& value, float low, float high, const char* format);
    /// A line of text, kMostTyped bytes at most. @returns as Dear ImGui's; edited() tells whether it was changed
    bool field(const char* name, const char* hint, std::string& text, float width = -1, int flags = 0);
    bool edited() const { return edited_; }
    /// There is something to type on.
    bool typable() const { return !fingers_ || askText; }
    /// Colours that are told apart, as fields in rows. @returns what was clicked
    std::optional<ImU32> swatches(std::optional<ImU32> chosen, std::size_t perLine);
    /// The same, and below them a field for any colour. @param name  of that
    std::optional<ImU32> pickColor(const char* name, std::optional<ImU32> chosen);
    /// A field of a colour that opens them. @param color  sRGB-coded  @param many  it shows that there are many
    /// @returns whether it is another one
    bool chooseColor(const char* name, std::array<float, 3>& color, float side = 0, bool many = false);
    /// Four squares of colours, over a swatch. @param corner  of it, upper left
    void showManyColors(ImVec2 corner, float side = 0) const;
    /// A field of colour. @returns whether it was clicked
    bool swatch(const char* name, ImU32 color, bool chosen, float side = 0);

    void heading(const char* words);
    /// @param right  where its lines end, from the window's left; 0: with the window
    void title(const std::string& words, float right = 0) { text(words, TextSize::heading, theme_->text, right); }
    void caption(const std::string& words) { text(words, TextSize::caption, theme_->faint); }
    void paragraph(const std::string& words) { text(words, TextSize::body, theme_->text); }
    void warning(const std::string& words) { text(words, TextSize::body, theme_->warning); }
    /// The folder that a file goes to, on desktops. @param path  of the file, as it was typed
    void folderOf(const char* path);
    /// A bar, and below it what it tells. @param share  0 to 1
    void progress(double share, const std::string& words);
    /// One line of text, shortened in its middle if it has no room.
    void name(const std::string& text, float width = 0);
    /// Goes on in the same line if something of a width has room there.
    void wrapLine(float width);
    float buttonWidth(const char* label) const;

    /// Tells of the item that was drawn last.
    void note(const char* role, const std::string& name, const std::string& value = {}, bool enabled = true);

    std::vector<Control> controls;  ///< of this frame so far
    std::string window;             ///< whose controls follow
    /// Who gets the keyboard's focus when it comes: its place in `controls`, and its name.
    std::optional<std::pair<std::size_t, std::string>> focusNext;
    /// For fingers: shows the system's keyboard for a field of a name and a text; `typed` is what came of it.
    std::function<void(const std::string& name, const std::string& text)> askText;
    std::optional<std::pair<std::string, std::string>> typed;

    /// About the item that was drawn last, where it is drawn by hand and keys have led to it.
    void ringFocus() const;
    /// What is shown when the pointer rests on that item.
    void explain(const std::string& text) const;

    /// A button that is drawn by hand.
    struct Pressed {
        bool pressed;
        ImVec2 low;  ///< its corner
        ImU32 ink;   ///< of what is drawn upon it
    };
    enum class Face { field, clear, accent };
    Pressed press(const char* id, const char* name, ImVec2 size, Face face = Face::field, bool enabled = true);
    /// Text on whole pixels.
    void write(ImVec2 at, ImU32 color, const std::string& text) const;

private:
    void text(const std::string& text, TextSize size, const ImVec4& color, float right = 0);
    template <typename Number, typename Slide>
    bool slider(const char* name, const Number& value, Number low, Number high, const char* format, bool byRatio,
                const char* told, Slide&& slide);
    bool drawSlider(float share, const std::string& format, double value) const;
    bool askedField(const char* name, const char* hint, std::string& text, float width);

    bool edited_ = false;   // the field that was drawn last
    std::string unfolded_;  // the one list that is open, for fingers
    const Theme* theme_;
    float scale_;
    bool fingers_;
};

/// A text, shortened in its middle to a width in pixels of the current font.
std::string shortened(const std::string& text, float width);

}  // namespace nacre::app
