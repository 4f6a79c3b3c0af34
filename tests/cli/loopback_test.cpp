// Libraries that the program loads listen on this machine alone.

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/run_program.h"

namespace nacre::test {
namespace {

TEST(Loopback, IsWhereLibrariesListenThatAskForAnyAddress) {
    const TemporaryFolder folder;
    const std::filesystem::path library = folder / "late_bind.so";  // LD_PRELOAD ends a path at a space
    std::filesystem::create_symlink(NACRE_LATE_BIND, library);
    const std::string preload =
        "export LD_PRELOAD='" + library.string() + "' ASAN_OPTIONS=\"$ASAN_OPTIONS:verify_asan_link_order=0\"";
    const Outcome run = nacreDone(folder, "--version", "", preload);
    EXPECT_TRUE(run.out.ends_with("bound to 127.0.0.1\nbound to ::1\nbound to 127.0.0.2\n") ||
                run.out.ends_with("bound to 127.0.0.1\nnot bound\nbound to 127.0.0.2\n"))  // no IPv6 here
        << run.out;
}

}  // namespace
}  // namespace nacre::test
