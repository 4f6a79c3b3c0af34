// Marks on picked atoms, and the lines of text at the bottom.

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "app/annotation/layout.h"
#include "app/drawing/stereo.h"
#include "app/panel/panel_state.h"
#include "engine/srgb.h"

namespace nacre::app {

namespace {

constexpr std::array kEyesOfOverlays{OverlayEye::both, OverlayEye::left, OverlayEye::right};

/// Marks a change of eye between commands; Dear ImGui never calls this, since we draw its lists.
void changesEye(const ImDrawList*, const ImDrawCmd*) {}

/// Draws the following marks for one eye, beneath the panel.
void drawFor(OverlayEye eye) {
    ImGui::GetBackgroundDrawList()->AddCallback(
        changesEye, const_cast<OverlayEye*>(&kEyesOfOverlays[static_cast<std::size_t>(eye)]));
}

ImVec2 place(const glm::dvec2& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

/// Pixels of a text in the panel's font. @param em  pixels
double textWidth(const std::string& text, double em) {
    const float size = static_cast<float>(em) * kFontSizeOfEm;
    return static_cast<double>(findFont(size)->CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x);
}

bool isDark(std::uint32_t color) { return (color & 255) + (color >> 8 & 255) + (color >> 16 & 255) < 3 * 128; }

/// The halo is the text drawn slightly shifted in all directions.
void drawText(ImDrawList& list, const TextMark& mark, const glm::dvec2& corner, std::uint32_t color, std::uint32_t halo,
              float haloWidth) {
    const float size = static_cast<float>(mark.size) * kFontSizeOfEm;
    ImFont* font = findFont(size);
    // At its original size it is aligned to whole pixels, and as sharp as the panel.
    ImVec2 at = place(mark.at + corner);
    at.y -= font->Ascent * size / font->FontSize;
    at = ImVec2(std::round(at.x), std::round(at.y));
    constexpr float kWays[][2] = {{1, 0},       {-1, 0},       {0, 1},        {0, -1},
                                  {0.7f, 0.7f}, {-0.7f, 0.7f}, {0.7f, -0.7f}, {-0.7f, -0.7f}};
    for (const auto& [x, y] : kWays)
        list.AddText(font, size, ImVec2(at.x + x * haloWidth, at.y + y * haloWidth), (halo & 0xffffff) | 0x90000000,
                     mark.text.c_str());
    // Blended in linear light, dark strokes look thinner than in saved pictures: drawing them twice restores their
    // weight.
    for (int i = isDark(color) ? 0 : 1; i < 2; ++i) list.AddText(font, size, at, color, mark.text.c_str());
}

/// Width at the right reserved for the legend next to a fully visible molecule; 0 if they do not overlap, or if less
/// than half would be left.
float legendRoom(const PlacedWords& words, const View& view, double size) {
    PlacedWords alone;
    alone.legends = words.legends;
    const Marks marks = layOut(alone, view, size, {}, {1, 1, 1, 1}, textWidth);
    const double width = view.width, height = view.height, radius = 0.475 * std::min(width, height);
    double left = width, low = 0;
    for (const TextMark& text : marks.texts) left = std::min(left, text.at.x), low = std::max(low, text.at.y);
    for (const DiscMark& disc : marks.discs) left = std::min(left, disc.at.x - disc.radius);
    for (const RampMark& ramp : marks.ramps) left = std::min(left, ramp.low.x);
    const bool beside = std::hypot(std::max(left - width / 2, 0.0), std::max(height / 2 - low, 0.0)) > radius;
    return beside || left < width / 2 ? 0 : static_cast<float>(std::ceil(width - left + size / 2));
}

/// Capitalises a text, unless the first word is a name: "4hhb.pdb ...", "pdb:4HHB ...".
std::string sentenceCase(std::string text) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const bool word = end > 0 && std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end),
                                             [](char c) { return c >= 'a' && c <= 'z'; });
    if (word) text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/// A box with text over the picture, also described for screen readers.
void drawBox(PanelFrame& f, const std::string& text, ImVec2 low, ImVec2 high, float lines) {
    const Theme& theme = f.ui.theme();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(theme.ground), f.ui.px(7));
    list.AddRect(low, high, ImGui::GetColorU32(theme.line), f.ui.px(7), 0, f.ui.px(1));
    Control told;
    told.role = "status";
    told.name = text;
    told.window = "Picture";
    told.left = told.seenLeft = low.x, told.top = told.seenTop = low.y;
    told.right = told.seenRight = high.x, told.bottom = told.seenBottom = high.y;
    told.lines = lines;
    f.ui.controls.push_back(told);
}

/// Small, at the top left of the free area: the legend is at its right.
void drawHint(PanelFrame& f, const std::string& text) {
    if (text.empty()) return;
    ImFont* font = findFont(TextSize::caption);
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
    const ImVec2 pad(f.ui.px(8), f.ui.px(4));
    const Rectangle free = f.s.freeRoom();
    const bool folded = f.s.shown == PanelState::Shown::folded;
    const float menu = folded ? f.ui.px(14) + f.ui.rowHeight() : 0;
    const ImVec2 low(std::round(free.left + f.ui.px(10)), std::round(free.top + f.ui.px(10) + menu));
    drawBox(f, text, low, ImVec2(low.x + size.x + 2 * pad.x, low.y + size.y + 2 * pad.y), 1);
    ImGui::GetBackgroundDrawList()->AddText(font, font->FontSize, ImVec2(low.x + pad.x, low.y + pad.y),
                                            ImGui::GetColorU32(f.ui.theme().faint), text.c_str());
}

/// At the bottom centre of the free area. @returns its top
float drawStatus(PanelFrame& f, const std::string& text, float bottom, bool strong) {
    const Theme& theme = f.ui.theme();
    const Rectangle free = f.s.freeRoom();
    const float widest = std::max(free.width() - f.ui.px(48), 1.0f);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest);
    const float left = std::round(free.left + (free.width() - size.x) / 2), top = std::round(bottom - size.y);
    const ImVec2 pad(f.ui.px(12), f.ui.px(7));
    const ImVec2 low(left - pad.x, top - 2 * pad.y);
    drawBox(f, text, low, ImVec2(left + size.x + pad.x, bottom), size.y / ImGui::GetFontSize());
    ImGui::GetBackgroundDrawList()->AddText(nullptr, 0, ImVec2(left, top - pad.y),
                                            ImGui::GetColorU32(strong ? theme.warning : theme.text), text.c_str(),
                                            nullptr, widest);
    return low.y;
}

/// The colour that replaces another one behind red and cyan glasses, where both eyes see it.
std::uint32_t behindGlasses(std::uint32_t color) {
    std::uint32_t seen = color & 0xff000000;
    const auto channel = [&](std::size_t i) { return srgbToLinear(static_cast<float>(color >> 8 * i & 255) / 255.0f); };
    for (std::size_t c = 0; c < 3; ++c) {
        float sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += (kAnaglyphLeft[c][i] + kAnaglyphRight[c][i]) * channel(i);
        seen |= static_cast<std::uint32_t>(toByte(linearToSrgb(sum))) << 8 * c;
    }
    return seen;
}

Marks behindGlasses(Marks marks) {
    const auto change = [](std::uint32_t& color) { color = behindGlasses(color); };
    change(marks.color), change(marks.halo);
    for (PlateMark& plate : marks.plates) change(plate.color);
    for (ShapeMark& shape : marks.shapes) change(shape.color);
    for (DiscMark& disc : marks.discs) change(disc.color), change(disc.ring);
    for (RampMark& ramp : marks.ramps) std::ranges::for_each(ramp.colors, change);
    for (TextMark& text : marks.texts) change(text.color);
    return marks;
}

/// Draws marks of a part of the window.
void drawMarks(const Marks& marks, const glm::dvec2& corner) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto toScreen = [&](const glm::dvec2& p) { return place(p + corner); };
    const auto haloWidth = static_cast<float>(marks.haloWidth);
    const ImU32 halo = (marks.halo & 0xffffff) | 0xd8000000;
    for (const PlateMark& plate : marks.plates)
        for (const std::vector<glm::dvec2>& part : plate.parts) {
            std::vector<ImVec2> corners;
            for (const glm::dvec2& p : part) corners.push_back(toScreen(p));
            list.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()),
                                     (plate.color & 0xffffff) | static_cast<ImU32>(255 * PlateMark::kStrength) << 24);
        }
    for (const BackMark& back : marks.backs)
        list.AddRectFilled(toScreen(back.low), toScreen(back.high),
                           (marks.halo & 0xffffff) | static_cast<ImU32>(255 * BackMark::kStrength) << 24);
    for (const bool ink : {false, true})
        for (const LineMark& line : marks.lines)
            for (std::size_t i = 1; i < line.points.size(); ++i)
                list.AddLine(toScreen(line.points[i - 1]), toScreen(line.points[i]), ink ? marks.color : halo,
                             static_cast<float>(line.width) + (ink ? 0 : 1.6f * haloWidth));
    for (const bool ink : {false, true})
        for (const ShapeMark& shape : marks.shapes) {
            std::vector<ImVec2> corners;
            for (const glm::dvec2& p : shape.corners) corners.push_back(toScreen(p));
            const int count = static_cast<int>(corners.size());
            if (ink)
                list.AddConvexPolyFilled(corners.data(), count, shape.color);
            else
                list.AddPolyline(corners.data(), count, halo, ImDrawFlags_Closed, 1.6f * haloWidth);
        }
    for (const DiscMark& disc : marks.discs) {
        const auto radius = static_cast<float>(disc.radius);
        list.AddCircleFilled(toScreen(disc.at), radius + 0.8f * haloWidth, halo, 32);
        if (disc.ring) list.AddCircleFilled(toScreen(disc.at), radius, disc.ring, 32);
        list.AddCircleFilled(toScreen(disc.at), static_cast<float>(disc.inner()), disc.color ? disc.color : marks.color,
                             32);
    }
    for (const RampMark& ramp : marks.ramps) {
        const auto steps = static_cast<double>(ramp.colors.size() - 1);
        for (std::size_t i = 0; i + 1 < ramp.colors.size(); ++i) {
            const auto y = [&](std::size_t k) {
                return std::round(ramp.low.y + (ramp.high.y - ramp.low.y) * static_cast<double>(k) / steps);
            };
            list.AddRectFilled(toScreen({ramp.low.x, y(i)}), toScreen({ramp.high.x, y(i + 1)}), ramp.colors[i]);
        }
    }
    for (const TextMark& text : marks.texts)
        drawText(list, text, corner, text.color ? text.color : marks.color, marks.halo, haloWidth);
}

}  // namespace

OverlayEye commandEye(const ImDrawCmd& command) { return *static_cast<const OverlayEye*>(command.UserCallbackData); }

/// Labels, measurements, legend and so on, as in saved pictures.
void drawWords(PanelFrame& f) {
    const PlacedWords& words = f.viewer.words().placed();
    const float taken = f.s.legendRoom;
    const Clip clip = f.viewer.frames().settings().effects.clip;
    const std::vector<FreePart> parts = f.viewer.frames().freeParts();
    for (const FreePart& part : parts) {
        // As in a picture of the free area, with the molecule beside the legend.
        View view = part.view;
        const double share = static_cast<double>(part.view.width) / f.viewer.frames().freeSize().width;
        const double own = taken * share;
        view.width += static_cast<std::uint32_t>(own);
        view.pan.x -= own / 2 / view.pixelsPerAngstrom;
        if (&part == &parts.front())
            f.s.legendRoom = words.legends.empty()
                                 ? 0
                                 : legendRoom(words, view, f.viewer.words().size()) / static_cast<float>(share);
        if (!words.any()) continue;
        Marks marks = layOut(words, view, f.viewer.words().size(), f.viewer.view().words.color,
                             f.viewer.view().background, textWidth, clip, &f.s.wordMemory);
        if (part.eye != OverlayEye::both) {
            marks = behindGlasses(std::move(marks));
            drawFor(part.eye);
        }
        drawMarks(marks, part.corner);
    }
    if (parts.front().eye != OverlayEye::both) drawFor(OverlayEye::both);
    if (f.s.legendRoom != taken) f.s.restless = std::max(f.s.restless, 2);
}

void drawOutline(PanelFrame& f) {
    const ShownMarks& marks = f.viewer.frames().shownMarks();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto at = [&](std::uint32_t x, std::uint32_t y) {
        return ImVec2(static_cast<float>(x * marks.step), static_cast<float>(y * marks.step));
    };
    for (const MarkSpan& span : marks.spans)
        list.AddRectFilled(at(span.x, span.y), at(span.x + span.width, span.y + 1),
                           kMarkColor | static_cast<ImU32>(span.alpha) << 24);
}

void drawAnnotations(PanelFrame& f) {
    const Annotations a = f.viewer.picking().annotations();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();  // beneath panel and help
    const auto toScreen = [&](const glm::dvec2& points) { return place(points * f.s.pixelsPerPoint); };
    constexpr std::pair<ImU32, float> kPens[] = {{kMarkEdge, 5.0f}, {kMark, 2.0f}};
    const bool glasses = f.viewer.view().stereo.mode == Stereo::Mode::anaglyph;
    for (const std::vector<glm::dvec2>* atoms : {&a.atoms, &a.otherAtoms}) {
        if (glasses) drawFor(atoms == &a.atoms ? OverlayEye::left : OverlayEye::right);
        for (std::size_t i = 1; i < atoms->size(); ++i)
            for (const auto& [color, points] : kPens)
                list.AddLine(toScreen((*atoms)[i - 1]), toScreen((*atoms)[i]), color, f.ui.px(points));
        for (const glm::dvec2& atom : *atoms)
            for (const auto& [color, points] : kPens)
                list.AddCircle(toScreen(atom), f.ui.px(8), color, 24, f.ui.px(points));
    }
    if (glasses) drawFor(OverlayEye::both);
    drawHint(f, a.coarse);
    if (!a.error.empty()) return;  // the error is shown instead
    float bottom = f.s.freeRoom().bottom - f.ui.px(14);
    const std::string& under = a.hover.empty() || a.hover == a.atom ? a.atom : a.hover;
    for (const auto& [text, strong] :
         {std::pair(a.message, false), std::pair(a.measurement, true), std::pair(under, false)})
        if (!text.empty()) bottom = drawStatus(f, sentenceCase(text), bottom, strong) - f.ui.px(6);
}

}  // namespace nacre::app
