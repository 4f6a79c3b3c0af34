// Preloaded: names below rcsb.org are of this machine, and their port 80 is NACRE_TEST_PORT. As for a client who
// controls what a database's name resolves to.

#include <arpa/inet.h>
#include <dlfcn.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdlib>
#include <cstring>
#include <string_view>

extern "C" int getaddrinfo(const char* node, const char* service, const addrinfo* hints, addrinfo** result) {
    static const auto resolve = reinterpret_cast<decltype(&getaddrinfo)>(dlsym(RTLD_NEXT, "getaddrinfo"));
    const bool here = node && std::string_view(node).ends_with("rcsb.org");
    return resolve(here ? "127.0.0.1" : node, service, hints, result);
}

extern "C" int connect(int socket, const sockaddr* address, socklen_t size) {
    static const auto open = reinterpret_cast<decltype(&connect)>(dlsym(RTLD_NEXT, "connect"));
    const char* const port = std::getenv("NACRE_TEST_PORT");
    sockaddr_in four{};
    if (!port || !address || address->sa_family != AF_INET || size < sizeof four) return open(socket, address, size);
    std::memcpy(&four, address, sizeof four);
    if (four.sin_port == htons(80)) four.sin_port = htons(static_cast<in_port_t>(std::atoi(port)));
    return open(socket, reinterpret_cast<const sockaddr*>(&four), sizeof four);
}
