#pragma once
// How far colours are apart to the eye, and what people with other cones see of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace nacre::test {

using Triple = std::array<double, 3>;

/// What cones are missing. G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, IEEE Trans. Vis. Comput. Graph. 15 (2009)
/// 1291: severity 1, of linear RGB.
enum class Vision { normal, protanopia, deuteranopia, tritanopia };
constexpr Vision kVisions[] = {Vision::normal, Vision::protanopia, Vision::deuteranopia, Vision::tritanopia};

inline Triple toLinear(std::uint32_t packed) {
    Triple rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = (packed >> (8 * i) & 0xff) / 255.0;
        rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return rgb;
}

inline Triple times(const std::array<Triple, 3>& rows, const Triple& v) {
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = rows[i][0] * v[0] + rows[i][1] * v[1] + rows[i][2] * v[2];
    return out;
}

inline Triple seenBy(Vision vision, const Triple& rgb) {
    constexpr std::array<Triple, 3> kProtan = {
        {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
    constexpr std::array<Triple, 3> kDeutan = {
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
    constexpr std::array<Triple, 3> kTritan = {
        {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};
    if (vision == Vision::normal) return rgb;
    Triple seen = times(vision == Vision::protanopia     ? kProtan
                        : vision == Vision::deuteranopia ? kDeutan
                                                         : kTritan,
                        rgb);
    for (double& c : seen) c = std::clamp(c, 0.0, 1.0);
    return seen;
}

/// CIE L*a*b* under D65 of linear sRGB (IEC 61966-2-1; CIE 15:2004).
inline Triple toLab(const Triple& rgb) {
    constexpr std::array<Triple, 3> kXyz = {{{0.4123907992659595, 0.357584339383878, 0.1804807884018343},
                                             {0.21263900587151027, 0.715168678767756, 0.07219231536073371},
                                             {0.01933081871559182, 0.11919477979462598, 0.9505321522496607}}};
    constexpr Triple kWhite = {0.9504559270516716, 1.0, 1.0890577507598784};
    Triple f = times(kXyz, rgb);
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = f[i] / kWhite[i];
        f[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

/// CIEDE2000, as G. Sharma, W. Wu, E. N. Dalal, Color Res. Appl. 30 (2005) 21 write it out.
inline double ciede2000(const Triple& one, const Triple& two) {
    constexpr double kDegree = std::numbers::pi / 180;
    const auto seventh = [](double c) { return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25.0, 7))); };
    const double stretch = 1.5 - 0.5 * seventh((std::hypot(one[1], one[2]) + std::hypot(two[1], two[2])) / 2);
    const double a1 = one[1] * stretch, a2 = two[1] * stretch, b1 = one[2], b2 = two[2];
    const double c1 = std::hypot(a1, b1), c2 = std::hypot(a2, b2);
    const auto hue = [&](double a, double b) {
        const double h = a == 0 && b == 0 ? 0 : std::atan2(b, a) / kDegree;
        return h < 0 ? h + 360 : h;
    };
    const double h1 = hue(a1, b1), h2 = hue(a2, b2);
    double turn = h2 - h1;
    if (turn > 180) turn -= 360;
    if (turn < -180) turn += 360;
    if (c1 * c2 == 0) turn = 0;
    const double dL = two[0] - one[0], dC = c2 - c1, dH = 2 * std::sqrt(c1 * c2) * std::sin(turn / 2 * kDegree);
    const double L = (one[0] + two[0]) / 2, C = (c1 + c2) / 2;
    double h = h1 + h2;
    if (c1 * c2 != 0) h = std::abs(h1 - h2) <= 180 ? h / 2 : h < 360 ? h / 2 + 180 : h / 2 - 180;
    const double t = 1 - 0.17 * std::cos((h - 30) * kDegree) + 0.24 * std::cos(2 * h * kDegree) +
                     0.32 * std::cos((3 * h + 6) * kDegree) - 0.20 * std::cos((4 * h - 63) * kDegree);
    const double twist = 30 * std::exp(-std::pow((h - 275) / 25, 2));
    const double sL = 1 + 0.015 * std::pow(L - 50, 2) / std::sqrt(20 + std::pow(L - 50, 2));
    const double sC = 1 + 0.045 * C, sH = 1 + 0.015 * C * t;
    const double rotation = -std::sin(2 * twist * kDegree) * 2 * seventh(C);
    return std::sqrt(std::pow(dL / sL, 2) + std::pow(dC / sC, 2) + std::pow(dH / sH, 2) +
                     rotation * (dC / sC) * (dH / sH));
}

/// Between two packed colours as somebody sees them.
inline double apartFor(Vision vision, std::uint32_t a, std::uint32_t b) {
    return ciede2000(toLab(seenBy(vision, toLinear(a))), toLab(seenBy(vision, toLinear(b))));
}

}  // namespace nacre::test
