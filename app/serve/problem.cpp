#include "app/serve/problem.h"

#include <utility>

#include "app/files/json_text.h"
#include "app/files/printable.h"

namespace nacre::app {

const char* statusTitle(int status) {
    constexpr std::pair<int, const char*> kTitles[] = {{400, "Bad Request"},         {401, "Unauthorized"},
                                                       {403, "Forbidden"},           {404, "Not Found"},
                                                       {405, "Method Not Allowed"},  {413, "Content Too Large"},
                                                       {414, "URI Too Long"},        {415, "Unsupported Media Type"},
                                                       {421, "Misdirected Request"}, {422, "Unprocessable Content"},
                                                       {429, "Too Many Requests"},   {503, "Service Unavailable"}};
    for (const auto& [code, title] : kTitles)
        if (code == status) return title;
    return "Internal Server Error";
}

std::string problemJson(int status, const std::string& detail) {
    return jsonText(
        {{"type", "about:blank"}, {"title", statusTitle(status)}, {"status", status}, {"detail", shortened(detail)}});
}

}  // namespace nacre::app
