// A library that listens after the program has begun, on all addresses, as RenderDoc does: at the program's end. It
// says on standard output which address that came to be.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>

namespace {

void bindAndTell(sockaddr* any, socklen_t size, const void* host) {
    const int fd = socket(any->sa_family, SOCK_STREAM, 0);
    char text[INET6_ADDRSTRLEN] = "";
    if (fd < 0 || bind(fd, any, size) != 0 || getsockname(fd, any, &size) != 0 ||
        !inet_ntop(any->sa_family, host, text, sizeof text))
        std::printf("not bound\n");
    else
        std::printf("bound to %s\n", text);
    std::fflush(stdout);
    if (fd >= 0) close(fd);
}

__attribute__((destructor)) void atEnd() {
    sockaddr_in four{};
    four.sin_family = AF_INET;
    bindAndTell(reinterpret_cast<sockaddr*>(&four), sizeof four, &four.sin_addr);
    sockaddr_in6 six{};
    six.sin6_family = AF_INET6;
    bindAndTell(reinterpret_cast<sockaddr*>(&six), sizeof six, &six.sin6_addr);
    sockaddr_in own{};  // an address that is asked for stays
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(0x7f000002);
    bindAndTell(reinterpret_cast<sockaddr*>(&own), sizeof own, &own.sin_addr);
}

}  // namespace
