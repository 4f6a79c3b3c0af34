#pragma once
// The desktop shell: window, panel and renderer about the viewer.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/desktop/file_dialog.h"
#include "app/desktop/recent_files.h"
#include "app/desktop/recorder.h"
#include "app/desktop/view_options.h"
#include "app/desktop/window.h"
#include "app/panel/input_queue.h"
#include "app/panel/panel.h"
#include "app/viewer/session.h"

namespace nacre::app {

class WindowSession {
public:
    /// Opens the window. @throws Error, that of the molecule too, if it cannot be read and that is known by then
    explicit WindowSession(const ViewOptions& options);

    /// Stays until the window is closed.
    void loop();
    /// One turn of the loop: draws, then waits for events. @param longest  seconds
    /// @returns seconds until something is due, had nothing happened
    double step(double longest);

    Viewer& viewer() { return session_.viewer(); }
    Panel& panel() { return *panel_; }
    WindowEvents events();

private:
    std::unique_ptr<Panel> makePanel();
    PanelHost panelHost();
    SessionHost host();
    Renderer& renderer() { return *session_.renderer(); }
    PictureDescription firstView() const;
    ViewerOptions viewerOptions() const;
    /// Seconds, from some time on.
    static double now();
    static const double kStarted;  ///< when the program was
    void input(InputQueue::Kind kind, std::function<void()> handle);
    void command(const KeyEvent& key);
    void rescaled();
    void resized();
    void run(ViewerCommand command);
    void quit();
    void openDialog();
    void saveDialog(const std::string& suggested);
    void takeChosen();
    void openFiles(std::vector<std::string> paths);
    void rememberFile();
    std::string pictureName(const char* extension);
    void savePicture(const PictureWish& wish);
    void writePictureTo(const PictureWish& wish);
    void copyPicture();
    void record(const RecordingWish& wish, const std::vector<PictureDescription>& keys);
    void tellRecording();
    void saveView();
    void captureFrame();
    void writeStats();

    ViewOptions options_;
    Window window_;
    RecentFiles recent_;
    bool dark_;
    std::unique_ptr<Panel> panel_;
    Session session_;
    FileDialog dialog_;
    Recorder recorder_{Window::wake};
    std::string told_;  // of the film that is being recorded
    bool wasRecording_ = false;
    struct Chosen;  // by the dialog's thread
    std::shared_ptr<Chosen> chosen_;
    std::string clipboard_;
    glm::dvec2 pointer_{};
    double scale_ = 0, lastFrame_ = 0, lastShown_ = 0;
    double inputAt_ = 0;             // when the first input came that no frame has answered; 0: none did
    std::vector<double> latencies_;  // of frames that answered some, milliseconds until they were handed to the display
    std::uint64_t shown_ = 0;        // frames, when lastShown_ was
    double opening_ = 0, open_ = 0;  // when the device was asked for, and when it was there
    double sceneShown_ = 0;          // when the first frame with a scene was handed to the display
    InputQueue inputs_;
    bool panelDrag_ = false;
    std::string remembered_;  // the input that stands first among the recent files
};

}  // namespace nacre::app
