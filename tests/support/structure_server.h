#pragma once
// Starts structure_server.py, which serves a folder well or badly.

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace nacre::test {

class StructureServer {
public:
    /// @param certificate  serve https with this certificate and key (PEM)
    explicit StructureServer(const std::string& certificate = "", const std::string& key = "") {
        child_ = fork();
        if (child_ < 0) throw std::runtime_error("cannot fork");
        if (child_ == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that is killed leaves no server behind
            const int log = open((logs_ / "log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
            dup2(log, STDOUT_FILENO);
            std::vector<std::string> words{"python3", NACRE_SOURCE_DIR "/tests/support/structure_server.py",
                                           folder_.path()};
            if (!certificate.empty()) words.insert(words.end(), {certificate, key});
            std::vector<char*> pointers;
            for (std::string& word : words) pointers.push_back(word.data());
            pointers.push_back(nullptr);
            execvp(pointers[0], pointers.data());
            _exit(127);
        }
        for (int wait = 0; wait < 600 && port_.empty(); ++wait) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            std::ifstream log(logs_ / "log");
            if (std::getline(log, port_) && log.eof()) port_.clear();  // its end is still to come
        }
        if (port_.empty()) throw std::runtime_error("structure_server.py did not start");
    }
    ~StructureServer() {
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
    }
    StructureServer(const StructureServer&) = delete;
    StructureServer& operator=(const StructureServer&) = delete;

    void serve(const std::string& file, const std::string& content) const {
        std::ofstream(folder_ / file, std::ios::binary) << content;
    }
    /// What an address begins with for files to be served in a way: "ok", "slow", "drop", ...
    std::string base(const std::string& way) const { return "http://localhost:" + port_ + "/" + way; }
    std::string port() const { return port_; }
    /// "GET PATH RANGE IF-RANGE" of every request so far.
    std::vector<std::string> requests() const {
        std::ifstream log(logs_ / "log");
        std::vector<std::string> lines;
        std::string line;
        std::getline(log, line);  // the port
        while (std::getline(log, line)) lines.push_back(line);
        return lines;
    }

private:
    TemporaryFolder folder_, logs_;
    pid_t child_ = -1;
    std::string port_;
};

}  // namespace nacre::test
