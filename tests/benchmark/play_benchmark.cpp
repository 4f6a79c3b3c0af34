// How fast a trajectory plays: play_benchmark [ATOMS|FILE [FRAMES [SEL]]] writes one as DCD, plays it as a window does
// (frames are made by the player's thread while the one before is drawn, 640x960, spacefill, without occlusion, one
// sample a pixel, nothing read back), and says what a frame took on the clock and in processor time of all threads.
// With SEL, in sticks with the interactions of a selection. The device is the one that VK_DRIVER_FILES names.

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "app/viewer/player.h"
#include "engine/milliseconds.h"
#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"

namespace {

using namespace nacre;

constexpr std::uint32_t kWidth = 640, kHeight = 960;

/// A ball of alternating elements as dense as a protein, 10 cubic Å an atom.
Molecule makeBall(std::size_t atoms) {
    Molecule molecule;
    molecule.chains.push_back({"A", 1});
    molecule.subchains.emplace_back("A");
    molecule.residues.push_back({});
    molecule.residues[0].atomCount = static_cast<std::uint32_t>(atoms);
    const double step = std::cbrt(10.0), radius = step * std::cbrt(3.0 * static_cast<double>(atoms) / (4 * 3.14159265));
    const int most = static_cast<int>(radius / step) + 2;
    for (int x = -most; x <= most; ++x)
        for (int y = -most; y <= most; ++y)
            for (int z = -most; z <= most; ++z) {
                const glm::dvec3 p = step * glm::dvec3(x, y, z);
                if (glm::dot(p, p) > radius * radius || molecule.atoms.size() == atoms) continue;
                constexpr Element kElements[] = {6, 6, 7, 8};
                Atom atom;
                atom.position = p;
                atom.element = kElements[static_cast<std::size_t>(x + y + z + 3 * most) % 4];
                molecule.atoms.push_back(atom);
            }
    molecule.residues[0].atomCount = static_cast<std::uint32_t>(molecule.atoms.size());
    return molecule;
}

void writeRecord(std::ofstream& out, const void* data, std::size_t bytes) {
    const auto length = static_cast<std::int32_t>(bytes);
    out.write(reinterpret_cast<const char*>(&length), 4);
    out.write(static_cast<const char*>(data), length);
    out.write(reinterpret_cast<const char*>(&length), 4);
}

void writeTrajectory(const std::string& path, const Molecule& molecule, int frames, float amplitude) {
    std::ofstream out(path, std::ios::binary);
    std::int32_t head[21] = {};
    std::memcpy(head, "CORD", 4);
    head[1] = frames;
    head[2] = head[3] = 1;
    head[20] = 24;
    writeRecord(out, head, sizeof head);
    std::string title(84, ' ');
    const std::int32_t lines = 1;
    std::memcpy(title.data(), &lines, 4);
    writeRecord(out, title.data(), title.size());
    const auto atoms = static_cast<std::int32_t>(molecule.atoms.size());
    writeRecord(out, &atoms, 4);
    std::vector<float> values(molecule.atoms.size());
    for (int frame = 0; frame < frames; ++frame)
        for (int k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = molecule.atoms[i].position[k] +
                            amplitude * std::sin(0.3f * static_cast<float>(frame) + static_cast<float>(i * (k + 1)));
            writeRecord(out, values.data(), values.size() * sizeof(float));
        }
}

double processorMs() { return static_cast<double>(std::clock()) * 1e3 / CLOCKS_PER_SEC; }

}  // namespace

int main(int argc, char** argv) {
    const std::size_t atoms = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100'000;
    const bool named = atoms == 0 || std::filesystem::exists(argc > 1 ? argv[1] : "");
    const int frames = argc > 2 ? std::atoi(argv[2]) : 60;
    const std::string path =
        (std::filesystem::temp_directory_path() / ("nacre-play-" + std::to_string(getpid()) + ".dcd")).string();
    const auto molecule = std::make_shared<const Molecule>(named ? readMoleculeFile(argv[1]) : makeBall(atoms));
    writeTrajectory(path, *molecule, frames, named ? 0.1f : 0.5f);
    {
        const auto motion = std::make_shared<Motion>(openTrajectory(path), *molecule, MotionOptions{});
        app::PictureDescription picture;
        RepresentationOptions& look = picture.look;
        look.style = argc > 3 ? Style::licorice : Style::spacefill;
        if (argc > 3 && std::string(argv[3]) != "none") look.contacts.of = parseSelection(argv[3]);
        const auto moving = std::make_shared<app::MovingPicture>(*molecule, picture);
        Renderer renderer{DeviceOptions{}};
        RenderSettings settings{.view = makeView(Camera{}, moving->radius(), kWidth, kHeight)};
        settings.occlusion.directions = 0;
        settings.supersample = 1;
        renderer.setScene(moving->moved(*molecule));
        renderer.drawFrame(settings);  // compiles what it needs
        app::Player player(molecule, motion, {});
        player.setScene(moving);
        player.want(0);
        player.wait();
        double least = 1e9;
        std::size_t contacts = 0;
        const double processor = processorMs();
        const auto began = Clock::now();
        for (int frame = 0; frame < frames; ++frame) {
            const auto start = Clock::now();
            player.wait();
            app::PlayedFrame played = *player.take();
            if (frame + 1 < frames) player.want(static_cast<std::size_t>(frame + 1));
            contacts = std::max(contacts, played.scene.contacts.size());
            renderer.moveScene(std::move(played.scene));
            renderer.drawFrame(settings);
            least = std::min(least, millisecondsSince(start));
        }
        const double count = frames;
        std::printf(
            "%zu atoms, %d frames, %zu interactions at most, %ux%u, %s: %.1f ms a frame on the clock (least %.1f), "
            "%.1f of processor time; "
            "%.0f frames per second\n",
            molecule->atoms.size(), frames, contacts, kWidth, kHeight, renderer.stats().device.name.c_str(),
            millisecondsSince(began) / count, least, (processorMs() - processor) / count,
            1000 * count / millisecondsSince(began));
    }
    std::filesystem::remove(path);
}
