#include "app/picture/input_names.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "engine/scene/color/colors.h"

namespace nacre::app {
namespace {

/// "1crn" of "data/1crn.cif.gz", "dna" of "sample:dna".
std::string plainName(const std::string& path) {
    std::string name = std::filesystem::path(path.substr(path.rfind(':') + 1)).filename().string();
    name.resize(std::min(name.find('.'), name.size()));
    for (char& c : name)
        if (!isInputName(std::string(1, c))) c = '_';
    return name.empty() || path == "-" ? "input" : name;
}

}  // namespace

bool isInputName(const std::string& text) {
    constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !text.empty() && text.find_first_not_of(kLetters) == std::string::npos;
}

void addInput(InputOptions& input, const std::string& text) {
    if (input.further.size() + 1 >= kMostInputs)
        throw std::invalid_argument("more than " + std::to_string(kMostInputs) + " of them");
    if (!input.namedBy.empty()) {  // explicit inputs replace a view's molecules
        input.path.clear(), input.name.clear(), input.hash.clear(), input.namedBy.clear();
        input.further.clear(), input.fits.clear(), input.alignments.clear();
        if (!input.trajectory.namedBy.empty()) input.trajectory = {};
    }
    const std::size_t equals = text.find('=');
    std::error_code error;
    FurtherInput next{"", text, ""};
    if (equals != std::string::npos && isInputName(text.substr(0, equals)) && !std::filesystem::exists(text, error))
        next = {text.substr(0, equals), text.substr(equals + 1), ""};
    if (input.path.empty()) {
        input.path = next.path;
        input.name = next.name;
    } else {
        input.further.push_back(next);
    }
}

std::vector<std::string> inputNames(const InputOptions& input) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, const std::string& path) {
        std::string wanted = name.empty() ? plainName(path) : name, free = wanted;
        for (int i = 2; std::ranges::find(names, free) != names.end(); ++i) free = wanted + "_" + std::to_string(i);
        names.push_back(free);
    };
    add(input.name, input.path);
    for (const FurtherInput& further : input.further) add(further.name, further.path);
    return names;
}

void nameInputs(const std::vector<std::string>& names, Selection& selection) {
    for (SelectionStep& step : selection.steps) {
        if (step.test != SelectionTest::chain) continue;
        std::vector<NumberRange> models;
        for (const std::string& word : step.words) {
            const auto at = std::find(names.begin(), names.end(), word);
            if (at == names.end()) break;
            const auto number = static_cast<std::int32_t>(at - names.begin() + 1);
            models.push_back({number, number, '\0', '\0'});
        }
        if (models.empty() || models.size() != step.words.size()) continue;
        step.test = SelectionTest::model;
        step.words.clear();
        step.numbers = models;
    }
}

namespace {

std::array<std::optional<Selection>*, 10> optionalSelections(PictureDescription& d) {
    return {&d.aim.lookAt, &d.aim.zoomTo, &d.aim.uncover, &d.aim.center,       &d.aim.orientBy,
            &d.aim.left,   &d.aim.clip,   &d.aim.spares,  &d.look.contacts.of, &d.look.contacts.with};
}

/// Position of `/name` in a selection's text, from a position on; npos: none.
std::size_t findInput(const std::string& text, const std::string& name, std::size_t from = 0) {
    const std::string sought = "/" + name;
    for (std::size_t at = text.find(sought, from); at != std::string::npos; at = text.find(sought, at + 1)) {
        const std::size_t end = at + sought.size();
        if (end == text.size() || !isInputName(text.substr(end, 1))) return at;
    }
    return std::string::npos;
}

void forEachSelection(PictureDescription& d, const std::function<void(Selection&)>& take) {
    for (Rule& rule : d.look.rules) take(rule.selection);
    for (Label& label : d.words.labels) take(label.selection);
    for (Measure& measure : d.words.measures)
        for (Selection& point : measure.points) take(point);
    for (std::optional<Selection>* selection : optionalSelections(d))
        if (*selection) take(**selection);
    for (std::vector<FitOptions>* fits : {&d.input.fits, &d.input.alignments})
        for (FitOptions& fit : *fits) take(fit.moving), take(fit.fixed);
}

/// Whether a selection's text has `/name`.
bool namesInput(const Selection& selection, const std::string& name) {
    return findInput(selection.text, name) != std::string::npos;
}

void forgetNames(PictureDescription& d, const std::vector<std::string>& names) {
    const auto gone = [&](const Selection& selection) {
        return std::ranges::any_of(names, [&](const std::string& name) { return namesInput(selection, name); });
    };
    std::erase_if(d.look.rules, [&](const Rule& rule) { return gone(rule.selection); });
    std::erase_if(d.words.labels, [&](const Label& label) { return gone(label.selection); });
    for (std::vector<FitOptions>* fits : {&d.input.fits, &d.input.alignments})
        std::erase_if(*fits, [&](const FitOptions& fit) { return gone(fit.moving) || gone(fit.fixed); });
    for (std::optional<Selection>* selection : optionalSelections(d))
        if (*selection && gone(**selection)) selection->reset();
    d.words.measures.clear();  // their atom numbers count atoms of all inputs
}

}  // namespace

void nameInputs(PictureDescription& d) {
    if (!d.input.several()) return;
    const std::vector<std::string> names = inputNames(d.input);
    forEachSelection(d, [&](Selection& selection) { nameInputs(names, selection); });
}

void removeInput(PictureDescription& d, std::size_t number) {
    const std::vector<std::string> names = inputNames(d.input);
    const bool alone = d.input.further.size() == 1;  // a single input needs no name
    if (number == 0) {
        const FurtherInput next = d.input.further.front();
        d.input.path = next.path, d.input.name = next.name, d.input.hash = next.hash, d.input.opened = next.opened;
    }
    d.input.further.erase(d.input.further.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(number, 1) - 1));
    forgetNames(d, alone ? names : std::vector{names[number]});
}

void setConformations(PictureDescription& d, bool conformations) {
    d.input.conformations = conformations;
    d.input.model = 1;
    const std::vector<std::string> names = inputNames(d.input);
    conformations ? forgetNames(d, names) : colorApart(names, d.look);
}

void renameInput(PictureDescription& d, std::size_t number, const std::string& name) {
    const std::vector<std::string> names = inputNames(d.input);
    if (!isInputName(name)) throw std::invalid_argument("a name has letters, digits, - and _, not \"" + name + "\"");
    if (name == names[number]) return;
    if (std::find(names.begin(), names.end(), name) != names.end())
        throw std::invalid_argument("another structure is named " + name);
    const std::string& old = names[number];
    forEachSelection(d, [&](Selection& selection) {
        if (!namesInput(selection, old)) return;
        std::string text = selection.text;
        for (std::size_t at = findInput(text, old); at != std::string::npos; at = findInput(text, old, at + 1))
            text.replace(at + 1, old.size(), name);
        selection = parseSelection(text);
    });
    (number == 0 ? d.input.name : d.input.further[number - 1].name) = name;
    nameInputs(d);
}

void colorApart(const std::vector<std::string>& names, RepresentationOptions& look, std::size_t from) {
    if (look.color != Coloring(ColorScheme::element)) return;
    std::vector<Rule> rules;
    for (std::size_t i = from; i < names.size(); ++i) {
        Rule rule;
        rule.action = Rule::Action::color;
        const auto number = static_cast<std::int32_t>(i + 1);
        SelectionStep step;
        step.test = SelectionTest::model;
        step.numbers.push_back({number, number, '\0', '\0'});
        rule.selection.text = "/" + names[i];
        rule.selection.steps.push_back(step);
        // Counts from the palette's end: the chains of the first input use its beginning.
        const std::size_t kinds = kindCount(kChainPalette);
        rule.coloring =
            Coloring::elementWithCarbons(kindColor(i == 0 ? 0 : kinds - 1 - (i - 1) % kinds, kChainPalette));
        rules.push_back(rule);
    }
    look.rules.insert(look.rules.begin(), rules.begin(), rules.end());
}

}  // namespace nacre::app
