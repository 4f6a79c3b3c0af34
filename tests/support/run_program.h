#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/support/no_cache.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {

struct Outcome {
    int code = -1;  ///< exit code; -1 after a signal
    std::string out, err;
};

/// Runs `nacre ARGUMENTS` by the shell, in the folder. @param before what the shell does first
inline Outcome nacreIn(const TemporaryFolder& folder, const std::string& arguments, const std::string& redirection = "",
                       const std::string& before = "true") {
    const TemporaryFolder logs;
    const std::string command = "cd '" + folder.path() + "' && " + before + " && '" NACRE_PROGRAM "' " + arguments +
                                " >'" + (logs / "out") + "' 2>'" + (logs / "err") + "' </dev/null " + redirection;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readContents(logs / "out"), readContents(logs / "err")};
}

/// The same for a run that is to succeed.
inline Outcome nacreDone(const TemporaryFolder& folder, const std::string& arguments,
                         const std::string& redirection = "", const std::string& before = "true") {
    Outcome outcome = nacreIn(folder, arguments, redirection, before);
    EXPECT_EQ(outcome.code, 0) << "nacre " << arguments << ": " << outcome.err << outcome.out;
    return outcome;
}

}  // namespace nacre::test
