#pragma once
// A server's counters, in the format of Prometheus.

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace nacre::app {

class Metrics {
public:
    void answered(int status, std::uint64_t bytes);
    void took(double seconds);
    void hit();
    void drawn();
    /// Text format 0.0.4. @param waiting  number of waiting requests @param devices  created so far
    std::string text(std::size_t waiting, std::uint64_t devices) const;

private:
    static constexpr std::array kBounds{0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0};
    mutable std::mutex turn_;
    std::map<int, std::uint64_t> requests_;  ///< by status
    std::array<std::uint64_t, kBounds.size() + 1> durations_{};
    double seconds_ = 0;
    std::uint64_t bytes_ = 0, hits_ = 0, drawn_ = 0;
};

}  // namespace nacre::app
