// Pictures that the window saves by its own key: window_pictures JOBS. Each line of JOBS is a job as `nacre batch` has
// it, of the window's size; its pictures go to `output` in the current folder. Needs a display.

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/desktop/window_session.h"
#include "app/drawing/complete.h"
#include "app/picture/option_json.h"
#include "engine/error.h"

namespace {

using namespace nacre;
using namespace nacre::app;

constexpr double kLongest = 60;  // seconds of one picture
constexpr const char* kBetween = "sample:glucose";

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

PictureDescription parseDescription(const std::string& job) {
    PictureDescription picture;
    setOptions(parseOptionValues(job), picture);
    completePicture(picture);
    return picture;
}

bool isShown(const Viewer& viewer) {
    return viewer.document() && !viewer.reading().loader().busy() &&
           !rebuildFor(viewer.document()->drawing.description(), viewer.view(), CameraBy::hand).any();
}

/// Runs the window until something holds. @throws Error
void runUntil(WindowSession& window, const std::string& what, const std::function<bool()>& holds) {
    for (const double end = now() + kLongest; !holds();) {
        if (now() > end) throw Error("waited too long", what, window.viewer().messages().failure());
        window.step(0.02);
    }
}

void savePictures(const std::vector<std::string>& jobs) {
    ViewOptions options;
    options.first.input.path = "sample:glucose";
    options.first.input.cache = "off";
    options.first.size = parseDescription(jobs.front()).size;
    WindowSession window(options);
    for (const std::string& job : jobs) {
        const PictureDescription picture = parseDescription(job);
        // Another file in between: restyling what is shown would keep the camera of the picture before.
        PictureDescription between;
        between.input.path = picture.input.path == kBetween ? "sample:buckyball" : kBetween;
        for (const PictureDescription& next : {between, picture}) {
            window.viewer().show(next, now(), 1e-3);
            runUntil(window, picture.output, [&] { return isShown(window.viewer()); });
        }
        for (const double end = now() + 0.1; now() < end;) window.step(0.02);  // the flight of the camera
        const std::string saved = "saved ";
        window.events().character(U'i');
        runUntil(window, picture.output, [&] {
            return window.viewer().messages().message().starts_with(saved) ||
                   !window.viewer().messages().failure().empty();
        });
        if (!window.viewer().messages().failure().empty())
            throw Error("cannot save", picture.output, window.viewer().messages().failure());
        std::filesystem::rename(window.viewer().messages().message().substr(saved.size()), picture.output);
        window.viewer().messages().clear();
    }
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) return 2;
    std::ifstream file(argv[1]);
    std::vector<std::string> jobs;
    for (std::string line; std::getline(file, line);) jobs.push_back(line);
    savePictures(jobs);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "window_pictures: %s\n", error.what());
    return 1;
}
