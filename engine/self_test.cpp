#include "engine/self_test.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iomanip>
#include <limits>
#include <span>
#include <sstream>

#include "engine/error.h"
#include "engine/frame/choose.h"
#include "engine/frame/picture.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/occlusion/directions.h"
#include "engine/renderer.h"
#include "engine/storage/disk_cache.h"

namespace nacre {
namespace {

/// Paths tested on request. The last one is for software devices, which are not tested automatically.
constexpr Visibility kEveryPath[] = {Visibility::encoded, Visibility::fragdepth, Visibility::rasterOrder,
                                     Visibility::deferred, Visibility::tiles};
constexpr std::span<const Visibility> kPaths(kEveryPath, std::size(kEveryPath) - 1);
constexpr const char* kOutcomes[] = {"right", "wrong", "failed", "unfinished"};
constexpr const char* kHeading = "nacre self-test 3";
constexpr std::uint32_t kPixels = 128, kTimedPixels = 720;
constexpr int kDirections = 16;                // of a bake: a batch
constexpr std::uint64_t kMostBytes = 1 << 20;  // of all answers

DiskCache cacheOf(const std::string& folder) { return DiskCache(folder, kMostBytes, {"paths-"}); }
std::string nameOf(const std::string& key) { return "paths-" + key; }

std::string textOf(const SelfTest& test) {
    std::ostringstream text;
    text << std::setprecision(std::numeric_limits<double>::max_digits10) << kHeading << '\n';
    for (const PathResult& r : test)
        text << visibilityName(r.visibility) << ' ' << kOutcomes[static_cast<int>(r.outcome)] << ' ' << r.milliseconds
             << ' ' << r.tries << ' ' << r.subpasses << ' ' << r.carried << ' ' << r.transientBytes << ' '
             << r.committedBytes << '\n';
    return text.str();
}

/// Empty for anything but the output of textOf().
SelfTest read(const std::string& folder, const std::string& key) {
    const std::optional<std::string> text = cacheOf(folder).read(nameOf(key));
    if (!text) return {};
    std::istringstream lines(*text);
    std::string line, path, outcome;
    if (!std::getline(lines, line) || line != kHeading) return {};
    SelfTest test;
    for (PathResult r; std::getline(lines, line); test.push_back(r)) {
        std::istringstream words(line);
        if (!(words >> path >> outcome >> r.milliseconds >> r.tries >> r.subpasses >> r.carried >> r.transientBytes >>
              r.committedBytes))
            return {};
        const auto visibility =
            std::ranges::find_if(kEveryPath, [&](Visibility v) { return path == visibilityName(v); });
        const auto found = std::find(std::begin(kOutcomes), std::end(kOutcomes), outcome);
        if (visibility == std::end(kEveryPath) || found == std::end(kOutcomes)) return {};
        r.visibility = *visibility;
        r.outcome = static_cast<PathResult::Outcome>(found - std::begin(kOutcomes));
    }
    return test;
}

void write(const std::string& folder, const std::string& key, const SelfTest& test) {
    const std::string text = textOf(test);
    const std::string_view parts[] = {text};
    cacheOf(folder).write(nameOf(key), parts);
}

/// A colour for each of 63 atoms, far from the next; never black.
std::uint32_t colorOf(std::uint32_t atom) {
    constexpr std::uint32_t kLevels[] = {0x20, 0x60, 0xa0, 0xe0};
    return kLevels[atom & 3] | kLevels[atom >> 2 & 3] << 8 | kLevels[atom >> 4 & 3] << 16;
}

/// Spheres and sticks, or spheres that cut into each other, which no plate in front of one settles; each atom in a
/// colour of its own.
Representation testScene(Style style) {
    const Molecule molecule = sampleMolecule("glucose");
    RepresentationOptions look;
    look.style = style;
    Representation r = represent(molecule, drawnAtoms(molecule), look);
    for (SphereLook& s : r.sphereLooks) s.color = colorOf(s.atom);
    for (CylinderLook& c : r.cylinderLooks) c.colorA = colorOf(c.atomA), c.colorB = colorOf(c.atomB);
    return r;
}

/// The expected surface at a point of the view, orthographic, computed independently.
struct Seen {
    std::uint32_t color = 0;    ///< 0: nothing
    glm::dvec3 at{}, normal{};  ///< of a sphere, view space
    bool operator==(const Seen& other) const { return color == other.color; }
};
Seen seenAt(const Representation& r, const View& view, double px, double py) {
    const double x = (px - view.width / 2.0) / view.pixelsPerAngstrom - view.pan.x;
    const double y = (view.height / 2.0 - py) / view.pixelsPerAngstrom - view.pan.y;
    double nearest = -1e9;
    Seen seen;
    const auto meets = [&](double z, std::uint32_t color, const glm::dvec3& center) {
        if (z <= nearest) return;
        nearest = z;
        const glm::dvec3 at(x, y, z);
        seen = {color, at, glm::normalize(at - center)};
    };
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        const glm::dvec3 c = view.rotation * glm::dvec3(r.spheres[i].center);
        const double radius = r.spheres[i].radius;
        const double under = radius * radius - (x - c.x) * (x - c.x) - (y - c.y) * (y - c.y);
        if (under > 0) meets(c.z + std::sqrt(under), r.sphereLooks[i].color, c);
    }
    for (std::size_t i = 0; i < r.cylinders.size(); ++i) {
        const glm::dvec3 a = view.rotation * glm::dvec3(r.cylinders[i].a),
                         b = view.rotation * glm::dvec3(r.cylinders[i].b);
        const double length = glm::distance(a, b), radius = r.cylinders[i].radius;
        const glm::dvec3 axis = (b - a) / length, from = glm::dvec3(x, y, 0) - a;
        const glm::dvec3 ray = glm::dvec3(0, 0, 1) - axis * axis.z, across = from - axis * glm::dot(axis, from);
        const double aa = glm::dot(ray, ray), ab = glm::dot(ray, across);
        const double under = ab * ab - aa * (glm::dot(across, across) - radius * radius);
        if (aa < 1e-9 || under <= 0) continue;
        const double z = (-ab + std::sqrt(under)) / aa, along = glm::dot(from + glm::dvec3(0, 0, z), axis);
        // Both ends are inside of spheres.
        if (along > 0 && along < length)
            meets(z, along < length / 2 ? r.cylinderLooks[i].colorA : r.cylinderLooks[i].colorB, a);
    }
    return seen;
}

/// Whether a picture shows the scene. Pixels near an edge may show either side.
bool shows(const Picture& picture, const Representation& r, const View& view) {
    constexpr double kNear = 0.75;
    std::uint32_t looked = 0;
    for (std::uint32_t j = 0; j < picture.height; ++j)
        for (std::uint32_t i = 0; i < picture.width; ++i) {
            const Seen seen = seenAt(r, view, i + 0.5, j + 0.5);
            const std::uint32_t expected = seen.color;
            bool edge = false;
            for (const double dx : {-kNear, kNear})
                for (const double dy : {-kNear, kNear})
                    edge = edge || seenAt(r, view, i + 0.5 + dx, j + 0.5 + dy) != seen;
            if (edge) continue;
            ++looked;
            const float* pixel = &picture.rgba[4 * (std::size_t{j} * picture.width + i)];
            if ((pixel[3] > 0.5f) != (expected != 0)) return false;
            for (int channel = 0; channel < 3 && expected; ++channel) {
                const float wanted = linearFromSrgb(static_cast<float>(expected >> 8 * channel & 0xff) / 255.0f);
                // Levels differ by at least 0.1 of linear light, except for the lowest two.
                if (!(std::abs(pixel[channel] - wanted) < 0.02f)) return false;
            }
        }
    return looked > picture.width * picture.height / 2;
}

/// Fraction of ambient light at a point of a sphere, from the directions of a bake.
double opennessAt(const Representation& r, const View& view, const Seen& seen,
                  const std::vector<glm::dmat3>& directions) {
    double open = 0, all = 0;
    for (const glm::dmat3& frame : directions) {
        const glm::dvec3 w = view.rotation * glm::dvec3(frame[0].z, frame[1].z, frame[2].z);
        const double share = std::max(glm::dot(seen.normal, w), 0.0);
        const bool hidden = std::ranges::any_of(r.spheres, [&](const Sphere& s) {
            const glm::dvec3 to = view.rotation * glm::dvec3(s.center) - seen.at;
            const double along = glm::dot(to, w),
                         under = double{s.radius} * s.radius - glm::dot(to, to) + along * along;
            return under > 0 && along > 0 && glm::dot(to, to) > 1.001 * s.radius * s.radius;  // not its own
        });
        all += share;
        if (!hidden) open += share;
    }
    return all > 0 ? open / all : 1;
}

/// Whether a picture of spheres is as dark as its occlusion is to make it: the bake draws, dispatches and copies.
bool showsOcclusion(const Picture& picture, const Representation& r, const View& view) {
    const std::vector<glm::dmat3> directions = occlusionDirections(kDirections);
    double error = 0, looked = 0;
    for (std::uint32_t j = 0; j < picture.height; j += 3)
        for (std::uint32_t i = 0; i < picture.width; i += 3) {
            const Seen seen = seenAt(r, view, i + 0.5, j + 0.5);
            if (!seen.color) continue;
            const float base = linearFromSrgb(static_cast<float>(seen.color >> 8 & 0xff) / 255.0f);
            const float green = picture.rgba[4 * (std::size_t{j} * picture.width + i) + 1];
            error += std::abs(double{green} / base - opennessAt(r, view, seen, directions));
            ++looked;
        }
    // Texels and edges cause 0.05; a bake that is all light or all dark, 0.3 and more.
    return error < 0.15 * looked;
}

RenderSettings settingsOf(const Representation& r, std::uint32_t pixels) {
    RenderSettings s;
    Camera camera;
    camera.rotationDegrees = {20, 30, 40};
    s.view = viewOf(camera, r.radius, pixels, pixels);
    s.supersample = 1;
    s.background = {0, 0, 0, 0};
    s.lighting = false;
    s.occlusion.directions = 0;
    return s;
}

/// Least of a few frames, by the device's own clock if it has one.
double timed(Renderer& renderer) {
    const Molecule molecule = sampleMolecule("dna");
    const Representation r = represent(molecule, drawnAtoms(molecule), {});
    renderer.setScene(r);
    RenderSettings s = settingsOf(r, std::min(kTimedPixels, renderer.maxSize()));
    s.lighting = true;
    s.tuning.timePasses = true;
    double least = 1e9;
    for (int frame = 0; frame < 4; ++frame) {
        const double waited = renderer.drawFrame(s);
        double sum = 0;
        for (const PassTime& pass : renderer.stats().passTimes) sum += pass.milliseconds;
        if (frame > 0) least = std::min(least, sum > 0 ? sum : waited);  // the first compiles
    }
    return least;
}

/// The driver's feedback on the path's frames.
void addFeedback(PathResult& result, const DriverFeedback& driver) {
    for (const MergedSubpasses& m : driver.merges)
        if (m.name.starts_with("opaque prepass")) {
            result.subpasses = static_cast<int>(m.planned);
            result.carried = static_cast<int>(m.carried);
        }
    for (const TransientImage& image : driver.transients) {
        result.transientBytes += image.bytes;
        result.committedBytes += image.committedBytes;
    }
}

PathResult tested(const DeviceOptions& options, Visibility path) {
    PathResult result{path, PathResult::Outcome::failed, 0, 0};
    try {
        DeviceOptions alone = options;
        alone.visibility = path;
        alone.surface = {};
        alone.selfTests.clear();
        Renderer renderer(alone);
        result.outcome = PathResult::Outcome::right;
        for (const Style style : {Style::ballAndStick, Style::spacefill}) {
            const Representation r = testScene(style);
            renderer.setScene(r);
            RenderSettings s = settingsOf(r, kPixels);
            if (!shows(renderer.render(s), r, s.view)) result.outcome = PathResult::Outcome::wrong;
            if (style != Style::spacefill) continue;
            s.occlusion.directions = kDirections;
            if (!showsOcclusion(renderer.render(s), r, s.view)) result.outcome = PathResult::Outcome::wrong;
        }
        if (result.outcome == PathResult::Outcome::right) result.milliseconds = timed(renderer);
        addFeedback(result, renderer.driverFeedback());
    } catch (const Error&) {
        result.outcome = PathResult::Outcome::failed;
    }
    return result;
}

}  // namespace

SelfTest testPaths(const DeviceOptions& options, const std::string& key, bool every) {
    const DeviceInfo device = [&] {
        DeviceOptions alone = options;
        alone.surface = {};
        alone.selfTests.clear();
        return Renderer(alone).stats().device;
    }();
    SelfTest test = read(options.selfTests, key);
    const std::span<const Visibility> paths = every ? std::span<const Visibility>(kEveryPath) : kPaths;
    for (const Visibility path : paths) {
        if (!hasPath(path, device.rasterOrder, device.tiles)) continue;
        auto it = std::find_if(test.begin(), test.end(), [&](const PathResult& r) { return r.visibility == path; });
        if (it == test.end()) it = test.insert(it, {path, PathResult::Outcome::unfinished, 0, 0});
        if (it->known()) continue;
        ++it->tries;
        write(options.selfTests, key, test);  // should the driver take the program with it
        *it = tested(options, path);
    }
    write(options.selfTests, key, test);
    return test;
}

std::optional<SelfTest> keptSelfTest(const std::string& folder, const std::string& key) {
    SelfTest test = read(folder, key);
    const Visibility last = kPaths.back();
    const bool whole = std::ranges::any_of(test, [&](const PathResult& r) { return r.visibility == last; });
    if (!whole || !std::all_of(test.begin(), test.end(), [](const PathResult& r) { return r.known(); })) return {};
    return test;
}

void forgetSelfTest(const std::string& folder, const std::string& key) { cacheOf(folder).remove(nameOf(key)); }

namespace {

/// " (3 subpasses as 1, 0 of 41 kB committed)"
std::string tellsOfTile(const PathResult& r) {
    std::string text;
    if (r.carried > 0) text = std::to_string(r.subpasses) + " subpasses as " + std::to_string(r.carried);
    if (r.transientBytes > 0)
        text += (text.empty() ? "" : ", ") + std::to_string(r.committedBytes / 1000) + " of " +
                std::to_string(r.transientBytes / 1000) + " kB committed";
    return text.empty() ? "" : " (" + text + ")";
}

}  // namespace

std::string describe(const SelfTest& test) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2);
    for (const PathResult& r : test) {
        text << (text.tellp() > 0 ? ", " : "") << visibilityName(r.visibility) << ' ';
        if (r.outcome == PathResult::Outcome::right)
            text << r.milliseconds << " ms" << tellsOfTile(r);
        else
            text << (r.outcome == PathResult::Outcome::unfinished ? "ends the program"
                                                                  : kOutcomes[static_cast<int>(r.outcome)]);
    }
    return text.str();
}

graph::TestedPath choosePath(const SelfTest& test, Visibility byCaps, const std::string& whyByCaps) {
    const PathResult *chosen = nullptr, *fastest = nullptr;
    for (const PathResult& r : test) {
        if (r.outcome != PathResult::Outcome::right) continue;
        if (r.visibility == byCaps) chosen = &r;
        if (!isTimedBySmallScenes(r.visibility) && r.visibility != byCaps) continue;
        if (!fastest || r.milliseconds < fastest->milliseconds) fastest = &r;
    }
    if (!fastest) return {byCaps, whyByCaps + " (and no path draws right: " + describe(test) + ")"};
    // Frequencies of phones' GPUs differ by a tenth to a seventh between steps (Adreno 650: 305 to 587 MHz in six,
    // Mali-G610 of RK3588: 300 to 1000 MHz in eight). One step between two tests makes a path look 1.2 times as fast.
    constexpr double kFasterByItself = 0.8;
    if (chosen && fastest->milliseconds >= kFasterByItself * chosen->milliseconds) return {byCaps, whyByCaps};
    const std::string what =
        chosen ? "the fastest here: " : std::string(visibilityName(byCaps)) + " draws wrongly here: ";
    return {fastest->visibility, what + describe(test)};
}

void addSelfTest(DeviceInfo& device, const std::string& folder) {
    const std::optional<SelfTest> kept = keptSelfTest(folder, device.driverKey);
    if (!kept) return;
    device.selfTest = describe(*kept);
    for (const Visibility path : kPaths)
        if (device.visibility == visibilityName(path)) {
            const graph::TestedPath taken = choosePath(*kept, path, device.why);
            device.visibility = visibilityName(taken.visibility);
            device.why = taken.why;
            return;
        }
}

}  // namespace nacre
