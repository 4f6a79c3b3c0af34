#pragma once
// Parses the values of options. Every function throws std::invalid_argument with the reason, as text that continues
// "--option: "; functions for selections also nacre::Error.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

#include "engine/molecule/floating_point.h"
#include "engine/molecule/read.h"

namespace nacre::app {

constexpr std::uint32_t kLargestSide = 32768;                       ///< pixels
constexpr double kLargestMeshError = 4;                             ///< as RenderSettings::meshError
constexpr std::uint32_t kMostSupersample = 8;                       ///< samples per pixel side
constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 32;      ///< width x height x supersample^2
constexpr std::uint64_t kMostSamplesHeld = std::uint64_t{1} << 27;  ///< for a picture held in memory as a whole
constexpr int kMostDirections = 4096;                               ///< occlusion
constexpr double kSmallestZoom = 1e-4, kLargestZoom = 1e4;
constexpr double kSmallestFov = 1, kLargestFov = 120;  ///< degrees

/// Parses the whole text as a number. @returns whether that succeeded; does not throw
template <typename Number>
bool readWhole(std::string_view text, Number& value) {
    const auto [end, error] = fromChars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/// Throws the reason why `text` is invalid. @param words  the nearest one is suggested
[[noreturn]] void refuse(std::string_view text, const std::string& wanted, std::span<const std::string> words = {});

/// "a, b, c"
std::string joinWords(std::span<const std::string> words);
/// "a, b or c"
std::string joinAlternatives(std::span<const std::string> words);

/// As above for a name with an invalid extension. @param also  other valid forms: ", or a folder"
[[noreturn]] void refuseEnding(std::string_view name, std::span<const std::string> endings,
                               const std::string& also = {});

/// A non-empty file name, unchanged.
std::string fileName(std::string_view text);

/// Side of a picture: pixels, or print size.
struct Length {
    double value = 0;
    bool inches = false;
    /// @param dpi  dots per inch
    double pixels(double dpi) const { return inches ? value * dpi : value; }
};

/// "85mm", "8.5cm", "3.3in"; "1200px" or "1200".
Length parseLength(std::string_view text);

struct Size {
    std::uint32_t width = 1024, height = 1024;
};

/// "640x480"; each side 1 to kLargestSide.
Size parseSize(std::string_view text);

/// "X,Y,Z" in degrees, finite.
glm::dvec3 parseRotation(std::string_view text);

/// The whole text as a finite number within [low, high].
double parseNumber(std::string_view text, double low, double high);

/// The whole text as an integer within [low, high].
std::int64_t parseInteger(std::string_view text, std::int64_t low, std::int64_t high);

/// "all" is kAllModels; otherwise a number from 1.
int parseModel(std::string_view text);

/// A frame's number, from 1. @throws std::invalid_argument
std::int64_t parseFrame(std::string_view text);
/// Number of frames averaged: odd, up to Motion::kMostSmoothed. @throws std::invalid_argument
std::int64_t parseSmoothing(std::string_view text);

/// "off" is 0; otherwise 1 to kMostDirections.
int parseOcclusion(std::string_view text);

/// The index of text among choices; the error lists them.
std::size_t parseChoice(std::string_view text, std::span<const char* const> choices);
std::size_t parseChoice(std::string_view text, std::initializer_list<const char*> choices);

/// "auto" is RenderSettings::kEdges; otherwise 1 to kMostSupersample.
std::uint32_t parseSupersample(std::string_view text);

/// Refuses more than `most`. @param supersample  from parseSupersample()
void checkSamples(const Size& size, std::uint32_t supersample, std::uint64_t most = kMostSamples);

/// A width that depends on the picture's size, resolution or camera.
struct ScreenLength {
    enum class Unit : std::uint8_t {
        points,   ///< 72 per inch
        percent,  ///< of the picture's shorter side
        angstrom  ///< at the centre
    };
    double value = 0;
    Unit unit = Unit::points;

    /// @param shorter  side of the picture, pixels @param dpi  dots per inch
    double pixels(double shorter, double dpi, double pixelsPerAngstrom) const;
};
/// "1.5pt", "0.5%", "0.3A"; empty for other units.
std::optional<ScreenLength> parseScreenLength(std::string_view text);
std::string screenLengthText(const ScreenLength& length);
constexpr double kScreenDpi = 96;                      ///< unless stated, as in CSS
constexpr double kThinnestRim = 0.1, kWidestRim = 64;  ///< of outlines and halos, pixels

/// The points of "1.5pt"; empty for other units.
std::optional<double> parsePoints(std::string_view text);
/// "2", "2px"; "1.5pt" at 96 dots per inch.
double parsePixels(std::string_view text, double least, double most);

}  // namespace nacre::app
