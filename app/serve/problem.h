#pragma once
// Error responses: application/problem+json (RFC 9457).

#include <stdexcept>
#include <string>

namespace nacre::app {

struct Problem : std::runtime_error {
    Problem(int code, const std::string& detail) : std::runtime_error(detail), status(code) {}
    int status;
};

/// "Not Found"
const char* statusTitle(int status);
/// {"type": "about:blank", "title": "Not Found", "status": 404, "detail": "..."}
std::string problemJson(int status, const std::string& detail);

}  // namespace nacre::app
