#include "app/serve/problem.h"

#include "app/files/json_text.h"

namespace nacre::app {

const char* titleOf(int status) {
    switch (status) {
        case 400:
            return "Bad Request";
        case 401:
            return "Unauthorized";
        case 403:
            return "Forbidden";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 413:
            return "Content Too Large";
        case 414:
            return "URI Too Long";
        case 421:
            return "Misdirected Request";
        case 422:
            return "Unprocessable Content";
        case 429:
            return "Too Many Requests";
        case 503:
            return "Service Unavailable";
        default:
            return "Internal Server Error";
    }
}

std::string problemJson(int status, const std::string& detail) {
    return jsonText({{"type", "about:blank"}, {"title", titleOf(status)}, {"status", status}, {"detail", detail}});
}

}  // namespace nacre::app
