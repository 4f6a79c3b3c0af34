#include "app/cli/movie_report.h"

#include <cerrno>
#include <csignal>
#include <cstring>

#include "app/files/output_file.h"
#include "engine/error.h"

namespace nacre::app {

MovieReport::MovieReport(const std::string& path) {
    if (path.empty()) return;
    file_ = isStandardOutput(path) ? stdout : std::fopen(path.c_str(), "we");
    std::signal(SIGPIPE, SIG_IGN);  // who does not read any more does not stop the movie
    if (!file_) throw Error("cannot write file", path, std::strerror(errno));
}

MovieReport::~MovieReport() {
    if (file_ && file_ != stdout) std::fclose(file_);
}

void MovieReport::baked(double share) {
    if (!file_) return;
    std::fprintf(file_, "{\"baked\": %.3f}\n", share);
    std::fflush(file_);
}

void MovieReport::drawn(std::uint64_t frame, std::uint64_t frames, std::optional<int> model) {
    if (!file_) return;
    const std::string shown = model ? ", \"model\": " + std::to_string(*model) : "";
    std::fprintf(file_, "{\"frame\": %llu, \"frames\": %llu%s}\n", static_cast<unsigned long long>(frame),
                 static_cast<unsigned long long>(frames), shown.c_str());
    std::fflush(file_);
}

}  // namespace nacre::app
