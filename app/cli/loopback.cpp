// The program's own bind(), which libraries loaded later find before the C library's. CMake exports it.

#include "app/cli/loopback.h"

#include <dlfcn.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <atomic>
#include <cerrno>
#include <cstring>

namespace nacre::app {
namespace {

std::atomic<bool> loopbackAlone{false};

using Bind = int(int, const sockaddr*, socklen_t);

}  // namespace

void listenOnLoopbackAlone() { loopbackAlone = true; }
void listenAnywhere() { loopbackAlone = false; }

}  // namespace nacre::app

extern "C" __attribute__((visibility("default"))) int bind(int socket, const sockaddr* address,
                                                           socklen_t size) noexcept {
    static const auto real = reinterpret_cast<nacre::app::Bind*>(dlsym(RTLD_NEXT, "bind"));
    if (!real) {
        errno = ENOSYS;
        return -1;
    }
    if (nacre::app::loopbackAlone && address && address->sa_family == AF_INET && size >= sizeof(sockaddr_in)) {
        sockaddr_in own;
        std::memcpy(&own, address, sizeof own);
        if (own.sin_addr.s_addr == htonl(INADDR_ANY)) own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return real(socket, reinterpret_cast<const sockaddr*>(&own), sizeof own);
    }
    if (nacre::app::loopbackAlone && address && address->sa_family == AF_INET6 && size >= sizeof(sockaddr_in6)) {
        sockaddr_in6 own;
        std::memcpy(&own, address, sizeof own);
        if (std::memcmp(&own.sin6_addr, &in6addr_any, sizeof in6addr_any) == 0) own.sin6_addr = in6addr_loopback;
        return real(socket, reinterpret_cast<const sockaddr*>(&own), sizeof own);
    }
    return real(socket, address, size);
}
