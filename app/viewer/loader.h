#pragma once
// Reads molecules and builds scenes on a thread of its own, so that the window stays alive meanwhile.

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/drawing/map_layers.h"
#include "app/picture/saved_view.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/trajectory/motion.h"

namespace nacre::app {

/// Thrown by Sources::read where a user has to say whether it may go on.
class Question : public std::runtime_error {
public:
    /// @param text  one sentence  @param yes  what the button says that goes on
    /// @param accept  called before the same view is read once more; the viewer's thread
    Question(const std::string& text, std::string yes, std::function<void()> accept)
        : std::runtime_error(text), yes_(std::move(yes)), accept_(std::move(accept)) {}
    const std::string& yes() const { return yes_; }
    void accept() const { accept_(); }

private:
    std::string yes_;
    std::function<void()> accept_;
};

/// How a shell gets at molecules. Called on the loader's thread. @throws Error
struct Sources {
    std::function<Molecule(const PictureDescription&)> read;
    std::function<Representation(const Molecule&, const PictureDescription&)> build;
    /// Share of a download that is there, 0..1; below 0: nothing is downloaded, or how much is not known. Any thread.
    std::function<double()> progress = {};
    /// Makes read() throw soon, where it can. Any thread.
    std::function<void()> cancel = {};
    /// What the atoms of a molecule that was read move by, as the view says; null: they stand still. What it throws is
    /// the failure of the whole. Empty: they always do.
    std::function<std::unique_ptr<Motion>(const std::shared_ptr<const Molecule>&, const PictureDescription&)> motion =
        {};
    /// Fetches what maps of a view are no files; empty: nothing does.
    std::function<void(const PictureDescription&)> maps = {};
};

/// What is shown. The molecule is shared with a build that is under way.
struct Document {
    PictureDescription view;                   ///< as it was asked for
    std::shared_ptr<const Molecule> molecule;  ///< as it was read: the same as long as its file is shown
    Representation scene;
    std::shared_ptr<const Molecule> placed =
        molecule;                              ///< the molecule as it stands in the scene, which may have moved
    double radius = 0;                         ///< that the camera goes by: the scene's before it moved, Å
    std::shared_ptr<Motion> motion = {};       ///< of a molecule that was just read, if its atoms move
    std::shared_ptr<MovingScene> moving = {};  ///< of one whose atoms move
    MapLayers maps = {};                       ///< drawn with the scene
    bool moves() const { return moving != nullptr; }
};

class Loader {
public:
    /// @param wake called on the loader's thread when something is ready
    Loader(Sources sources, std::function<void()> wake) : sources_(std::move(sources)), wake_(std::move(wake)) {}
    /// Waits for what is under way.
    ~Loader();
    Loader(const Loader&) = delete;

    /// Starts with a file. What was under way is finished and thrown away.
    void read(const PictureDescription& view) { start({view, nullptr}); }
    /// The same, of one that is seen for the first time: as it looks best (firstLook()), if the view leaves that open.
    void open(const PictureDescription& view) { start({view, nullptr, true}); }
    /// Starts with what is shown, seen in another way.
    void build(const PictureDescription& view, const Document& shown) {
        start({view, shown.molecule, false, shown.placed, shown.moves(), mapsAlone(view, shown)});
    }
    bool busy() const { return running_.valid() && !cancelled_; }
    /// What is under way, and what waits, is not wanted any more: take() gives nothing of it.
    void cancel();
    double progress() const { return busy() && sources_.progress ? sources_.progress() : -1; }
    /// The view that was read or built last.
    const PictureDescription& view() const { return last_; }
    /// The document when it is ready. @throws what reading or building threw
    std::optional<Document> take();
    /// @throws Error  that take() would throw; anything else waits for it
    void throwFailure();
    /// Waits until take() has something, if anything is under way.
    void wait() const;

private:
    struct Job {
        PictureDescription view;
        std::shared_ptr<const Molecule> molecule;
        bool first = false;                           ///< is seen for the first time
        std::shared_ptr<const Molecule> placed = {};  ///< where it stands
        bool moves = false;
        std::shared_ptr<const Document> shown = {};  ///< which differs in its maps alone
    };
    static std::shared_ptr<const Document> mapsAlone(const PictureDescription& view, const Document& shown);
    void start(Job job);
    void launch(Job job);
    Document load(const Job& job) const;
    void build(Document& document, bool moves) const;

    Sources sources_;
    std::function<void()> wake_;
    PictureDescription last_;
    std::optional<Job> next_;
    bool cancelled_ = false;  // what is running
    std::future<Document> running_;
    std::thread thread_;
};

}  // namespace nacre::app
