#pragma once
// A request's head: what is refused before anything of it is read, and what its target asks for.

#include <optional>
#include <string>

#include "app/serve/picture_request.h"
#include "app/serve/problem.h"

namespace httplib {
struct Request;
}

namespace nacre::app {

/// Why a request is refused by its head alone, if it is: a method or a host that is not served, or a body from another
/// site's page.
/// @param local  the server listens on loopback. Then only names of loopback are hosts: a page elsewhere may call its
/// own name 127.0.0.1 (DNS rebinding), and could read what the server answers
std::optional<Problem> refusalOf(const httplib::Request& request, bool local);

/// The methods that a path takes, as the header Allow states them.
std::string methodsOf(const std::string& path);

/// Whether an address, or a host with or without a port, is loopback: "localhost", "127.0.0.1:8080", "[::1]".
bool isLoopback(const std::string& host);

/// Keys and values in their order, which httplib's own table loses. @throws Problem for a wrong percent-encoding and
/// for control characters other than tabs and line ends
Query queryOf(const httplib::Request& request);

/// Takes a key out of a query. @returns its last value
std::string taken(Query& query, const std::string& key);

}  // namespace nacre::app
