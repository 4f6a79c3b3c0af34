#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/run_program.h"

namespace nacre::test {

/// One line, and it starts as every error does.
inline void expectOneErrorLine(const Outcome& outcome) {
    EXPECT_EQ(outcome.err.rfind("nacre: error: ", 0), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

}  // namespace nacre::test
