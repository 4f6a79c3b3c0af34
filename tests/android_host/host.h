#pragma once
// Plays Android to one activity of the shell: calls its callbacks on this thread as the system would, and sees what it
// shows. What the system never does (a window after the end, say) it does not do either.

#include <filesystem>
#include <optional>

#include "app/picture/saved_view.h"
#include "tests/android_host/java_machine.h"
#include "tests/android_host/native.h"
#include "tests/android_host/vulkan.h"
#include "tests/android_host/window.h"

namespace nacre::test {

class Host {
public:
    /// @param folder the app's internal data folder
    explicit Host(const std::filesystem::path& folder, std::optional<Document> document = std::nullopt,
                  const std::string& state = {}, std::int32_t density = 160);
    /// Brings the activity to its end, in the system's order, if it is not there yet.
    ~Host();
    Host(const Host&) = delete;

    // The activity's life
    void start();
    void resume();
    void pause();
    void stop();
    void destroy();
    /// start, resume, window and input queue, as when an app opens.
    void open(std::int32_t width, std::int32_t height, int quarterTurns = 0);
    /// What the system would keep of it. Empty: nothing.
    std::string saveState();
    app::PictureDescription view() { return app::parseSavedView(saveState(), "state"); }
    void lowMemory();
    void setDensity(std::int32_t density);
    void setContent(const ARect& content);

    // Window and queue
    void createWindow(std::int32_t width, std::int32_t height, int quarterTurns = 0);
    void resizeWindow(std::int32_t width, std::int32_t height, int quarterTurns);
    void redraw();
    void destroyWindow();
    void createQueue();
    void destroyQueue();

    // Input; places in pixels
    /// @param later seconds from now that the event names as its time
    bool motion(std::int32_t action, std::vector<AInputEvent::Pointer> pointers, double later = 0);
    void tap(float x, float y, int times = 1);
    void drag(float fromX, float fromY, float toX, float toY, int steps = 10);
    bool key(std::int32_t code, std::int32_t action, std::int32_t meta = 0);
    /// @returns whether the app took it, or else the activity would end
    bool back();
    bool scroll(float steps, float x, float y);
    /// A mouse or a pen. @param tool, action, buttons  as AMOTION_EVENT_... has them
    bool pointer(std::int32_t tool, std::int32_t action, float x, float y, std::int32_t buttons = 0);

    // What is seen
    /// The app is held up by the test: its windows may go while it still has them.
    void setHeldUp(bool heldUp) { heldUp_ = heldUp; }
    /// Nothing is left of windows that went.
    bool windowsAreLetGo() const;
    const ANativeWindow* window() const { return window_.get(); }
    bool windowIsThere() const { return window_ != nullptr; }
    std::uint64_t frames() const;
    WindowPicture picture() const;
    JavaMachine& java() { return java_; }
    bool finishAsked() const { return test::finishAsked(&activity_); }
    AInputQueue* queue() { return queue_.get(); }

private:
    std::string folder_;
    JavaMachine java_;
    AAssetManager assets_;
    ANativeActivityCallbacks callbacks_{};
    ANativeActivity activity_{};
    std::unique_ptr<ANativeWindow> window_;
    std::vector<std::unique_ptr<ANativeWindow>> gone_;  // kept, so that whoever still touches one is told
    std::unique_ptr<AInputQueue> queue_;
    bool heldUp_ = false;
    bool started_ = false, resumed_ = false, alive_ = true;
};

}  // namespace nacre::test
