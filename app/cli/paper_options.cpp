#include "app/cli/paper_options.h"

#include <algorithm>
#include <cmath>

#include "app/cli/common_options.h"
#include "app/files/output_file.h"

namespace nacre::app {
namespace {

constexpr double kPrint = 300, kScreen = 96;  // dots an inch, where none are said: of paper, and as CSS has it

std::uint32_t sideOf(const char* name, double pixels) {
    const double rounded = std::round(pixels);
    if (rounded < 1 || rounded > kLargestSide)
        throw UsageError(std::string(name) + ": " + std::to_string(static_cast<std::int64_t>(rounded)) +
                         " pixels; 1 to " + std::to_string(kLargestSide) + " are drawn");
    return static_cast<std::uint32_t>(rounded);
}

}  // namespace

void addPaper(CommandSpec& command, RenderOptions& options) {
    addValue(command, "--width", "LENGTH", "as --size says",
             "85mm, 8.5cm, 3.3in, at --dpi; or 1200px. Without --height, that follows by the shape of --size",
             [&](const std::string& text) { options.width = parseLength(text); });
    addValue(command, "--height", "LENGTH", "as --size says", "The same from top to bottom",
             [&](const std::string& text) { options.height = parseLength(text); });
    addValue(command, "--dpi", "N", "300 with lengths on paper", "Dots an inch, 1 to 10000; PNG, TIFF and JPEG say it",
             [&](const std::string& text) { options.dpi = parseNumber(text, 1, 10000); });
    addValue(command, "--depth", "8|16", "8", "Bits of a channel, 16 in PNG and TIFF", [&](const std::string& text) {
        options.bits = parseChoice(text, {"8", "16"}) == 0 ? 8 : 16;
    });
}

void takePaper(RenderOptions& options) {
    if ((options.width && options.width->inches) || (options.height && options.height->inches))
        options.dpi = options.dpi.value_or(kPrint);
    const double dpi = options.dpi.value_or(kScreen);
    Size& size = options.size;
    const double shape = static_cast<double>(size.height) / size.width;
    const double width = options.width ? options.width->pixels(dpi) : 0;
    const double height = options.height ? options.height->pixels(dpi) : 0;
    if (options.width) size.width = sideOf("--width", width);
    if (options.height) size.height = sideOf("--height", height);
    if (options.width && !options.height) size.height = sideOf("--width", width * shape);
    if (options.height && !options.width) size.width = sideOf("--height", height / shape);
    constexpr double kPointsOfInch = 72;
    if (options.contourPoints) options.effects.contours.width = *options.contourPoints * dpi / kPointsOfInch;
    if (options.haloPoints) options.effects.halos.width = *options.haloPoints * dpi / kPointsOfInch;
    if (options.textPoints) options.words.size = *options.textPoints * dpi / kPointsOfInch;
}

void checkFormat(const RenderOptions& options) {
    const std::string format = isStandardOutput(options.output) ? ".png" : extensionOf(options.output);
    if (options.bits == 16 && format != ".png" && format != ".tif" && format != ".tiff")
        throw UsageError("--depth 16 is for PNG and TIFF, not " + options.output);
    constexpr std::uint32_t kLargestWebp = 16383;  // the format's own limit
    if (format == ".webp" && std::max(options.size.width, options.size.height) > kLargestWebp)
        throw UsageError("WebP holds at most " + std::to_string(kLargestWebp) + " pixels a side");
}

}  // namespace nacre::app
