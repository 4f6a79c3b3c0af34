#pragma once
// The desktop shell: window, panel and renderer around the viewer.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/desktop/file_dialog.h"
#include "app/desktop/recorder.h"
#include "app/desktop/state_files.h"
#include "app/desktop/view_command.h"
#include "app/desktop/window.h"
#include "app/panel/panel.h"
#include "app/panel/panel_input.h"
#include "app/viewer/session.h"

namespace nacre::app {

class WindowSession {
public:
    /// Opens the window. @throws Error, also that of a molecule that cannot be read, if known by then
    explicit WindowSession(const ViewOptions& options);

    /// Returns when the window is closed.
    void loop();
    /// One turn of the loop: draws, then waits for events. @param longest  seconds
    /// @returns seconds until something is due without further events
    double step(double longest);

    Viewer& viewer() { return session_.viewer(); }
    Panel& panel() { return *panel_; }
    WindowEvents events();

private:
    std::unique_ptr<Panel> makePanel(const Panel* before);
    PixelSize firstSize() const;
    void keepWindowState();
    PanelHost panelHost();
    SessionHost host();
    Renderer& renderer() { return *session_.renderer(); }
    PictureDescription firstView() const;
    ViewerOptions viewerOptions() const;
    /// Seconds since an arbitrary time.
    static double now();
    static const double kStarted;  ///< start of the program
    void input(InputQueue::Kind kind, std::function<void()> handle);
    void rescaled();
    void resized();
    void run(ViewerCommand command);
    void quit();
    void openDialog();
    void saveDialog(const std::string& title, const std::string& suggested, PathChosen chosen);
    void takeChosen();
    void openFiles(std::vector<std::string> paths, bool beside);
    void dropFiles(const std::vector<std::string>& paths);
    void rememberFile();
    bool drawSample();
    std::vector<RecentFile> sampleFiles() const;
    std::string pictureName(const char* extension);
    void savePicture(const PictureWish& wish);
    void writePictureTo(const PictureWish& wish);
    void copyPicture();
    void record(const RecordingWish& wish, const std::vector<PictureDescription>& keys);
    void tellRecording();
    void askWhere(const char* title, const char* extension, void (WindowSession::*write)(const std::string& path));
    void saveView() { askWhere("Save view", ".view.json", &WindowSession::writeView); }
    void writeView(const std::string& path);
    void saveScene() { askWhere("Save as MolViewSpec", ".mvsj", &WindowSession::writeScene); }
    void writeScene(const std::string& path);
    void captureFrame();
    void writeStats();

    ViewOptions options_;
    WindowState remembered_;  // from the last time
    Window window_;
    RecentFiles recent_, samples_;
    bool dark_;
    int textPercent_ = 100;  // of the panel
    std::unique_ptr<Panel> panel_;
    Session session_;
    FileDialog dialog_;
    Recorder recorder_{Window::wake};
    std::string told_;  // state of the recording as last shown
    bool wasRecording_ = false;
    bool quitsOnceSaved_ = false;
    struct Chosen;  // files chosen in the dialog, from its thread
    std::shared_ptr<Chosen> chosen_;
    std::string clipboard_;
    glm::dvec2 pointer_{};
    double scale_ = 0, lastFrame_ = 0, lastShown_ = 0;
    double inputAt_ = 0;             // time of the first input that no frame has answered yet; 0: none
    std::vector<double> latencies_;  // of frames that answered input: milliseconds until they were presented
    std::uint64_t shown_ = 0;        // frames, at the time of lastShown_
    double opening_ = 0, open_ = 0;  // start and end of opening the device
    double sceneShown_ = 0;          // time when the first frame with a scene was presented
    InputQueue inputs_;
    std::size_t triedSamples_ = 0;
    std::vector<RecentFile> shownSamples_;  // in order, with the available pictures
    bool panelDrag_ = false;
};

}  // namespace nacre::app
