#include "engine/molecule/trajectory/trajectory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/molecule/read.h"
#include "engine/molecule/trajectory/trajectory_file.h"

namespace nacre {

TrajectoryFile::TrajectoryFile(const std::string& path) : name_(path) {
    file_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);  // a pipe is refused, not waited for
    if (file_ < 0) fail(std::strerror(errno));
    struct stat status {};
    const bool plain = fstat(file_, &status) == 0 && S_ISREG(status.st_mode);
    if (!plain) {
        ::close(file_);
        fail("it is not a plain file");
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
}

TrajectoryFile::~TrajectoryFile() { ::close(file_); }

void TrajectoryFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    if (!holds(offset, bytes.size())) fail("it ends within a frame");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = ::pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
        if (n > 0) done += static_cast<std::size_t>(n);
        if (n == 0) fail("it ends within a frame");
        if (n < 0 && errno != EINTR) fail(std::strerror(errno));
    }
}

std::size_t checkedAtoms(const TrajectoryFile& file, std::int64_t atoms) {
    if (atoms < 1 || atoms > static_cast<std::int64_t>(kMaxAtoms))
        file.fail("it has frames of " + std::to_string(atoms) + " atoms");
    return static_cast<std::size_t>(atoms);
}

void checkFinite(const TrajectoryFile& file, std::size_t frame, std::span<const glm::vec3> positions) {
    constexpr float kFarthest = 1e7f;  // Å; nothing is drawn beyond, nor was ever simulated
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(positions[i][k]) < kFarthest))
                file.fail("frame " + std::to_string(frame + 1) + ": atom " + std::to_string(i + 1) +
                          " has no position within 1e7 Å");
}

TrajectoryFrame Trajectory::read(std::size_t frame) {
    if (frame >= frames_)
        throw Error("cannot read trajectory", name_,
                    "there is no frame " + std::to_string(frame + 1) + "; it has " + std::to_string(frames_));
    TrajectoryFrame result;
    result.positions.resize(atoms_);
    readFrame(frame, result);
    return result;
}

std::unique_ptr<Trajectory> openTrajectory(const std::string& path) {
    auto file = std::make_unique<TrajectoryFile>(path);
    std::array<std::byte, 8> start{};
    if (file->size() < start.size()) file->fail(file->size() ? "it is no trajectory" : "it is empty");
    file->read(0, start);
    const auto big = numberAt<std::uint32_t>(start.data(), kBigEndianSwapped);
    constexpr std::uint32_t kXtc = 1995, kLargeXtc = 2023, kTrr = 1993, kDcdHeader = 84;
    if (big == kXtc || big == kLargeXtc) return openXtc(std::move(file));
    if (big == kTrr) return openTrr(std::move(file));
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    if (text.starts_with("CDF")) return openNetcdf(std::move(file));
    if (text.starts_with("\x89HDF")) file->fail("it is NetCDF 4 (HDF5); classic NetCDF is read, as AMBER writes it");
    if (text.substr(4) == "CORD")
        for (const bool swapped : {false, true})
            if (numberAt<std::uint32_t>(start.data(), swapped) == kDcdHeader) return openDcd(std::move(file), swapped);
    file->fail("it is none of DCD, XTC, TRR and AMBER NetCDF");
}

std::optional<PeriodicBox> boxOf(const glm::dvec3& lengths, const glm::dvec3& angles) {
    const auto cosine = [](double degrees) { return std::cos(degrees * std::numbers::pi / 180); };
    const double alpha = cosine(angles.x), beta = cosine(angles.y), gamma = cosine(angles.z);
    const double sine = std::sqrt(1 - gamma * gamma);
    const double y = (alpha - beta * gamma) / sine, z2 = 1 - beta * beta - y * y;
    for (int k = 0; k < 3; ++k)
        if (!(lengths[k] > 0) || !std::isfinite(lengths[k])) return std::nullopt;
    if (!(sine > 1e-6) || !(z2 > 1e-9)) return std::nullopt;
    return PeriodicBox{glm::vec3(lengths.x, 0, 0), glm::vec3(glm::dvec3(gamma, sine, 0) * lengths.y),
                       glm::vec3(glm::dvec3(beta, y, std::sqrt(z2)) * lengths.z)};
}

}  // namespace nacre
