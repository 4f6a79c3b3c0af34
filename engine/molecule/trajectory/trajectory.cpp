#include "engine/molecule/trajectory/trajectory.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>

#include "engine/molecule/read.h"
#include "engine/molecule/trajectory/trajectory_file.h"

namespace nacre {

TrajectoryFile::TrajectoryFile(const std::string& path) : name_(path), file_(ByteFile::open(path)) {
    if (!file_) fail(ByteFile::whyNotOpened(path));
}

void TrajectoryFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    if (!holds(offset, bytes.size())) fail("it ends within a frame");
    file_->read(offset, bytes.data(), bytes.size());
}

std::size_t checkedAtoms(const TrajectoryFile& file, std::int64_t atoms) {
    if (atoms < 1 || atoms > static_cast<std::int64_t>(kMaxAtoms))
        file.fail("it has frames of " + std::to_string(atoms) + " atoms");
    return static_cast<std::size_t>(atoms);
}

FileTrajectory::FileTrajectory(OwnedFile file, const char* format, bool swapped)
    : file_(std::move(file)), swapped_(swapped) {
    name_ = file_->name();
    format_ = format;
}

void FileTrajectory::readFrame(std::size_t frame, TrajectoryFrame& result) {
    readWhole(frame, result);
    constexpr float kFarthest = 1e7f;  // Å; larger coordinates are neither drawn nor simulated
    for (std::size_t i = 0; i < result.positions.size(); ++i)
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(result.positions[i][k]) < kFarthest))
                file_->fail("frame " + std::to_string(frame + 1) + ": atom " + std::to_string(i + 1) +
                            " has no position within 1e7 Å");
}

void FileTrajectory::readPositions(std::uint64_t offset, bool twice, float factor, TrajectoryFrame& result) {
    buffer_.resize(atoms_ * (twice ? 24 : 12));
    file_->read(offset, buffer_);
    for (std::size_t i = 0; i < atoms_ * 3; ++i) {
        const float number = twice ? static_cast<float>(numberAt<double>(buffer_.data() + 8 * i, swapped_))
                                   : numberAt<float>(buffer_.data() + 4 * i, swapped_);
        result.positions[i / 3][static_cast<int>(i % 3)] = number * factor;
    }
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

namespace {

using Opener = std::unique_ptr<Trajectory> (*)(OwnedFile);
using FileStart = std::array<std::byte, 8>;

/// The reader of a format that contains only positions; null for other formats.
Opener findOpener(const FileStart& start) {
    const auto big = numberAt<std::uint32_t>(start.data(), kBigEndianSwapped);
    constexpr std::uint32_t kXtc = 1995, kLargeXtc = 2023, kTrr = 1993, kDcdHeader = 84;
    if (big == kXtc || big == kLargeXtc) return openXtc;
    if (big == kTrr) return openTrr;
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    if (text.starts_with("CDF")) return openNetcdf;
    if (text.starts_with("\x89HDF")) return openH5md;
    if (text.substr(4) != "CORD") return nullptr;
    if (numberAt<std::uint32_t>(start.data(), false) == kDcdHeader)
        return [](OwnedFile file) { return openDcd(std::move(file), false); };
    if (numberAt<std::uint32_t>(start.data(), true) == kDcdHeader)
        return [](OwnedFile file) { return openDcd(std::move(file), true); };
    return nullptr;
}

}  // namespace

std::unique_ptr<Trajectory> openTrajectory(const std::string& path) {
    auto file = std::make_unique<TrajectoryFile>(path);
    FileStart start{};
    if (file->size() < start.size()) file->fail(file->size() ? "it is not a trajectory" : "it is empty");
    file->read(0, start);
    const Opener open = findOpener(start);
    return open ? open(std::move(file)) : openModels(path);
}

std::unique_ptr<Trajectory> openTrajectory(const std::string& name, const std::string& bytes) {
    FileStart start{};
    if (bytes.size() < start.size()) return nullptr;
    std::memcpy(start.data(), bytes.data(), start.size());
    const Opener open = findOpener(start);
    if (!open || open == openH5md) return nullptr;
    const std::shared_ptr<ByteFile> file = ByteFile::temporary();
    if (!file || !file->append(bytes.data(), bytes.size()))
        throw Error("cannot read trajectory", name, "there is no space for a temporary file");
    return open(std::make_unique<TrajectoryFile>(name, file));
}

bool isTrajectoryFile(const std::string& path) {
    FileStart start{};
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(start.data()), start.size())) return false;
    const Opener open = findOpener(start);
    return open && open != openH5md;
}

std::optional<PeriodicBox> makeBox(const glm::dvec3& lengths, const glm::dvec3& angles) {
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
