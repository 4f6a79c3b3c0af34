#pragma once
// Reads molecules and builds scenes on a worker thread, so that the window stays responsive.

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/drawing/drawing.h"
#include "app/picture/saved_view.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/trajectory/motion.h"

namespace nacre::app {

/// Thrown by Sources::read if the user must confirm first.
class Question : public std::runtime_error {
public:
    /// @param text  one sentence  @param yes  label of the button that continues
    /// @param accept  called before the same view is read again; on the viewer's thread
    Question(const std::string& text, std::string yes, std::function<void()> accept)
        : std::runtime_error(text), yes_(std::move(yes)), accept_(std::move(accept)) {}
    const std::string& yes() const { return yes_; }
    void accept() const { accept_(); }

private:
    std::string yes_;
    std::function<void()> accept_;
};

/// A shell's access to molecules. Called on the loader's thread. @throws Error
struct Sources {
    std::function<Molecule(const PictureDescription&)> read;
    /// Finished share of a download, 0..1; negative: no download, or unknown. Thread-safe.
    std::function<double()> progress = {};
    /// Makes read() throw soon, if possible. Thread-safe.
    std::function<void()> cancel = {};
    /// The motion of a molecule's atoms in the view; null: none. Its exceptions are those of loading. If empty, atoms
    /// never move.
    std::function<std::unique_ptr<Motion>(const std::shared_ptr<const Molecule>&, const PictureDescription&)> motion =
        {};
    /// Downloads a view's maps that are not files; empty: not supported.
    std::function<void(const PictureDescription&)> maps = {};
};

/// The displayed document. A running build shares the molecule.
struct Document {
    PictureDescription view;                            ///< as requested
    std::shared_ptr<const Molecule> molecule;           ///< as read: unchanged while its file is shown
    std::shared_ptr<const Molecule> placed = molecule;  ///< the molecule at its current positions
    Drawing drawing{CameraBy::hand};                    ///< of `placed`
    std::shared_ptr<Motion> motion = {};                ///< of a molecule just read, if its atoms move
    bool moves() const { return drawing.moving() != nullptr; }
};

class Loader {
public:
    /// @param wake called on the loader's thread when something is ready
    Loader(Sources sources, std::function<void()> wake) : sources_(std::move(sources)), wake_(std::move(wake)) {}
    /// Waits for running work.
    ~Loader();
    Loader(const Loader&) = delete;

    /// Starts reading a file. The result of running work is dropped.
    void read(const PictureDescription& view) { start({view, nullptr}); }
    /// As above for a first look: in the default style (takeDefaultLook()), unless the view sets one.
    void open(const PictureDescription& view) { start({view, nullptr, true}); }
    /// Repeats the last read, which failed.
    void again() { start({last_, nullptr, lastFirst_}); }
    /// Rebuilds the current document for another view.
    void build(const PictureDescription& view, const Document& shown);
    bool busy() const { return running_.valid() && !cancelled_; }
    /// Cancels running and waiting work: take() never returns it.
    void cancel();
    double progress() const { return busy() && sources_.progress ? sources_.progress() : -1; }
    /// The view most recently read or built.
    const PictureDescription& view() const { return last_; }
    /// The document when it is ready. @throws errors of reading or building
    std::optional<Document> take();
    /// Throws the Error that take() would throw; keeps everything else for take().
    void throwFailure();
    /// Waits until take() has something, if work is running.
    void wait() const;

private:
    struct Job {
        PictureDescription view;
        std::shared_ptr<const Molecule> molecule;
        bool first = false;                           ///< first look
        std::shared_ptr<const Molecule> placed = {};  ///< its current positions
        bool moves = false;
        Drawing shown{CameraBy::hand};     ///< its scene is kept, if it has one
        std::optional<Bounds> frame = {};  ///< of the previous document: hiding and restyling keep the camera
    };
    void start(Job job);
    void launch(Job job);
    Document load(Job& job) const;

    Sources sources_;
    std::function<void()> wake_;
    PictureDescription last_;
    bool lastFirst_ = false;  // it was a first look
    std::optional<Job> next_;
    bool cancelled_ = false;  // the running work
    std::future<Document> running_;
    std::thread thread_;
};

}  // namespace nacre::app
