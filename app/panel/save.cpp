// A picture for a file: how large, on what, in which format, and where to.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/panel/panel_state.h"
#include "app/picture/option_values.h"

namespace nacre::app {
namespace {

constexpr const char* kSizes[] = {"As on the screen", "Square, 2048", "Wide, 1920 x 1080", "For paper"};
constexpr const char* kFormats[] = {"PNG", "WebP", "TIFF", "JPEG", "OpenEXR"};
constexpr const char* kExtensions[] = {".png", ".webp", ".tif", ".jpg", ".exr"};
constexpr int kPaper = 3, kJpeg = 3;  // of sizes, and of formats the one without transparency
constexpr float kSavePoints = 460;
constexpr int kMostMm = 2000, kMostDpi = 2400;

std::uint32_t pixelsOf(int millimetres, int dpi) {
    return static_cast<std::uint32_t>(
        std::clamp(std::lround(millimetres / 25.4 * dpi), 1l, static_cast<long>(kLargestSide)));
}

}  // namespace

void Panel::setSavePath(const std::string& path) {
    State& s = *state_;
    std::string whole = path;
    const std::string end = std::filesystem::path(path).extension().string();
    if (end.empty()) whole += kExtensions[s.format];
    for (int i = 0; i < static_cast<int>(std::size(kExtensions)); ++i)
        if (end == kExtensions[i]) s.format = i;
    std::snprintf(s.path, sizeof s.path, "%s", whole.c_str());
    restless_ = 3;
}

void Panel::drawSave(const Viewer& viewer) {
    Widgets& ui = state_->ui;
    State& s = *state_;
    const auto rename = [&] {
        if (host_.freeName) std::snprintf(s.path, sizeof s.path, "%s", host_.freeName(kExtensions[s.format]).c_str());
    };
    if (s.path[0] == '\0') rename();
    if (beginCard("Save", "Save the picture", kSavePoints)) saving_ = false;
    ui.heading("Size");
    std::string size = kSizes[s.preset];
    if (ui.choose("Size", kSizes, size))
        for (int i = 0; i < static_cast<int>(std::size(kSizes)); ++i)
            if (size == kSizes[i]) s.preset = i;
    if (s.preset == kPaper) {
        const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
        const auto number = [&](const char* name, int& value, int most, const char* format) {
            ImGui::SetNextItemWidth(third);
            ImGui::PushID(name);
            ImGui::DragInt("##number", &value, 1, 1, most, format, ImGuiSliderFlags_AlwaysClamp);
            ImGui::PopID();
            ui.note("slider", name, std::to_string(value));
        };
        number("Width", s.widthMm, kMostMm, "%d mm wide");
        ImGui::SameLine();
        number("Height", s.heightMm, kMostMm, "%d mm high");
        ImGui::SameLine();
        number("Resolution", s.dpi, kMostDpi, "%d dpi");
    }
    PictureWish wish;
    const PixelSize window = viewer.size();
    const PixelSize sizes[] = {
        window, {2048, 2048}, {1920, 1080}, {pixelsOf(s.widthMm, s.dpi), pixelsOf(s.heightMm, s.dpi)}};
    wish.size = sizes[s.preset];
    ui.caption(std::to_string(wish.size.width) + " x " + std::to_string(wish.size.height) + " pixels");
    ui.heading("Format");
    std::string format = kFormats[s.format];
    if (ui.choose("Format", kFormats, format)) {
        for (int i = 0; i < static_cast<int>(std::size(kFormats)); ++i)
            if (format == kFormats[i]) s.format = i;
        rename();
    }
    if (s.format != kJpeg) ui.toggle("Transparent background", s.transparent);
    ui.heading("Where to");
    const float choose = host_.saveDialog ? ui.buttonWidth("Choose ...") + ui.px(2) : 0;
    const float gap = host_.saveDialog ? ImGui::GetStyle().ItemSpacing.x : 0;
    ui.field("Path", "picture.png", s.path, sizeof s.path, ImGui::GetContentRegionAvail().x - choose - gap);
    if (host_.saveDialog) {
        ImGui::SameLine();
        if (ui.button(Icon::none, "Choose ...", choose)) host_.saveDialog(s.path);
    }
    ui.folderOf(s.path);
    ImGui::Spacing();
    wish.transparent = s.transparent && s.format != kJpeg;
    wish.path = s.path;
    if (s.preset == kPaper) wish.dpi = s.dpi;
    if (ui.button(Icon::save, "Save", 0, true) && wish.path[0] != '\0') {
        saving_ = false;
        host_.savePicture(wish);
        s.path[0] = '\0';
        restless_ = 3;
    }
    ImGui::SameLine();
    if (ui.button(Icon::none, "Cancel")) saving_ = false;
    if (!saving_) s.path[0] = '\0';
    endCard();
}

}  // namespace nacre::app
