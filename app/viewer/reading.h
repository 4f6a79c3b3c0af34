#pragma once
// Opening of documents: opens, adds and reads files, chooses the look of the result, and asks the user.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/stage.h"

namespace nacre::app {

class Reading {
public:
    Reading(Stage& stage, Sources sources, std::function<void()> wake);

    /// Replaces the document; several files form one, as if added one by one. Maps and trajectories without a structure
    /// join the document; a map without a document is shown alone.
    void open(const std::vector<std::string>& paths, double now);
    void open(const std::string& path, double now) { open(std::vector{path}, now); }
    /// Adds to the document.
    void add(const std::vector<std::string>& paths, double now);
    void add(const std::string& path, double now) { add(std::vector{path}, now); }
    /// Restores a view that is already the wanted one. @param another  it has other molecules
    void restore(const PictureDescription& view, bool another);
    /// Another model of the same file.
    void readModel(int model);
    /// Rebuilds the document for the wanted view.
    void build() { loader_.build(stage_.view(), stage_.document); }
    /// Cancels reading.
    void cancel(double now);
    /// Whether the displayed error is from the last read, which again() repeats.
    bool failed() const { return !failure_.empty() && failure_ == stage_.messages.failure(); }
    void again();

    /// A question for the user before the molecule is read; null: none.
    const Question* question() const { return question_ ? &*question_ : nullptr; }
    void answer(bool yes, double now);

    /// For the initial file. @throws its error, if already known
    void throwEarlyFailure() { loader_.throwFailure(); }
    /// Running work.
    const Loader& loader() const { return loader_; }
    /// Another molecule is being read.
    bool another() const;

    /// Differences of a new document from the previous one.
    struct Arrival {
        bool another = false;   ///< other molecules were read
        bool step = false;      ///< these are another model of the same file
        bool restored = false;  ///< it belongs to the current view
        bool opened = false;    ///< a first look, without its own camera
    };
    /// The document when it is ready, to be shown.
    std::optional<Document> take(double now);
    /// Moves the document to the stage, with its wanted view.
    Arrival arrive(Document document);

private:
    struct Files;
    void addMaps(const std::vector<std::string>& maps, double now);
    void addTrajectory(const std::string& path, double now);
    bool join(const Files& files, double now);
    bool beginWith(PictureDescription& view, const std::vector<std::string>& paths, double now);

    Stage& stage_;
    Loader loader_;
    std::optional<Question> question_;
    PictureDescription asked_;  // the view of question_
    /// How to show the document being read.
    struct Request {
        bool restores = false;  ///< it belongs to the current view
        bool opens = false;     ///< it gets a first look
        bool placed = false;    ///< it is restored with its own camera
    };
    Request request_;
    bool first_ = true;    // nothing was shown yet
    std::string failure_;  // of the last reading
};

}  // namespace nacre::app
