// What the viewer shows: what is opened and read, and in which look it is built.

#include <utility>

#include "app/picture/input_names.h"
#include "app/viewer/viewer.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

/// Which molecules a view is of, and where they come from.
void takeInput(const SavedView& from, SavedView& to) {
    to.input = from.input;
    to.format = from.format;
    to.model = from.model;
    to.trajectory = from.trajectory;
    to.name = from.name;
    to.further = from.further;
    to.fits = from.fits;
    to.look.assembly = from.look.assembly;
}

}  // namespace

void Viewer::open(const std::vector<std::string>& paths, double now) {
    if (paths.empty()) return;
    question_.reset();
    dismissFailure();
    remember();
    restoring_ = false;
    SavedView fresh = view();
    fresh.input = paths.front();
    fresh.format.reset();
    fresh.model = 1;
    fresh.trajectory = {};
    fresh.name.clear();
    fresh.further.clear();
    fresh.fits.clear();
    fresh.look.assembly.clear();
    fresh.look.rules.clear();
    fresh.words.labels.clear();
    fresh.words.measures.clear();
    fresh.words.title.clear();
    fresh.camera = {};
    fresh.camera.projection = view_.camera.projection;
    if (!join(fresh, {paths.begin() + 1, paths.end()}, now)) return;
    loader_.open(fresh);
    schedule_.overlayChanged();
}

void Viewer::add(const std::vector<std::string>& paths, double now) {
    if (!document()) return open(paths, now);
    question_.reset();
    dismissFailure();
    remember();
    restoring_ = false;
    SavedView more = view();
    more.model = 1;  // models of one are nothing to the others
    more.trajectory = {};
    more.look.assembly.clear();
    more.camera.pan = {};
    more.camera.zoom = 1;
    if (!join(more, paths, now)) return;
    loader_.read(more);
    schedule_.overlayChanged();
}

/// Further molecules beside a view's. @returns whether there is room for them
bool Viewer::join(SavedView& view, const std::vector<std::string>& paths, double now) {
    const std::size_t before = view.further.size() + 1;
    if (before + paths.size() > kMostInputs) {
        fail("more than 100 molecules are not shown together", now);
        return false;
    }
    for (const std::string& path : paths) view.further.push_back({"", path, ""});
    if (!paths.empty()) colorApart(inputNames(inputOf(view)), view.look, before);
    return true;
}

void Viewer::answer(bool yes, double now) {
    if (!question_) return;
    const Question question = *question_;
    question_.reset();
    schedule_.overlayChanged();
    if (!yes) return say("not opened", now);
    question.accept();
    loader_.read(asked_);
}

void Viewer::cancelLoading(double now) {
    if (!loader_.busy()) return;
    loader_.cancel();
    say("stopped", now);
}

void Viewer::setLook(const SavedView& look, double now, bool continues) {
    const SavedView before = view();
    if (!continues) remember();
    unremembered_ = true;
    view_ = look;
    nameInputs(view_);
    view_.camera = before.camera;
    motion_.setProjection(look.camera.projection);
    changed(now);
    // What cannot be said of this molecule is not kept.
    if (view_.words != before.words && !putWords(now)) view_.words = before.words;
    const bool scene = view_.look != before.look || look.drawn != before.drawn;
    // What is being read is seen in this look once it is there.
    const bool reading = loader_.busy() && loader_.view().input != document_.view.input;
    if (scene && document_.molecule && !reading) loader_.build(view(), document_);
    if (look.occlusionDirections != before.occlusionDirections) occlusion_ = look.occlusionDirections ? 0 : 1;
}

/// Finds the places of the words. @returns whether all of them have one
bool Viewer::putWords(double now) {
    if (!document()) return true;
    schedule_.overlayChanged();
    try {
        placedWords_ = placeWords(view_.words, *document_.placed, document_.scene, WordsOfHidden::leftOut);
        if (!placedWords_.leftOut.empty())
            say("Not shown while its atoms are not drawn: " + placedWords_.leftOut.front() +
                    (placedWords_.leftOut.size() > 1
                         ? " and " + std::to_string(placedWords_.leftOut.size() - 1) + " more"
                         : ""),
                now);
        return true;
    } catch (const Error& error) {
        say(error.what(), now);
        return false;
    }
}

void Viewer::tookDocument(double now) {
    std::optional<Document> document;
    try {
        document = loader_.take();
    } catch (const Question& question) {
        question_ = question;
        asked_ = loader_.view();
        return schedule_.overlayChanged();
    } catch (const std::exception& error) {
        if (std::exchange(restoring_, false) && Viewer::document()) takeInput(document_.view, view_);
        fail(error.what(), now);
        return;
    }
    if (!document) return;
    question_.reset();
    try {
        screen_.setScene(document->scene);
        sceneThere_ = true;
    } catch (const Error& error) {
        if (!noticeLoss()) return fail(error.what(), now);  // the document before stays
        sceneThere_ = false;                                // on the next device
    }
    const bool another = document->molecule != document_.molecule;
    // Another model of the same file: the camera stays in the hand that turns it.
    const bool step = another && document_.molecule && document->view.input == document_.view.input &&
                      document->view.model != document_.view.model;
    document_ = std::move(*document);
    if (another) {
        picks_.clear();
        takeInput(document_.view, view_);
        if (!step && !view_.look.style) {
            view_.look.style = document_.view.look.style;
            view_.look.color = document_.view.look.color;
        }
        if (!firstDocument_ && !step && !restoring_) {
            view_.look.rules = document_.view.look.rules;
            view_.words = document_.view.words;
            motion_.set(document_.view.camera);
        }
        firstDocument_ = false;
        if (!step) {
            message_.clear();
            playback_.stop();
        }
        if (aim_.any()) takeAim(std::exchange(aim_, {}), false, now);
    }
    takePlayer(another, step);
    putWords(now);
    if (another) select(step ? selected_.text : "");
    placeSelection();
    hoverAgain(now);
    if (history_.empty())
        history_.begin(view());
    else if (!std::exchange(restoring_, false))
        unremembered_ = true;
    occlusion_ = view_.occlusionDirections ? 0 : 1;
    occlusionRetry_ = {};
    if (!document_.scene.warnings.empty()) say(document_.scene.warnings.front(), now);
    changed(now);
    if (another && (view_.look != document_.view.look || view_.drawn != document_.view.drawn))
        loader_.build(view(), document_);
}

}  // namespace nacre::app
