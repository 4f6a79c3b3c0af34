// The start screen: open a file, recent files, samples, and databases.

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kStartPoints = 640, kRecentPoints = 138, kPicturePoints = 92;

/// A picture as a mesh: a vertex in the middle of each pixel, with interpolated colours. Crops a picture that is wider
/// than its place.
void drawPicture(ImDrawList& list, const RecentFile& recent, ImVec2 low, ImVec2 high) {
    if (recent.width < 2 || recent.height < 2 || recent.pixels.size() != std::size_t{recent.width} * recent.height)
        return;
    const float shape = (high.x - low.x) / (high.y - low.y);
    const std::uint32_t h = recent.height;
    const std::uint32_t w = std::clamp(static_cast<std::uint32_t>(shape * static_cast<float>(h)), 2u, recent.width);
    const std::uint32_t* pixels = recent.pixels.data() + (recent.width - w) / 2;
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    // The outermost vertices are on the border: half a pixel is cut there.
    const auto along = [](float from, float to, std::uint32_t i, std::uint32_t count) {
        const float middle = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        return i == 0 ? from : i + 1 == count ? to : from + (to - from) * middle;
    };
    const auto toScreen = [&](std::uint32_t x, std::uint32_t y) {
        return ImVec2(along(low.x, high.x, x, w), along(low.y, high.y, y, h));
    };
    const std::uint32_t most = 0xffff / w;  // rows of vertices that fit 16-bit indices
    for (std::uint32_t top = 0; top + 1 < h; top += most - 1) {
        const std::uint32_t rows = std::min(most, h - top);
        list.PrimReserve(static_cast<int>((w - 1) * (rows - 1) * 6), static_cast<int>(w * rows));
        const unsigned first = list._VtxCurrentIdx;
        for (std::uint32_t y = top; y < top + rows; ++y)
            for (std::uint32_t x = 0; x < w; ++x)
                list.PrimWriteVtx(toScreen(x, y), white, pixels[std::size_t{y} * recent.width + x]);
        for (std::uint32_t y = 0; y + 1 < rows; ++y)
            for (std::uint32_t x = 0; x + 1 < w; ++x) {
                const unsigned at = first + y * w + x;
                for (const unsigned i : {at, at + 1, at + w, at + 1, at + w + 1, at + w})
                    list.PrimWriteIdx(static_cast<ImDrawIdx>(i));
            }
    }
}

/// Buttons side by side, each of which opens an input.
void offer(PanelFrame& f, std::span<const std::pair<const char*, const char*>> inputs) {
    for (const auto& each : inputs)
        if (f.ui.word(each.first, &each != inputs.data())) openInput(f, each.second);
}

/// The first sample, across the card.
void drawBanner(PanelFrame& f, const RecentFile& sample) {
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 size(width, std::round(width * static_cast<float>(sample.height) / static_cast<float>(sample.width)));
    const auto [pressed, low, ink] = f.ui.press("##banner", sample.input.c_str(), size);
    f.ui.note("button", "Open " + sample.name, sample.input);
    f.ui.explain("Open " + sample.name);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float in = f.ui.px(3);
    const ImVec2 from(std::round(low.x + in), std::round(low.y + in));
    const ImVec2 to(std::round(low.x + size.x - in), std::round(low.y + size.y - in));
    list.AddRectFilled(from, to, IM_COL32(255, 255, 255, 255), f.ui.px(4));
    drawPicture(list, sample, from, to);
    if (pressed) openInput(f, sample.input);
}

/// A card with a picture and a name below it. @param said  for screen readers
void drawRecent(PanelFrame& f, const RecentFile& recent, float width, const std::string& said) {
    const float picture = f.ui.px(kPicturePoints), height = picture + f.ui.px(26);
    const auto [pressed, low, ink] = f.ui.press("##recent", recent.input.c_str(), ImVec2(width, height));
    f.ui.note("button", said, recent.input);
    f.ui.explain(recent.input);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float in = f.ui.px(4);
    const ImVec2 from(std::round(low.x + in), std::round(low.y + in));
    const ImVec2 to(std::round(low.x + width - in), std::round(low.y + picture));
    list.AddRectFilled(from, to, IM_COL32(255, 255, 255, 255), f.ui.px(4));
    drawPicture(list, recent, from, to);
    ImGui::PushFont(findFont(TextSize::caption));
    const std::string shown = shortened(visualText(recent.name), width - 2 * f.ui.px(6));
    f.ui.write(ImVec2(low.x + f.ui.px(7), low.y + picture + f.ui.px(5)), ink, shown);
    ImGui::PopFont();
    if (pressed) openInput(f, recent.input);
}

/// A field for an identifier or a path.
void drawInput(PanelFrame& f) {
    f.ui.heading(f.ui.forFingers() ? "From a database" : f.host.downloads ? "Database ID or file path" : "File path");
    const float go = f.ui.buttonWidth("Open") + f.ui.px(2);
    const float beside = ImGui::GetContentRegionAvail().x - go - ImGui::GetStyle().ItemSpacing.x;
    const bool narrow = beside < f.ui.px(170);  // the button is below the field
    const char* hint = !f.host.downloads ? "/home/me/1bna.pdb"
                       : narrow          ? "pdb:1BNA"
                                         : "pdb:1BNA, pubchem:aspirin, afdb:P69905";
    focusField(f);
    const bool entered =
        f.ui.field("ID or path", hint, f.s.input, narrow ? -1 : beside, ImGuiInputTextFlags_EnterReturnsTrue);
    if (!narrow) ImGui::SameLine();
    if (f.ui.button(Icon::none, "Open", go) || entered) openInput(f, f.s.input);
    constexpr std::pair<const char*, const char*> kExamples[] = {
        {"Haemoglobin", "pdb:4HHB"}, {"Aspirin", "pubchem:aspirin"}, {"Predicted haemoglobin", "afdb:P69905"}};
    if (f.host.downloads) offer(f, kExamples);
}

}  // namespace

void openInput(PanelFrame& f, const std::string& input) {
    if (input.empty()) return;
    const bool beside = std::exchange(f.s.start, false) && f.s.together;
    f.host.open ? f.host.open({input}, beside) : f.viewer.open({input}, beside, f.now);
}

void drawStart(PanelFrame& f) {
    const bool empty = !f.viewer.document();
    if (beginCard(f, "Start", empty ? "Nacre" : "Open", kStartPoints, !empty)) f.s.start = false;
    const std::span<const RecentFile> samples =
        f.host.samples ? std::span(f.host.samples()) : std::span<const RecentFile>();
    const bool drawn =
        !samples.empty() && std::ranges::all_of(samples, [](const RecentFile& sample) { return sample.width > 0; });
    if (empty && drawn) drawBanner(f, samples.front());
    f.ui.caption("Molecules, from files and databases");
    if (!f.s.foreign.missing().empty()) f.ui.caption(f.s.foreign.missing());
    ImGui::Spacing();
    if (!f.viewer.messages().failure().empty()) {
        tellFailure(f);
        ImGui::Spacing();
    }
    if (empty) f.s.together = false;
    if (f.host.open && !empty) f.ui.toggle("Add to current scene", f.s.together);
    const bool dialog = f.host.openDialog || f.host.browses;
    if (dialog && f.ui.button(Icon::open, "Open a file ...", 0, true))
        f.host.browses ? f.s.browse("Open a file", "", nullptr, "Open") : f.host.openDialog();
    if (f.host.goOn && empty) {
        const std::string words = "Continue with " + f.host.lastView;
        const float wide = f.ui.buttonWidth(words.c_str()) + f.ui.px(23);
        if (dialog) f.ui.wrapLine(wide);
        const bool fits = ImGui::GetContentRegionAvail().x >= wide;
        if (f.ui.button(Icon::play, words.c_str(), fits ? 0 : -1, !dialog)) f.host.goOn();
        f.ui.controls.back().cut = false;  // long names are always shortened
    }
    if (!f.ui.forFingers()) f.ui.caption(dialog ? "Or drop a file on this window." : "Drop a file on this window.");
    if (!f.ui.forFingers() || (f.host.downloads && f.ui.typable())) drawInput(f);
    const auto show = [&](const char* heading, std::span<const RecentFile> files, const std::string& before) {
        if (files.empty()) return;
        f.ui.heading(heading);
        const float width = f.ui.px(kRecentPoints);
        bool more = false;
        for (const RecentFile& file : files) {
            if (std::exchange(more, true)) f.ui.wrapLine(width);
            drawRecent(f, file, width, before + file.name);
        }
    };
    if (f.host.recent) show("Recent files", f.host.recent(), "Open ");
    if (drawn) {
        show("Samples", samples, "");
    } else {
        f.ui.heading("Samples");
        offer(f, kSampleNames);
    }
    if (empty) {
        ImGui::Spacing();
        if (f.ui.button(Icon::help, "Help")) f.s.help = true;
    }
    endGrown(f);
}

}  // namespace nacre::app
