// Dialogs of the desktop, asked for over a bus of their own: the portal is a mock in another language and library.

#include "app/desktop/portal.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>

#include "app/desktop/file_dialog.h"
#include "tests/desktop/environment.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app {
namespace {

using test::FakePrograms;
using test::Variable;

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

/// A bus that starts no services: a portal that is installed here stays out of it.
class Session {
    std::string settings() const {
        std::ofstream(folder_ / "bus.conf")
            << "<busconfig><type>session</type><listen>unix:dir=" << folder_.path() << "</listen><auth>EXTERNAL</auth>"
            << "<policy context='default'><allow send_destination='*' eavesdrop='true'/><allow eavesdrop='true'/>"
            << "<allow own='*'/></policy></busconfig>\n";
        return "--config-file=" + (folder_ / "bus.conf");
    }
    const test::TemporaryFolder folder_;

public:
    Companion bus{{"dbus-daemon", settings(), "--nofork", "--nosyslog", "--print-address"}};
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
        const PortalAnswer answer = openByPortal("Open structures");
        EXPECT_TRUE(answer.there) << mode;
        EXPECT_EQ(answer.paths, (std::vector<std::string>{"/tmp/two words \u00e9.pdb", "/tmp/another.cif"})) << mode;
    }
}

TEST(Portal, SavesUnderTheNameThatWasSuggested) {
    const Session session;
    const Companion mock(portal("choose"));
    const PortalAnswer answer = saveByPortal("Save image", "/tmp/a folder/1bna.png");
    EXPECT_EQ(answer.paths, std::vector<std::string>{"/tmp/a folder/chosen 1bna.png"});
}

TEST(Portal, WhoCancelsHasChosenNothing) {
    const Session session;
    const Companion mock(portal("cancel"));
    const PortalAnswer answer = openByPortal("Open structures");
    EXPECT_TRUE(answer.there);
    EXPECT_TRUE(answer.paths.empty());
}

using Ask = std::function<void(FileDialog&, const FileDialog::Chosen&)>;
void askToOpen(FileDialog& dialog, const FileDialog::Chosen& chosen) { dialog.open(chosen); }
void askToSave(FileDialog& dialog, const FileDialog::Chosen& chosen) {
    dialog.save("Save image", "my picture.png", chosen);
}

using Paths = std::vector<std::string>;
Paths awaitAnswer(const Ask& ask) {
    std::promise<Paths> chosen;
    std::future<Paths> answer = chosen.get_future();
    FileDialog dialog;
    ask(dialog, [&](const Paths& paths) { chosen.set_value(paths); });
    return answer.wait_for(std::chrono::seconds(60)) == std::future_status::ready ? answer.get() : Paths{"nothing"};
}

/// What the dialog says, with a zenity on PATH that says so itself.
Paths dialogWithZenity() {
    const FakePrograms programs;
    programs.add("zenity", "echo /tmp/by-zenity.pdb");
    const Variable desktop("XDG_CURRENT_DESKTOP", "GNOME");
    return awaitAnswer(askToOpen);
}

TEST(FileDialog, AsksTheProgramOfTheDesktop) {
    const Variable none("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere/bus");
    const FakePrograms programs;
    for (const char* name : {"zenity", "kdialog"})
        programs.addAsked(name, "echo '/home/me/two words.pdb'; echo /b.pdb");
    ASSERT_TRUE(FileDialog::available());
    const auto asked = [&](const char* program, const Ask& ask) {
        EXPECT_EQ(awaitAnswer(ask), (Paths{"/home/me/two words.pdb", "/b.pdb"}));
        const std::string words = test::readContents(programs / (program + std::string(".asked")));
        for (const char* name : {"zenity", "kdialog"})
            std::filesystem::remove(programs / (name + std::string(".asked")));
        return words;
    };
    {
        const Variable desktop("XDG_CURRENT_DESKTOP", "GNOME");
        EXPECT_EQ(asked("zenity", askToOpen), "--file-selection\n--multiple\n--separator=\n\n--title=Open\n");
        EXPECT_EQ(asked("zenity", askToSave),
                  "--file-selection\n--save\n--confirm-overwrite\n--title=Save image\n"
                  "--filename=my picture.png\n");
    }
    const Variable desktop("XDG_CURRENT_DESKTOP", "KDE");
    EXPECT_EQ(asked("kdialog", askToOpen), "--title\nOpen\n--multiple\n--separate-output\n--getopenfilename\n.\n");
    EXPECT_EQ(asked("kdialog", askToSave), "--title\nSave image\n--getsavefilename\nmy picture.png\n");
}

TEST(Portal, ADesktopWithoutOneHasOtherDialogs) {
    {
        const Variable none("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere/bus");
        EXPECT_FALSE(hasPortal());
        EXPECT_FALSE(openByPortal("Open").there);
        EXPECT_EQ(dialogWithZenity(), Paths{"/tmp/by-zenity.pdb"});
    }
    const Session session;
    EXPECT_FALSE(hasPortal());
    EXPECT_EQ(dialogWithZenity(), Paths{"/tmp/by-zenity.pdb"});
    const Companion mock(portal("refuse"));
    EXPECT_TRUE(hasPortal());
    EXPECT_EQ(dialogWithZenity(), Paths{"/tmp/by-zenity.pdb"});
}

TEST(Portal, ItsDialogComesBeforeThoseOfPrograms) {
    const Session session;
    const Companion mock(portal("choose"));
    EXPECT_EQ(dialogWithZenity(), (Paths{"/tmp/two words \u00e9.pdb", "/tmp/another.cif"}));
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
