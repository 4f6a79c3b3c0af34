#include "app/download/allowed_hosts.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

/// Hosts of PDB, EMDB, AlphaFold DB, UniProt and PubChem; their subdomains are allowed as well.
constexpr std::string_view kDatabases[] = {"rcsb.org",         "wwpdb.org",          "ebi.ac.uk",
                                           "pdbj.org",         "pdbe.org",           "uniprot.org",
                                           "ncbi.nlm.nih.gov", "emdataresource.org", "pdb-redo.eu"};

struct Range4 {
    std::uint32_t first;
    int bits;
};
/// IANA's registry of special-purpose addresses, multicast and class E.
constexpr Range4 kSpecial4[] = {{0x00000000, 8},  {0x0a000000, 8},  {0x64400000, 10}, {0x7f000000, 8},
                                {0xa9fe0000, 16}, {0xac100000, 12}, {0xc0000000, 24}, {0xc0000200, 24},
                                {0xc0586300, 24}, {0xc0a80000, 16}, {0xc6120000, 15}, {0xc6336400, 24},
                                {0xcb007100, 24}, {0xe0000000, 3}};

bool isPublic4(std::uint32_t address) {
    return std::ranges::none_of(kSpecial4,
                                [&](const Range4& range) { return (address ^ range.first) >> (32 - range.bits) == 0; });
}

std::uint32_t wordAt(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

/// Global unicast only (2000::/3), without addresses that embed IPv4 or are for documentation; and NAT64, by its
/// embedded address.
bool isPublic6(const std::uint8_t* bytes) {
    const std::uint32_t first = wordAt(bytes);
    constexpr std::array<std::uint8_t, 12> kNat64{0x00, 0x64, 0xff, 0x9b},
        kMapped{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};
    if (std::equal(kNat64.begin(), kNat64.end(), bytes) || std::equal(kMapped.begin(), kMapped.end(), bytes))
        return isPublic4(wordAt(bytes + 12));
    const bool teredo = first >> 16 == 0x2001 && (first & 0xffff) < 0x200, sixToFour = first >> 16 == 0x2002,
               documents = first == 0x20010db8 || first >> 12 == 0x3fff0;
    return first >> 29 == 1 && !teredo && !sixToFour && !documents;
}

/// Whether a host is a domain, or in it.
bool isBelow(std::string_view host, std::string_view domain) {
    return host == domain ||
           (host.size() > domain.size() && host.ends_with(domain) && host[host.size() - domain.size() - 1] == '.');
}

/// Host and port of an address, in lower case. Empty: not allowed in scenes.
std::string parseAuthority(const std::string& url) {
    const std::size_t first = url.starts_with("https://") ? 8 : 7;
    if (first == 7 && !url.starts_with("http://")) return {};
    const std::string place =
        lowerCase(url.substr(first, std::min(url.find_first_of("/?#", first), url.size()) - first));
    // Accepts only unambiguous addresses: no user, no brackets, nothing that a library might decode.
    const bool plain = place.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-:") == std::string::npos;
    return plain ? place : std::string();
}

}  // namespace

bool isPublic(const sockaddr& address) {
    if (address.sa_family == AF_INET) {
        sockaddr_in four;
        std::memcpy(&four, &address, sizeof four);
        return isPublic4(ntohl(four.sin_addr.s_addr));
    }
    if (address.sa_family != AF_INET6) return false;
    sockaddr_in6 six;
    std::memcpy(&six, &address, sizeof six);
    return isPublic6(six.sin6_addr.s6_addr);
}

std::string parseHost(const std::string& url) {
    const std::string place = parseAuthority(url);
    return place.substr(0, place.find(':'));
}

bool isWithoutProxy(const std::string& host, const std::string& list) {
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min(list.find_first_of(", ", at), list.size());
        std::string name = lowerCase(list.substr(at, end - at));
        at = end + 1;
        if (name == "*") return true;
        if (name.starts_with('.')) name.erase(0, 1);
        if (!name.empty() && isBelow(host, name)) return true;
    }
    return false;
}

HostRule hostRule(const std::string& url, const std::vector<std::string>& named) {
    const bool secure = url.starts_with("https://");
    const std::string place = parseAuthority(url), host = parseHost(url);
    if (host.empty()) return HostRule::refused;
    const auto isNamed = [&](const std::string& one) { return lowerCase(one) == place || lowerCase(one) == host; };
    if (std::ranges::any_of(named, isNamed)) return HostRule::named;
    const std::string port = place.substr(host.size());
    if (!port.empty() && port != (secure ? ":443" : ":80")) return HostRule::refused;
    const bool known =
        std::ranges::any_of(kDatabases, [&](std::string_view database) { return isBelow(host, database); });
    return known ? HostRule::database : HostRule::refused;
}

}  // namespace nacre::app
