#include "engine/molecule/formats/top_lines.h"

#include <algorithm>

namespace nacre {

namespace {

constexpr std::size_t kMostConditions = 100;  // within each other

std::string_view withoutComment(std::string_view line) { return trim(line.substr(0, line.find(';'))); }

/// The first word, which is removed from the line.
std::string_view takeWord(std::string_view& line) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    line = trim(line.substr(end));
    return word;
}

}  // namespace

bool TopLines::isShown() const {
    return std::ranges::all_of(shown_, [](bool shown) { return shown; });
}

bool TopLines::readLine() {
    if (!lines_.next()) return false;
    line_ = withoutComment(lines_.line());
    if (line_.empty() || line_.back() != '\\') return true;
    std::string& whole = joined_.emplace_back();
    for (;; line_ = withoutComment(lines_.line())) {
        const bool goesOn = !line_.empty() && line_.back() == '\\';
        whole.append(line_.substr(0, line_.size() - (goesOn ? 1 : 0))).push_back(' ');
        if (!goesOn || !lines_.next()) break;
    }
    line_ = trim(whole);
    return true;
}

void TopLines::direct(std::string_view line) {
    const std::string_view directive = takeWord(line);
    if (directive == "#ifdef" || directive == "#ifndef") {
        if (shown_.size() == kMostConditions) cannotRead(name_, "its conditions are nested too deeply", number());
        shown_.push_back(macros_.contains(takeWord(line)) == (directive == "#ifdef"));
    } else if (directive == "#else" || directive == "#endif") {
        if (shown_.empty()) cannotRead(name_, std::string(directive) + " has no #ifdef", number());
        if (directive == "#else")
            shown_.back() = !shown_.back();
        else
            shown_.pop_back();
    } else if (!isShown()) {
        return;
    } else if (directive == "#define") {
        const std::string_view macro = takeWord(line);
        macros_[macro] = line;
    } else if (directive == "#undef") {
        macros_.erase(takeWord(line));
    } else if (directive == "#include") {
        if (includes_.empty()) firstInclude_ = number();
        const std::size_t quotes = line.size() > 2 ? 1 : 0;
        includes_.push_back(line.substr(quotes, line.size() - 2 * quotes));
    }
}

bool TopLines::next() {
    while (readLine()) {
        if (line_.empty()) continue;
        if (line_.front() == '#') {
            direct(line_);
            continue;
        }
        if (!isShown()) continue;
        if (line_.front() == '[') {
            words_.assign(1, line_);
            return true;
        }
        words_ = splitAllWords(line_);
        for (std::string_view& word : words_)
            if (const auto macro = macros_.find(word); macro != macros_.end()) word = macro->second;
        std::erase_if(words_, [](std::string_view word) { return word.empty(); });
        if (!words_.empty()) return true;
    }
    if (!shown_.empty()) cannotRead(name_, "it ends within #ifdef");
    return false;
}

}  // namespace nacre
