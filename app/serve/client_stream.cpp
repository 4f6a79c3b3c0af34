#include "app/serve/client_stream.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace nacre::app {
namespace {

constexpr std::size_t kMostRead = std::size_t{128} << 20;  // bytes of a body; larger ones are skipped
constexpr std::size_t kPiece = 16384;                      // read at once

/// Renames Range headers: pictures are sent whole, and many ranges could multiply an answer's size. httplib answers
/// malformed ones with 416.
void dropRanges(char* head, std::size_t size) {
    constexpr std::string_view kName = "\nrange:";
    const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b; };
    char* const end = head + size;
    for (char* at = head; (at = std::search(at, end, kName.begin(), kName.end(), same)) != end; ++at) at[1] = 'X';
}

}  // namespace

ClientStream::~ClientStream() { ::close(socket_); }

ClientStream::Head ClientStream::readHead() {
    constexpr std::string_view kEnd = "\r\n\r\n";
    for (;;) {
        const std::size_t end = buffer_.find(kEnd, std::max(searched_, first_));
        if (end != std::string::npos || buffer_.size() - first_ > kMostHeadBytes) {
            dropRanges(buffer_.data() + first_, std::min(end, buffer_.size()) - first_);
            return Head::whole;
        }
        searched_ = std::max(first_, buffer_.size() - std::min(buffer_.size(), kEnd.size() - 1));
        if (!wait(POLLIN, 0)) return Head::partial;
        if (!fill(false)) return Head::missing;
    }
}

void ClientStream::begin(bool waits) {
    start_ = Clock::now();
    received_ = sent_ = 0;
    headTaken_ = false;
    expected_ = 0;
    waits_ = waits;
}

void ClientStream::takeHead(httplib::Request& request) {
    headTaken_ = true;
    start_ = Clock::now();
    received_ = 0;
    const std::string length = request.get_header_value("Content-Length");
    expected_ = std::strtoull(length.c_str(), nullptr, 10);
    // Only httplib's reader finds the end of a chunked body.
    if (request.has_header("Transfer-Encoding")) expected_ = ~std::size_t{0};
}

void ClientStream::end() { ::shutdown(socket_, SHUT_WR); }

bool ClientStream::skip() {
    std::array<char, kPiece> dropped;
    constexpr int kReads = 16;  // then other connections have their turn
    for (int i = 0; i < kReads; ++i) {
        const ssize_t got = ::recv(socket_, dropped.data(), dropped.size(), MSG_DONTWAIT);
        if (got == 0) return false;
        if (got < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    }
    return true;
}

ssize_t ClientStream::read(char* to, std::size_t size) {
    if (first_ == buffer_.size()) {
        const bool most = received_ >= (headTaken_ ? kMostRead : kMostHeadBytes);
        if (most || !waits_ || !wait(POLLIN, left(headTaken_ ? received_ : 0)) || !fill(true)) return -1;
    }
    const std::size_t taken = std::min(size, buffer_.size() - first_);
    std::memcpy(to, buffer_.data() + first_, taken);
    first_ += taken;
    received_ += taken;
    sent_ = 0;  // after "100 Continue" the answer still follows
    // httplib reads lines byte by byte, into a growing buffer.
    line_ = size == 1 && *to != '\n' ? line_ + 1 : 0;
    if (line_ > kMostHeadBytes || (!headTaken_ && received_ > kMostHeadBytes)) return -1;
    return static_cast<ssize_t>(taken);
}

ssize_t ClientStream::write(const char* from, std::size_t size) {
    if (sent_ == 0) start_ = Clock::now();
    for (;;) {
        const ssize_t sent = ::send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent >= 0) {
            sent_ += static_cast<std::size_t>(sent);
            return sent;
        }
        if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) return -1;
        if (!wait(POLLOUT, waits_ ? left(sent_) : 0)) return -1;
    }
}

bool ClientStream::wait(short events, int milliseconds) const {
    pollfd one{socket_, events, 0};
    int ready = 0;
    do ready = ::poll(&one, 1, std::max(milliseconds, 0));
    while (ready < 0 && errno == EINTR);
    return ready > 0;
}

/// Milliseconds until the deadline of a transfer. @param moved  its bytes so far
int ClientStream::left(std::size_t moved) const {
    const double most = 1000.0 * (seconds_ + static_cast<double>(moved) / static_cast<double>(kLeastRate));
    return static_cast<int>(std::clamp(most - millisecondsSince(start_), 0.0, 3.6e6));
}

/// Reads available bytes. @param takes  everything read before was used @returns whether there were any
bool ClientStream::fill(bool takes) {
    if (takes || first_ == buffer_.size()) {
        buffer_.clear();
        first_ = searched_ = 0;
    }
    const std::size_t before = buffer_.size();
    buffer_.resize(before + kPiece);
    const ssize_t got = ::recv(socket_, buffer_.data() + before, kPiece, MSG_DONTWAIT);
    buffer_.resize(before + (got > 0 ? static_cast<std::size_t>(got) : 0));
    return got > 0;
}

}  // namespace nacre::app
