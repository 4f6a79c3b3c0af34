#pragma once
// Reads molecules and builds scenes on a thread of its own, so that the window stays alive meanwhile.

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/shared/saved_view.h"
#include "engine/molecule/molecule.h"

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
    std::function<Molecule(const SavedView&)> read;
    std::function<Representation(const Molecule&, const SavedView&)> build;
    /// Share of a download that is there, 0..1; below 0: nothing is downloaded, or how much is not known. Any thread.
    std::function<double()> progress = {};
    /// Makes read() throw soon, where it can. Any thread.
    std::function<void()> cancel = {};
};

/// What is shown. The molecule is shared with a build that is under way.
struct Document {
    SavedView view;  ///< as it was asked for
    std::shared_ptr<const Molecule> molecule;
    Representation scene;
};

class Loader {
public:
    /// @param wake called on the loader's thread when something is ready
    Loader(Sources sources, std::function<void()> wake) : sources_(std::move(sources)), wake_(std::move(wake)) {}
    /// Waits for what is under way.
    ~Loader();
    Loader(const Loader&) = delete;

    /// Starts with a file. What was under way is finished and thrown away.
    void read(const SavedView& view) { start({view, nullptr}); }
    /// The same, of one that is seen for the first time: as it looks best (firstLook()), if the view leaves that open.
    void open(const SavedView& view) { start({view, nullptr, true}); }
    /// Starts with a molecule that is there, seen in another way.
    void build(const SavedView& view, std::shared_ptr<const Molecule> molecule) { start({view, std::move(molecule)}); }
    bool busy() const { return running_.valid() && !cancelled_; }
    /// What is under way, and what waits, is not wanted any more: take() gives nothing of it.
    void cancel();
    double progress() const { return busy() && sources_.progress ? sources_.progress() : -1; }
    /// The view that was read or built last.
    const SavedView& view() const { return last_; }
    /// The document when it is ready. @throws what reading or building threw
    std::optional<Document> take();
    /// @throws Error  that take() would throw; anything else waits for it
    void throwFailure();
    /// Waits until take() has something, if anything is under way.
    void wait() const;

private:
    struct Job {
        SavedView view;
        std::shared_ptr<const Molecule> molecule;
        bool first = false;  ///< is seen for the first time
    };
    void start(Job job);
    void launch(Job job);
    Document load(const Job& job) const;

    Sources sources_;
    std::function<void()> wake_;
    SavedView last_;
    std::optional<Job> next_;
    bool cancelled_ = false;  // what is running
    std::future<Document> running_;
    std::thread thread_;
};

}  // namespace nacre::app
