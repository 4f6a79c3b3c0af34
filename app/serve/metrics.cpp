#include "app/serve/metrics.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace nacre::app {
namespace {

/// On Linux; elsewhere 0.
std::uint64_t residentBytes() {
    std::uint64_t whole = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> whole >> resident;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void Metrics::answered(int status, std::uint64_t bytes) {
    const std::lock_guard lock(turn_);
    ++requests_[status];
    bytes_ += bytes;
}

void Metrics::took(double seconds) {
    const std::lock_guard lock(turn_);
    ++durations_[static_cast<std::size_t>(std::lower_bound(kBounds.begin(), kBounds.end(), seconds) - kBounds.begin())];
    seconds_ += seconds;
}

void Metrics::hit() {
    const std::lock_guard lock(turn_);
    ++hits_;
}

void Metrics::drawn() {
    const std::lock_guard lock(turn_);
    ++drawn_;
}

std::string Metrics::text(std::size_t waiting, std::uint64_t devices) const {
    const std::lock_guard lock(turn_);
    std::ostringstream text;
    text << "# HELP nacre_requests_total Requests answered, by status.\n# TYPE nacre_requests_total counter\n";
    for (const auto& [status, number] : requests_)
        text << "nacre_requests_total{status=\"" << status << "\"} " << number << '\n';
    text
        << "# HELP nacre_cache_hits_total Pictures served from the disk cache.\n# TYPE nacre_cache_hits_total counter\n"
        << "nacre_cache_hits_total " << hits_ << '\n'
        << "# HELP nacre_pictures_drawn_total Pictures drawn.\n# TYPE nacre_pictures_drawn_total counter\n"
        << "nacre_pictures_drawn_total " << drawn_ << '\n'
        << "# HELP nacre_devices_total Devices made.\n# TYPE nacre_devices_total counter\n"
        << "nacre_devices_total " << devices << '\n'
        << "# HELP nacre_sent_bytes_total Bytes of bodies sent.\n# TYPE nacre_sent_bytes_total counter\n"
        << "nacre_sent_bytes_total " << bytes_ << '\n'
        << "# HELP nacre_waiting_requests Requests that wait for a worker.\n# TYPE nacre_waiting_requests gauge\n"
        << "nacre_waiting_requests " << waiting << '\n'
        << "# HELP process_resident_memory_bytes Resident memory.\n# TYPE process_resident_memory_bytes gauge\n"
        << "process_resident_memory_bytes " << residentBytes() << '\n'
        << "# HELP nacre_request_seconds Time to answer a request.\n# TYPE nacre_request_seconds histogram\n";
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kBounds.size(); ++i)
        text << "nacre_request_seconds_bucket{le=\"" << kBounds[i] << "\"} " << (sum += durations_[i]) << '\n';
    sum += durations_.back();
    text << "nacre_request_seconds_bucket{le=\"+Inf\"} " << sum << "\nnacre_request_seconds_sum " << seconds_
         << "\nnacre_request_seconds_count " << sum << '\n';
    return text.str();
}

}  // namespace nacre::app
