#pragma once
// How a document comes to be shown: what is opened, added and read, in which look it is built, and what the user has
// to answer before.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/stage.h"

namespace nacre::app {

class Reading {
public:
    Reading(Stage& stage, Sources sources, std::function<void()> wake);

    /// Instead of what is shown; several stand together.
    void open(const std::vector<std::string>& paths, double now);
    void open(const std::string& path, double now) { open(std::vector{path}, now); }
    /// Beside what is shown.
    void add(const std::vector<std::string>& paths, double now);
    void add(const std::string& path, double now) { add(std::vector{path}, now); }
    /// What a view says, which is the wanted one already. @param another  it is of other molecules
    void restore(const PictureDescription& view, bool another);
    /// Another model of the same file.
    void readModel(int model);
    /// What is shown, as it is wanted.
    void build() { loader_.build(stage_.view(), stage_.document); }
    /// What is being read is not wanted any more.
    void cancel(double now);

    /// What the user has to answer before the molecule is read; null: nothing.
    const Question* question() const { return question_ ? &*question_ : nullptr; }
    void answer(bool yes, double now);

    /// Of what was asked for at first. @throws what reading it threw, if that is known by now
    void throwEarlyFailure() { loader_.throwFailure(); }
    /// What is under way.
    const Loader& loader() const { return loader_; }
    /// Another molecule than the one that is shown is under way.
    bool another() const;

    /// How a document differs from the one before.
    struct Arrival {
        bool another = false;   ///< other molecules were read
        bool step = false;      ///< of them: another model of the same file
        bool restored = false;  ///< it belongs to the view as it is
    };
    /// The document when it is ready: it is to be put on the screen.
    std::optional<Document> take(double now);
    /// It is the stage's from here on, and the wanted view goes with it.
    Arrival arrive(Document document);

private:
    static std::vector<std::string> divideMaps(std::vector<std::string>& paths);
    void addMaps(const std::vector<std::string>& maps, double now);
    bool beginWith(PictureDescription& view, const std::vector<std::string>& paths, double now);

    Stage& stage_;
    Loader loader_;
    std::optional<Question> question_;
    PictureDescription asked_;  // what question_ is about
    bool restoring_ = false;    // what is being read belongs to the view as it is
    bool first_ = true;         // nothing was shown yet
};

}  // namespace nacre::app
