#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace nacre::app {

/// The desktop's file dialog, on a separate thread: the portal's if there is one, else kdialog under KDE, zenity,
/// kdialog.
class FileDialog {
public:
    using Chosen = std::function<void(const std::vector<std::string>& paths)>;

    ~FileDialog();
    static bool available();
    /// For one or several files.
    /// @param chosen  called with the paths on the dialog's thread; not if the user cancels. Does nothing while a
    /// dialog is open
    void open(Chosen chosen);
    /// As above for a file to be written. @param suggested  its name, or a path
    void save(const std::string& title, const std::string& suggested, Chosen chosen);

private:
    void run(std::function<std::vector<std::string>()> ask, Chosen chosen);

    std::thread thread_;
    std::shared_ptr<std::atomic<bool>> busy_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace nacre::app
