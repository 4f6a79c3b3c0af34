// libFuzzer target for trajectories: any bytes are frames of finite positions or an Error, and nothing else.
// tools/fuzz runs it from what MDTraj writes.

#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "engine/error.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace {

void require(bool holds, const char* what) {
    if (holds) return;
    std::cerr << "a trajectory was read that " << what << std::endl;
    std::abort();
}

/// A file that is memory alone.
class FileInMemory {
public:
    FileInMemory(const unsigned char* data, std::size_t size) : file_(memfd_create("trajectory", 0)) {
        if (file_ < 0 || write(file_, data, size) != static_cast<ssize_t>(size)) std::abort();
    }
    ~FileInMemory() { close(file_); }
    std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
    int file_;
};

void check(nacre::Trajectory& trajectory, std::size_t frame) {
    try {
        const nacre::TrajectoryFrame read = trajectory.read(frame);
        require(read.positions.size() == trajectory.atoms(), "has a frame of other atoms");
        for (const glm::vec3& p : read.positions)
            require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "has an atom nowhere");
    } catch (const nacre::Error&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    if (size == 0) return 0;
    const FileInMemory file(data, size);
    try {
        const std::unique_ptr<nacre::Trajectory> trajectory = nacre::openTrajectory(file.path());
        require(trajectory->atoms() > 0 && trajectory->frames() > 0, "has nothing in it");
        // The last before the first: places are known, not counted up to.
        for (const std::size_t frame : {trajectory->frames() - 1, trajectory->frames() / 2, std::size_t{0}})
            check(*trajectory, frame);
    } catch (const nacre::Error&) {
    }
    return 0;
}
