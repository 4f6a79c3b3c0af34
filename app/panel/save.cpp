// Saving of images: size, resolution, format, and path.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/panel/panel_state.h"
#include "app/picture/option_values.h"

namespace nacre::app {
namespace {

constexpr const char* kSizes[] = {"Screen size", "Square, 2048", "Wide, 1920 x 1080", "Print"};
constexpr const char* kFormats[] = {"PNG", "WebP", "TIFF", "JPEG", "OpenEXR"};
constexpr const char* kExtensions[] = {".png", ".webp", ".tif", ".jpg", ".exr"};
constexpr int kPaper = 3, kJpeg = 3;  // indices of sizes, and of the format without transparency
constexpr float kSavePoints = 460;
constexpr int kMostMm = 2000, kMostDpi = 2400;

std::uint32_t toPixels(int millimetres, int dpi) {
    return static_cast<std::uint32_t>(
        std::clamp(std::lround(millimetres / 25.4 * dpi), 1l, static_cast<long>(kLargestSide)));
}

}  // namespace

void PanelState::setSavePath(const std::string& to) {
    const std::string end = std::filesystem::path(to).extension().string();
    save.path = end.empty() ? to + kExtensions[save.format] : to;
    for (int i = 0; i < static_cast<int>(std::size(kExtensions)); ++i)
        if (end == kExtensions[i]) save.format = i;
    restless = 3;
}

bool fieldOfPath(PanelFrame& f, const PathField& field, std::string& path, PathChosen chosen) {
    f.ui.heading("Save as");
    const bool dialog = f.host.saveDialog || f.host.browses;
    const float choose = dialog ? f.ui.buttonWidth("Choose ...") + f.ui.px(2) : 0;
    const float gap = dialog ? ImGui::GetStyle().ItemSpacing.x : 0;
    focusField(f);
    const bool entered = f.ui.field(field.name, field.hint, path, ImGui::GetContentRegionAvail().x - choose - gap,
                                    ImGuiInputTextFlags_EnterReturnsTrue);
    if (dialog) {
        ImGui::SameLine();
        if (f.ui.button(Icon::none, "Choose ...", choose)) f.s.askWhere(field.title, path, std::move(chosen), "Choose");
    }
    f.ui.openFolder(path.c_str());
    return entered;
}

void drawSave(PanelFrame& f) {
    const auto rename = [&] {
        if (f.host.freeName) f.s.save.path = f.host.freeName(kExtensions[f.s.save.format]);
    };
    if (f.s.save.path.empty()) rename();
    if (beginCard(f, "Save", "Save image", kSavePoints)) f.s.saving = false;
    f.ui.heading("Size");
    f.ui.choose("Size", kSizes, f.s.save.preset);
    if (f.s.save.preset == kPaper) {
        const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
        const auto number = [&](const char* name, int& value, int most, const char* format) {
            ImGui::SetNextItemWidth(third);
            ImGui::PushID(name);
            ImGui::DragInt("##number", &value, 1, 1, most, format, ImGuiSliderFlags_AlwaysClamp);
            ImGui::PopID();
            f.ui.note("slider", name, std::to_string(value));
        };
        number("Width", f.s.save.widthMm, kMostMm, "%d mm wide");
        ImGui::SameLine();
        number("Height", f.s.save.heightMm, kMostMm, "%d mm high");
        ImGui::SameLine();
        number("Resolution", f.s.save.dpi, kMostDpi, "%d dpi");
    }
    PictureWish wish;
    const PixelSize window = f.viewer.frames().size();
    const PixelSize sizes[] = {window,
                               {2048, 2048},
                               {1920, 1080},
                               {toPixels(f.s.save.widthMm, f.s.save.dpi), toPixels(f.s.save.heightMm, f.s.save.dpi)}};
    wish.size = sizes[f.s.save.preset];
    f.ui.caption(std::to_string(wish.size.width) + " x " + std::to_string(wish.size.height) + " pixels");
    f.ui.heading("Format");
    if (f.ui.choose("Format", kFormats, f.s.save.format)) rename();
    if (f.s.save.format != kJpeg) f.ui.toggle("Transparent background", f.s.save.transparent);
    if (f.viewer.picking().selection().count > 0 && !f.look.stereo.both())
        f.ui.toggle("Outline of the selection", f.s.save.marked);
    const bool entered = fieldOfPath(f, {"Path", "picture.png", "Save image"}, f.s.save.path,
                                     [&s = f.s](const std::string& path) { s.setSavePath(path); });
    ImGui::Spacing();
    wish.transparent = f.s.save.transparent && f.s.save.format != kJpeg;
    wish.marked = f.s.save.marked;
    wish.path = f.s.save.path;
    if (f.s.save.preset == kPaper) wish.dpi = f.s.save.dpi;
    static const Answer kAnswers[] = {{"Cancel"}, {"Save", Icon::save}};
    const auto pressed = f.ui.answers(kAnswers);
    if (pressed == 0u) f.s.saving = false;
    if ((pressed == 1u || entered) && !wish.path.empty()) {
        f.s.saving = false;
        f.host.savePicture(wish);
        f.s.restless = 3;
    }
    if (!f.s.saving) f.s.save.path.clear();
    endGrown(f);
}

}  // namespace nacre::app
