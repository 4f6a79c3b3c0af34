// Dialogs of the desktop, asked for over a bus of their own: the portal is a mock in another language and library.

#include "app/desktop/portal.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>

#include "app/desktop/file_dialog.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app {
namespace {

using test::TemporaryFolder;

/// A program that goes on beside the test, until the object goes.
class Companion {
public:
    explicit Companion(const std::vector<std::string>& arguments) {
        int out[2];
        EXPECT_EQ(pipe(out), 0);
        pid_ = fork();
        if (pid_ == 0) {
            dup2(out[1], 1);
            close(out[0]);
            std::vector<char*> argv;
            for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
            argv.push_back(nullptr);
            execvp(argv[0], argv.data());
            _exit(127);
        }
        close(out[1]);
        for (char c; read(out[0], &c, 1) == 1 && c != '\n';) line_ += c;
        close(out[0]);
    }
    ~Companion() {
        kill(pid_, SIGTERM);
        waitpid(pid_, nullptr, 0);
    }
    Companion(const Companion&) = delete;
    /// The first that it wrote.
    const std::string& line() const { return line_; }

private:
    pid_t pid_;
    std::string line_;
};

class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        setenv(name, value.c_str(), 1);
    }
    ~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
    Variable(const Variable&) = delete;

private:
    const char* name_;
    std::optional<std::string> before_;
};

struct Session {
    Companion bus{{"dbus-daemon", "--session", "--nofork", "--nosyslog", "--print-address"}};
    Variable address{"DBUS_SESSION_BUS_ADDRESS", bus.line()};
};

std::vector<std::string> portal(const char* mode) {
    return {"/usr/bin/python3", std::string(NACRE_SOURCE_DIR) + "/tests/desktop/mock_portal.py", mode};
}

TEST(Portal, TellsWhatWasChosen) {
    const Session session;
    for (const char* mode : {"choose", "old"}) {
        const Companion mock(portal(mode));
        ASSERT_EQ(mock.line(), "ready") << "the mock needs python3-dbus and python3-gi";
        EXPECT_TRUE(hasPortal());
        const PortalAnswer answer = openByPortal("Open a structure");
        EXPECT_TRUE(answer.there) << mode;
        EXPECT_EQ(answer.path, "/tmp/two words \u00e9.pdb") << mode;
    }
}

TEST(Portal, SavesUnderTheNameThatWasSuggested) {
    const Session session;
    const Companion mock(portal("choose"));
    const PortalAnswer answer = saveByPortal("Save the picture", "/tmp/a folder/1bna.png");
    EXPECT_EQ(answer.path, "/tmp/a folder/chosen 1bna.png");
}

TEST(Portal, WhoCancelsHasChosenNothing) {
    const Session session;
    const Companion mock(portal("cancel"));
    const PortalAnswer answer = openByPortal("Open a structure");
    EXPECT_TRUE(answer.there);
    EXPECT_EQ(answer.path, std::nullopt);
}

/// What the dialog says, with a zenity on PATH that says so itself.
std::string dialogWithZenity() {
    const TemporaryFolder folder;
    std::ofstream(folder / "zenity") << "#!/bin/sh\necho /tmp/by-zenity.pdb\n";
    std::filesystem::permissions(folder / "zenity", std::filesystem::perms::owner_all);
    const Variable path("PATH", folder.path() + ":/usr/bin:/bin");
    const Variable desktop("XDG_CURRENT_DESKTOP", "GNOME");
    std::promise<std::string> chosen;
    FileDialog dialog;
    dialog.open([&](const std::string& name) { chosen.set_value(name); });
    std::future<std::string> answer = chosen.get_future();
    return answer.wait_for(std::chrono::seconds(20)) == std::future_status::ready ? answer.get() : "nothing";
}

TEST(Portal, ADesktopWithoutOneHasOtherDialogs) {
    {
        const Variable none("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere/bus");
        EXPECT_FALSE(hasPortal());
        EXPECT_FALSE(openByPortal("Open").there);
        EXPECT_EQ(dialogWithZenity(), "/tmp/by-zenity.pdb");
    }
    const Session session;
    EXPECT_FALSE(hasPortal());
    EXPECT_EQ(dialogWithZenity(), "/tmp/by-zenity.pdb");
    const Companion mock(portal("refuse"));
    EXPECT_TRUE(hasPortal());
    EXPECT_EQ(dialogWithZenity(), "/tmp/by-zenity.pdb");
}

TEST(Portal, ItsDialogComesBeforeThoseOfPrograms) {
    const Session session;
    const Companion mock(portal("choose"));
    EXPECT_EQ(dialogWithZenity(), "/tmp/two words \u00e9.pdb");
}

TEST(Portal, PathsOfUris) {
    EXPECT_EQ(pathOfUri("file:///a/b%20c.pdb"), "/a/b c.pdb");
    EXPECT_EQ(pathOfUri("file://host/a%2fb"), "/a/b");
    for (const char* bad :
         {"", "file:", "file://", "file://host", "http://x/y", "file:///a%2", "file:///a%zz", "file:///a%00"})
        EXPECT_EQ(pathOfUri(bad), "") << bad;
}

}  // namespace
}  // namespace nacre::app
