#pragma once
// Variables of the environment, and programs that are not there otherwise, as long as an object lives.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "tests/support/temporary_folder.h"

namespace nacre::test {

class Variable {
public:
    Variable(const char* name, const std::optional<std::string>& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        set(value);
    }
    ~Variable() { set(before_); }
    Variable(const Variable&) = delete;

private:
    void set(const std::optional<std::string>& value) const {
        value ? setenv(name_, value->c_str(), 1) : unsetenv(name_);
    }
    const char* name_;
    std::optional<std::string> before_;
};

/// Programs that PATH has first: shell scripts.
class FakePrograms {
public:
    void add(const std::string& name, const std::string& script) const {
        std::ofstream(folder_ / name) << "#!/bin/sh\n" << script << "\n";
        std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
    }
    /// One that writes its arguments, a line each, to NAME.asked.
    void addAsked(const std::string& name, const std::string& more) const {
        add(name, "printf '%s\\n' \"$@\" > '" + folder_ / (name + ".asked") + "'; " + more);
    }
    std::string operator/(const std::string& name) const { return folder_ / name; }

private:
    TemporaryFolder folder_;
    Variable path_{"PATH", folder_.path() + ":/usr/bin:/bin"};
};

}  // namespace nacre::test
