#pragma once
// A request's head: checks before anything else is read, and the query of its target.

#include <optional>
#include <string>

#include "app/serve/picture_request.h"
#include "app/serve/problem.h"

namespace httplib {
struct Request;
}

namespace nacre::app {

/// The reason to refuse a request by its head, if any: a method or a host that is not served, or a body from another
/// site's page.
/// @param local  the server listens on loopback. Then only loopback names are accepted as hosts: a foreign page may
/// resolve its own name to 127.0.0.1 (DNS rebinding), and could read the server's answers
std::optional<Problem> checkRequest(const httplib::Request& request, bool local);

/// The methods that a path supports, as in the Allow header.
std::string allowedMethods(const std::string& path);

/// Whether an address, or a host with or without a port, is loopback: "localhost", "127.0.0.1:8080", "[::1]".
bool isLoopback(const std::string& host);

/// Keys and values in order, which httplib's own table loses. @throws Problem for invalid percent-encoding, and for
/// control characters other than tabs and line ends
Query parseQuery(const httplib::Request& request);

/// Removes a key from a query. @returns its last value
std::string taken(Query& query, const std::string& key);

}  // namespace nacre::app
