#pragma once
// The message of the exception that a call throws.

#include <gtest/gtest.h>

#include <string>

#include "engine/error.h"

namespace nacre::test {

/// The message of the exception that a call throws; empty if it throws none.
template <typename Exception = Error, typename Call>
std::string errorText(const Call& call) {
    try {
        call();
    } catch (const Exception& error) {
        return error.what();
    }
    return "";
}

/// A call throws, and the message contains a text.
template <typename Exception = Error, typename Call>
void expectThrows(const Call& call, const std::string& part) {
    const std::string text = errorText<Exception>(call);
    EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

}  // namespace nacre::test
