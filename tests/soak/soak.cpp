// A long sitting: random files, styles, selections, colours, views, sizes, debug views and bakes, one after the other,
// on one renderer. Says how memory went over the second half, and fails if it grew: the first half compiles every kind
// of pipeline. Memory is looked at between two files, when nothing is loaded and it may be compared. With `validate`
// the validation layer listens instead, whose own memory grows, and a message fails.
//   soak [FRAMES [FILES [validate]]]      10000 frames and 200 files, if not said
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

constexpr double kFlat = 1e6;                     // bytes in 1000 frames
constexpr std::uintmax_t kLargestFile = 600'000;  // bytes: many small files rather than a few large ones

struct Sample {
    double frame, residentBytes, deviceBytes;
    double freedBytes;  // resident, but given back when the allocator was asked to
};

double residentBytes() {
    std::ifstream in("/proc/self/statm");
    long size = 0, resident = 0;
    in >> size >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// Least squares, bytes per 1000 frames.
double slope(const std::vector<Sample>& samples, double Sample::*value) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Sample& s : samples) {
        n += 1, x += s.frame, y += s.*value, xx += s.frame * s.frame, xy += s.frame * s.*value;
    }
    return 1000 * (n * xy - x * y) / (n * xx - x * x);
}

std::vector<std::string> inputs() {
    std::vector<std::string> found{"sample:dna", "sample:glucose", "sample:buckyball"};
    if (const auto folder = test::dataFolder())
        for (const auto& entry : std::filesystem::directory_iterator(*folder))
            if (entry.is_regular_file() && entry.file_size() < kLargestFile) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

class Soak {
public:
    Soak(int frames, int files, bool validate)
        : frames_(frames), every_(std::max(frames / files, 1)), validate_(validate) {
        renderer_ = std::make_unique<Renderer>(DeviceOptions{.validate = validate});
    }

    int run() {
        for (int frame = 0; frame < frames_; ++frame) {
            if (frame % every_ == 0) {
                rest(frame);
                load();
            }
            if (frame % 7 == 3) rebuild();
            draw();
            most_ = std::max(most_, residentBytes());
        }
        return tell();
    }

private:
    template <typename T>
    const T& pickOne(const std::vector<T>& list) {
        return list[random_() % list.size()];
    }
    double within(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

    /// Nothing is loaded but what the renderer keeps of its own.
    void rest(int frame) {
        molecule_ = {};
        renderer_->setScene({});
        renderer_->drawFrame(RenderSettings{.view = makeView({}, 1, 64, 64)});
        if (frame < frames_ / 2) return;
        const double before = residentBytes();
        malloc_trim(0);
        const double after = residentBytes();
        samples_.push_back(
            {double(frame), after, static_cast<double>(renderer_->stats().deviceBytesHeld), before - after});
    }

    void load() {
        static const std::vector<std::string> all = inputs();
        for (;;) {
            const std::string& input = pickOne(all);
            try {
                molecule_ = input.starts_with("sample:") ? sampleMolecule(input.substr(7)) : readMoleculeFile(input);
            } catch (const Error&) {
                continue;  // no structure, or a format that is not read
            }
            if (drawnAtoms(molecule_, {}).empty()) continue;
            ++loaded_;
            return rebuild();
        }
    }

    void rebuild() {
        RepresentationOptions look;
        look.style = pickOne(std::vector{Style::spacefill, Style::ballAndStick, Style::licorice});
        look.color = pickOne(std::vector{ColorScheme::element, ColorScheme::chain, ColorScheme::residue});
        if (random_() % 2) {
            Rule rule;
            rule.selection =
                parseSelection(pickOne(std::vector{"element C", "resi 1-50", "backbone", "not element H"}));
            rule.style = Style::licorice;
            look.rules.push_back(rule);
        }
        Representation scene = represent(molecule_, drawnAtoms(molecule_), look);
        radius_ = scene.radius;
        directions_ = static_cast<int>(random_() % 3) * 4;
        renderer_->setScene(std::move(scene));
    }

    void draw() {
        RenderSettings s;
        Camera camera;
        camera.rotationDegrees = {within(-180, 180), within(-180, 180), within(-180, 180)};
        camera.zoom = within(0.5, 3);
        camera.projection = random_() % 2 ? Projection::perspective : Projection::orthographic;
        const auto side = [&] { return static_cast<std::uint32_t>(16 + random_() % 180); };
        s.view = makeView(camera, radius_, side(), side());
        s.occlusion.directions = directions_;
        if (random_() % 4 == 0) s.debug = static_cast<DebugView>(random_() % debugViewNames().size());
        switch (random_() % 4) {
            case 0:
                renderer_->layers(s);
                break;
            case 1:
                renderer_->render(s);
                break;
            case 2:
                renderer_->atomAt(s, s.view.width / 2.0, s.view.height / 2.0, 6);
                break;
            default:
                renderer_->drawFrame(s);
        }
    }

    int tell() const {
        const double resident = slope(samples_, &Sample::residentBytes), device = slope(samples_, &Sample::deviceBytes);
        const Sample& last = samples_.back();
        std::printf("%d frames, %d files; at most %.1f MB resident\nat rest, and the slope in 1000 frames:\n", frames_,
                    loaded_, most_ / 1e6);
        const auto line = [&](const char* what, double now, double grows) {
            std::printf("  %-28s %7.1f MB  %+.3f MB\n", what, now / 1e6, grows / 1e6);
        };
        line("resident", last.residentBytes, resident);
        line("freed, kept by the allocator", last.freedBytes, slope(samples_, &Sample::freedBytes));
        line("of the device's", last.deviceBytes, device);
        for (const std::string& message : renderer_->validationMessages()) std::cerr << message << "\n";
        if (validate_) return renderer_->validationMessages().empty() ? 0 : 1;
        const bool flat = resident < kFlat && device < kFlat;
        if (!flat) std::cerr << "memory grows\n";
        return flat ? 0 : 1;
    }

    int frames_, every_, loaded_ = 0, directions_ = 0;
    bool validate_;
    std::mt19937 random_{1};
    std::unique_ptr<Renderer> renderer_;
    Molecule molecule_;
    double radius_ = 1;
    double most_ = 0;  // bytes resident, whatever was loaded
    std::vector<Sample> samples_;
};

}  // namespace
}  // namespace nacre

int main(int count, char** arguments) try {
    const int frames = count > 1 ? std::atoi(arguments[1]) : 10000, files = count > 2 ? std::atoi(arguments[2]) : 200;
    const bool validate = count > 3 && std::string_view(arguments[3]) == "validate";
    return nacre::Soak(std::max(frames, 40), std::max(files, 4), validate).run();
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
}
