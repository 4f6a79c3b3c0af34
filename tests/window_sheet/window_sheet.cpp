// Every screen and state of the window, each as a picture. Drives the window from
// within, by the names of its controls, on the display that it finds. tools/window_sheet makes one sheet of them.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/window_sheet/driver.h"

// X11's names are apart from ours.
namespace {

/// What the display shows from its top left, where the window stands.
void writePicture(Display* display, const std::string& path, unsigned width, unsigned height) {
    XSync(display, False);
    XImage* image = XGetImage(display, DefaultRootWindow(display), 0, 0, width, height, AllPlanes, ZPixmap);
    std::ofstream out(path, std::ios::binary);
    out << "P6\n" << width << " " << height << "\n255\n";
    for (unsigned y = 0; y < height; ++y)
        for (unsigned x = 0; x < width; ++x) {
            const unsigned long pixel = XGetPixel(image, static_cast<int>(x), static_cast<int>(y));
            for (const int shift : {16, 8, 0}) out.put(static_cast<char>(pixel >> shift & 255));
        }
    XDestroyImage(image);
}

void setScale(Display* display, double scale) {
    const std::string text = "Xft.dpi:\t" + std::to_string(std::lround(96 * scale)) + "\n";
    XChangeProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    XSync(display, False);
}

}  // namespace

namespace nacre::app {
namespace {

int main(int argc, char** argv) {
    const std::string folder = argv[1], protein = argv[2], models = argv[3];
    const double scale = std::atof(argv[4]);
    Display* display = XOpenDisplay(nullptr);
    if (!display) return std::cerr << "there is no display\n", 1;
    setScale(display, scale);
    for (const State& state : states(protein, models)) {
        bool wanted = argc < 6;
        for (int i = 5; i < argc; ++i) wanted |= std::string(state.name).find(argv[i]) != std::string::npos;
        if (!wanted) continue;
        ViewOptions options;
        options.first.size = state.size;
        options.first.input.path = state.input;
        options.first.occlusion.directions = 32;
        options.restore = options.first.input.path.empty();
        if (options.first.input.path.starts_with("pdb:"))  // as a view names it
            options.first.input.namedBy = "haemoglobin.view.json";
        Driver driver(options);
        state.act(driver);
        if (driver.rests) {
            driver.settle();
            driver.pause(0.2);
        }
        const PixelSize size = driver.viewer().frames().size();
        const std::string name = std::string(state.name) + (scale == 1 ? "" : ", 200 %");
        writePicture(display, folder + "/" + name + ".ppm", size.width, size.height);
    }
    XCloseDisplay(display);
    return 0;
}

}  // namespace
}  // namespace nacre::app

int main(int argc, char** argv) {
    // A film is made by another process of the program that shows the window.
    if (argc > 1 && std::string(argv[1]) == "movie") {
        const auto nacre = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "nacre";
        execv(nacre.c_str(), argv);
        return std::perror(nacre.c_str()), 1;
    }
    if (argc < 5) return std::cerr << "window_sheet FOLDER PROTEIN MODELS SCALE [STATE...]\n", 2;
    try {
        return nacre::app::main(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
