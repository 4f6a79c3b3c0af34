#include "app/download/allowed_hosts.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>

#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

bool publicText(const std::string& text) {
    sockaddr_storage storage{};
    auto& four = reinterpret_cast<sockaddr_in&>(storage);
    auto& six = reinterpret_cast<sockaddr_in6&>(storage);
    if (inet_pton(AF_INET, text.c_str(), &four.sin_addr) == 1) {
        storage.ss_family = AF_INET;
    } else {
        EXPECT_EQ(inet_pton(AF_INET6, text.c_str(), &six.sin6_addr), 1) << text;
        storage.ss_family = AF_INET6;
    }
    return isPublic(reinterpret_cast<const sockaddr&>(storage));
}

TEST(AllowedHosts, OnlyPublicAddressesArePublic) {
    for (const char* text :
         {"8.8.8.8", "128.6.159.248", "172.15.255.255", "172.32.0.0", "192.167.255.255", "223.255.255.255",
          "2606:4700::1111", "2001:4860:4860::8888", "::ffff:8.8.8.8", "64:ff9b::808:808"})
        EXPECT_TRUE(publicText(text)) << text;
    for (const std::string_view text :
         splitAllWords("0.0.0.0 127.0.0.1 127.255.255.254 10.1.2.3 172.16.0.1 172.31.255.255 192.168.0.1 "
                       "169.254.169.254 100.64.0.1 192.0.2.1 198.18.0.1 224.0.0.1 240.0.0.1 255.255.255.255 :: "
                       "::1 fe80::1 fc00::1 fd12::1 ff02::1 ::ffff:127.0.0.1 ::ffff:10.0.0.1 64:ff9b::7f00:1 "
                       "2002:7f00:1:: 2001:db8::1 2001::1 ::127.0.0.1"))
        EXPECT_FALSE(publicText(std::string(text))) << text;
}

TEST(AllowedHosts, DatabasesAndNamedHosts) {
    for (const char* url :
         {"https://files.rcsb.org/download/1bna.cif", "http://files.rcsb.org/a", "https://RCSB.org",
          "https://www.ebi.ac.uk:443/pdbe", "https://ftp.ebi.ac.uk/pub?x#y", "https://files.wwpdb.org/a"})
        EXPECT_EQ(hostRule(url, {}), HostRule::database) << url;
    for (const char* url :
         {"https://evil.org/files.rcsb.org", "https://files.rcsb.org.evil.org/", "https://evilrcsb.org/",
          "https://files.rcsb.org:8080/", "http://files.rcsb.org:443/", "https://files.rcsb.org@evil.org/",
          "https://evil.org#@files.rcsb.org", "https://evil.org\\@files.rcsb.org/", "ftp://files.rcsb.org/",
          "file:///etc/passwd", "https:///a", "https://", "http://[::1]/", "http://127.0.0.1/",
          "http://rcsb.org%00.evil.org/", "http://rcsb.org.\n/"})
        EXPECT_EQ(hostRule(url, {}), HostRule::refused) << url;
    EXPECT_EQ(hostRule("http://mirror.lan:8080/a", {"mirror.lan"}), HostRule::named);
    EXPECT_EQ(hostRule("http://Mirror.lan:8080/a", {"mirror.lan:8080"}), HostRule::named);
    EXPECT_EQ(hostRule("http://mirror.lan:8081/a", {"mirror.lan:8080"}), HostRule::refused);
    EXPECT_EQ(hostRule("http://mirror.lan/a", {"mirror.lan:8080"}), HostRule::refused);
}

TEST(AllowedHosts, ProxiesHaveExceptions) {
    for (const char* list : {"*", "files.rcsb.org", "rcsb.org", ".rcsb.org", "lan, RCSB.org", "a,b c,rcsb.org"})
        EXPECT_TRUE(isWithoutProxy("files.rcsb.org", list)) << list;
    for (const char* list : {"", ",", ".", "evilrcsb.org", "csb.org", "www.rcsb.org", "files.rcsb.org.evil", "**"})
        EXPECT_FALSE(isWithoutProxy("files.rcsb.org", list)) << list;
    EXPECT_EQ(parseHost("HTTPS://x/"), "");
    EXPECT_EQ(parseHost("https://Files.rcsb.org:443/x:y"), "files.rcsb.org");
}

}  // namespace
}  // namespace nacre::app
