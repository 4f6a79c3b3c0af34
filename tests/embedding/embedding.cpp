// Draws a structure file into a picture in memory, and writes that as a PPM: embedding INPUT OUTPUT.ppm
#include <malloc.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "nacre/error.h"
#include "nacre/molecule/drawn_atoms.h"
#include "nacre/molecule/read.h"
#include "nacre/renderer.h"
#include "nacre/scene/build/representation.h"

/// Whether the C library keeps small pieces that were freed in its fast lists, as it does unless it is told otherwise.
bool keepsSmallPieces() {
    std::vector<void*> pieces(100);
    for (void*& piece : pieces) piece = std::malloc(32);
    for (void* piece : pieces) std::free(piece);
    return mallinfo2().smblks > 0;
}

std::string drivers() {
    const char* files = std::getenv("VK_DRIVER_FILES");
    return files ? files : "";
}

int main(int count, char** arguments) try {
    if (count != 3) throw nacre::Error("wrong usage", arguments[0], "wanted: INPUT OUTPUT.ppm");
    const nacre::Molecule molecule = nacre::readMoleculeFile(arguments[1]);
    nacre::Representation scene = nacre::represent(molecule, nacre::drawnAtoms(molecule), {});

    const std::string before = drivers();
    nacre::RenderSettings settings;
    settings.view = nacre::makeView(nacre::Camera{}, scene.radius, 400, 300);
    settings.supersample = 2;
    settings.background = {0, 0, 0, 1};
    nacre::Renderer renderer{nacre::DeviceOptions{}};
    renderer.setScene(std::move(scene));
    const nacre::Picture picture = renderer.render(settings);

    if (!keepsSmallPieces()) throw nacre::Error("the heap", "", "it no longer works as this program had it");
    if (drivers() != before) throw nacre::Error("the environment", drivers(), "it was changed");

    std::ofstream out(arguments[2], std::ios::binary);
    out << "P6 " << picture.width << " " << picture.height << " 255\n";
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) out.put(static_cast<char>(255 * std::pow(picture.rgba[i], 1 / 2.2f) + 0.5f));
    return out.flush() ? 0 : 1;
} catch (const nacre::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
}
