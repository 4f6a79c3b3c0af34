#include "app/serve/request_head.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "app/serve/http_server.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

bool isControl(char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t') || c == 0x7f;
}

std::string unescaped(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i] == '+' ? ' ' : text[i];
        if (c == '%') {
            unsigned code = 0;
            const std::string_view digits = text.substr(i + 1, 2);
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
            if (digits.size() < 2 || error != std::errc() || end != digits.data() + 2)
                throw Problem(400,
                              "'%" + std::string(digits) + "' is no percent-encoded character (write '%25' for '%')");
            c = static_cast<char>(code);
            i += 2;
        }
        if (isControl(c)) throw Problem(400, "the query has a control character");
        plain += c;
    }
    return plain;
}

/// "http://localhost:8080" and a Host header of "localhost:8080". A proxy may have removed the port.
bool isOwnPage(const std::string& origin, const std::string& host) {
    const std::size_t scheme = origin.find("://");
    if (scheme == std::string::npos) return false;
    std::string place = lowerCase(origin.substr(scheme + 3));
    const std::string own = lowerCase(host);
    if (place == own) return true;
    const std::size_t port = place.rfind(':');
    if (port != std::string::npos && place.find(']', port) == std::string::npos) place.resize(port);
    return place == own;
}

bool takesBodies(const std::string& path) { return path == "/picture" || path == "/structures"; }

}  // namespace

std::string allowedMethods(const std::string& path) {
    return path == "/structures" ? "POST" : path == "/picture" ? "GET, HEAD, POST" : "GET, HEAD";
}

bool isLoopback(const std::string& host) {
    std::string name = host;
    if (name.starts_with('['))
        name = name.substr(0, name.find(']') + 1);
    else if (std::count(name.begin(), name.end(), ':') == 1)
        name.resize(name.find(':'));
    name = lowerCase(name);
    const bool address = name.starts_with("127.") && name.find_first_not_of("0123456789.") == std::string::npos;
    return address || name == "localhost" || name == "::1" || name == "[::1]";
}

std::optional<Problem> checkRequest(const httplib::Request& request, bool local) {
    const bool post = request.method == "POST";
    const bool get = request.method == "GET" || request.method == "HEAD";
    if ((!post && !get) || (post && !takesBodies(request.path)) || (get && request.path == "/structures"))
        return Problem(405, request.path + " takes " + allowedMethods(request.path));
    const std::size_t hosts = request.get_header_value_count("Host");
    if (hosts > 1 || (hosts == 0 && request.version != "HTTP/1.0"))
        return Problem(400, "a request has one header Host");
    if (local && hosts == 1 && !isLoopback(request.get_header_value("Host")))
        return Problem(421, "this server answers for this machine alone: localhost, 127.0.0.1 or [::1]");
    const bool foreign = request.get_header_value("Sec-Fetch-Site") == "cross-site" ||
                         (request.has_header("Origin") &&
                          !isOwnPage(request.get_header_value("Origin"), request.get_header_value("Host")));
    if (post && foreign) return Problem(403, "a page of another site may not send bodies here");
    if (post && lowerCase(request.get_header_value("Content-Type")).starts_with("multipart/"))
        return Problem(415, "a body is the file itself, not a form: curl --data-binary @FILE");
    if (post && !request.has_header("Content-Length") && !request.has_header("Transfer-Encoding"))
        return Problem(400, "a POST request has a body, whose length Content-Length says");
    return {};
}

Query parseQuery(const httplib::Request& request) {
    Query query;
    const std::size_t mark = request.target.find('?');
    if (mark == std::string::npos) return query;
    std::istringstream pairs(request.target.substr(mark + 1));
    for (std::string pair; std::getline(pairs, pair, '&');) {
        const std::size_t equals = std::min(pair.find('='), pair.size());
        if (equals > 0)
            query.emplace_back(unescaped(std::string_view(pair).substr(0, equals)),
                               unescaped(std::string_view(pair).substr(std::min(equals + 1, pair.size()))));
    }
    return query;
}

std::string taken(Query& query, const std::string& key) {
    std::string value;
    std::erase_if(query, [&](const auto& pair) {
        if (pair.first == key) value = pair.second;
        return pair.first == key;
    });
    return value;
}

}  // namespace nacre::app
