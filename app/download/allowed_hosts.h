#pragma once
// Hosts from which untrusted scenes may download: the databases, and those that the operator names.

#include <string>
#include <vector>

struct sockaddr;

namespace nacre::app {

/// Host of an http or https address, in lower case, without its port. Empty: not allowed in scenes.
std::string parseHost(const std::string& url);
/// Whether a list in the format of the environment's no_proxy names a host: "example.org,.lan,127.0.0.1" or "*".
bool isWithoutProxy(const std::string& host, const std::string& list);

/// Whether an address is one of the public internet: not loopback, private, link-local, multicast or reserved.
bool isPublic(const sockaddr& address);

enum class HostRule {
    refused,
    database,  ///< only at a public address
    named,     ///< by the operator, at any address
};

/// The rule for an address: http or https, a host with or without a port, and nothing before the host. A database has
/// the usual port. @param named  "files.example.org" or "files.example.org:8080"
HostRule hostRule(const std::string& url, const std::vector<std::string>& named);

}  // namespace nacre::app
