#pragma once
// Where scenes of strangers may download from: the databases, and hosts that the operator names.

#include <string>
#include <vector>

struct sockaddr;

namespace nacre::app {

/// Whether an address is one of the public internet: not loopback, private, link-local, multicast or reserved.
bool isPublic(const sockaddr& address);

enum class HostRule {
    refused,
    database,  ///< at a public address alone
    named,     ///< by the operator, wherever it is
};

/// The rule for an address: http or https, a host with or without a port, and nothing before the host. A database has
/// the usual port. @param named  "files.example.org" or "files.example.org:8080"
HostRule hostRule(const std::string& url, const std::vector<std::string>& named);

}  // namespace nacre::app
