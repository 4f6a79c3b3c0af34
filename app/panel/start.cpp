// What an empty window offers: a file, what was open before, samples, and what databases have.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kStartPoints = 640, kRecentPoints = 138, kPicturePoints = 92;

constexpr std::pair<const char*, const char*> kSamples[] = {
    {"DNA", "sample:dna"}, {"Glucose", "sample:glucose"}, {"Buckyball", "sample:buckyball"}};

/// A picture as a mesh: a vertex a pixel, colours between them.
void drawPicture(ImDrawList& list, const RecentFile& recent, ImVec2 low, ImVec2 high) {
    const std::uint32_t w = recent.width, h = recent.height;
    if (w < 2 || h < 2 || recent.pixels.size() != std::size_t{w} * h) return;
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    list.PrimReserve(static_cast<int>((w - 1) * (h - 1) * 6), static_cast<int>(w * h));
    const unsigned first = list._VtxCurrentIdx;
    for (std::uint32_t y = 0; y < h; ++y)
        for (std::uint32_t x = 0; x < w; ++x)
            list.PrimWriteVtx(ImVec2(low.x + (high.x - low.x) * static_cast<float>(x) / static_cast<float>(w - 1),
                                     low.y + (high.y - low.y) * static_cast<float>(y) / static_cast<float>(h - 1)),
                              white, recent.pixels[std::size_t{y} * w + x]);
    for (std::uint32_t y = 0; y + 1 < h; ++y)
        for (std::uint32_t x = 0; x + 1 < w; ++x) {
            const unsigned at = first + y * w + x;
            for (const unsigned i : {at, at + 1, at + w, at + 1, at + w + 1, at + w})
                list.PrimWriteIdx(static_cast<ImDrawIdx>(i));
        }
}

}  // namespace

bool Panel::opensTogether() const { return start_ && state_->together; }

void Panel::openInput(const std::string& input, Viewer& viewer, double now) {
    if (input.empty()) return;
    const bool together = opensTogether();
    start_ = false;
    if (together)
        host_.add(input);
    else if (host_.open)
        host_.open(input);
    else
        viewer.open(input, now);
}

void Panel::drawStart(Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    const bool empty = !viewer.document();
    if (beginCard("Start", empty ? "Nacre" : "Open", kStartPoints, !empty)) start_ = false;
    ui.caption("Molecules, from files and databases");
    ImGui::Spacing();
    if (!viewer.failure().empty()) {
        tellFailure(viewer);
        ImGui::Spacing();
    }
    if (empty) state_->together = false;
    if (host_.add && !empty) ui.toggle("Beside what is open", state_->together);
    if (host_.openDialog && ui.button(Icon::open, "Open a file ...", 0, true)) host_.openDialog();
    if (host_.goOn && empty) {
        const std::string words = "Go on with " + host_.lastView;
        const float wide = ui.buttonWidth(words.c_str()) + ui.px(23);
        if (host_.openDialog) ui.wrapLine(wide);
        const bool fits = ImGui::GetContentRegionAvail().x >= wide;
        if (ui.button(Icon::play, words.c_str(), fits ? 0 : -1, !host_.openDialog)) host_.goOn();
        ui.controls.back().cut = false;  // a long name is shortened, as everywhere
    }
    if (!forFingers()) ui.caption(host_.openDialog ? "Or drop a file on this window." : "Drop a file on this window.");
    if (!forFingers() || (host_.downloads && ui.typable())) {
        ui.heading(forFingers()      ? "From a database"
                   : host_.downloads ? "From a database, or by its path"
                                     : "By its path");
        const float go = ui.buttonWidth("Get it") + ui.px(2);
        const float beside = ImGui::GetContentRegionAvail().x - go - ImGui::GetStyle().ItemSpacing.x;
        const bool narrow = beside < ui.px(170);  // the button stands below the field
        const char* hint = !host_.downloads ? "/home/me/1bna.pdb"
                           : narrow         ? "pdb:1BNA"
                                            : "pdb:1BNA, pubchem:aspirin, afdb:P69905";
        const bool entered = ui.field("Identifier or path", hint, state_->input, sizeof state_->input,
                                      narrow ? -1 : beside, ImGuiInputTextFlags_EnterReturnsTrue);
        if (!narrow) ImGui::SameLine();
        if (ui.button(Icon::none, "Get it", go) || entered) openInput(state_->input, viewer, now);
        if (host_.downloads) {
            constexpr std::pair<const char*, const char*> kExamples[] = {
                {"Haemoglobin", "pdb:4HHB"}, {"Aspirin", "pubchem:aspirin"}, {"Predicted haemoglobin", "afdb:P69905"}};
            std::size_t placed = 0;
            for (const auto& [name, input] : kExamples) {
                if (placed++ > 0) ui.wrapLine(ui.buttonWidth(name));
                if (ui.button(Icon::none, name)) openInput(input, viewer, now);
            }
        }
    }
    if (host_.recent && !host_.recent().empty()) {
        ui.heading("Open before");
        const float width = ui.px(kRecentPoints);
        bool first = true;
        for (const RecentFile& recent : host_.recent()) {
            if (!first) ui.wrapLine(width);
            first = false;
            drawRecent(recent, width, viewer, now);
        }
    }
    ui.heading("Samples");
    bool first = true;
    for (const auto& [name, input] : kSamples) {
        if (!first) ui.wrapLine(ui.buttonWidth(name));
        first = false;
        if (ui.button(Icon::none, name)) openInput(input, viewer, now);
    }
    if (empty) {
        ImGui::Spacing();
        if (ui.button(Icon::help, "Help")) help_ = true;
    }
    endCard();
}

/// A card with a picture and a name below it.
void Panel::drawRecent(const RecentFile& recent, float width, Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    const float picture = ui.px(kPicturePoints), height = picture + ui.px(26);
    ImGui::PushID(recent.input.c_str());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::Button("##recent", ImVec2(width, height));
    ui.note("button", "Open " + recent.name, recent.input);
    if (!forFingers() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", recent.input.c_str());
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float in = ui.px(4);
    const ImVec2 from(low.x + in, low.y + in), to(low.x + width - in, low.y + picture);
    list.AddRectFilled(from, to, IM_COL32(255, 255, 255, 255), ui.px(4));
    drawPicture(list, recent, from, to);
    ImGui::PushFont(fontOf(TextSize::caption));
    const std::string shown = shortened(visualText(recent.name), width - 2 * ui.px(6));
    list.AddText(ImVec2(std::round(low.x + ui.px(7)), std::round(low.y + picture + ui.px(5))),
                 ImGui::GetColorU32(ui.theme().text), shown.c_str());
    ImGui::PopFont();
    if (pressed) openInput(recent.input, viewer, now);
}

}  // namespace nacre::app
