#pragma once
// Lines of a GROMACS topology after its preprocessor: without comments, and without what `#ifdef` excludes.

#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/text.h"

namespace nacre {

/// Macros are those that the file defines. Included files are not opened.
class TopLines {
public:
    /// @param name, text  outlive the lines
    TopLines(const std::string& name, std::string_view text) : name_(name), lines_(text) {}

    /// Steps to the next line with words; false at the end. @throws Error for conditions that do not match
    bool next();
    /// The line's words, macros replaced. Valid as long as the lines. A section's heading is one word: "[atoms]".
    const std::vector<std::string_view>& words() const { return words_; }
    std::string_view line() const { return line_; }  ///< before macros are replaced
    std::uint64_t number() const { return lines_.number(); }
    /// Names of included files, and the line of the first.
    const std::vector<std::string_view>& includes() const { return includes_; }
    std::uint64_t firstInclude() const { return firstInclude_; }

private:
    bool readLine();
    void direct(std::string_view line);
    bool isShown() const;

    const std::string& name_;
    LineReader lines_;
    std::string_view line_;
    std::deque<std::string> joined_;  ///< lines that '\' continues
    std::map<std::string_view, std::string_view, std::less<>> macros_;
    std::vector<bool> shown_;  ///< per open condition
    std::vector<std::string_view> words_, includes_;
    std::uint64_t firstInclude_ = 0;
};

}  // namespace nacre
