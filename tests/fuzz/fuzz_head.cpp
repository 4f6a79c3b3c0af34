// libFuzzer target for what comes of a client: the bytes are read as the server reads them, by its stream and httplib,
// and whatever is a request is refused or taken apart by the server's own functions.

#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "app/serve/client_stream.h"
#include "app/serve/request_head.h"

namespace {

using namespace nacre::app;

void require(bool holds, const char* what) {
    if (holds) return;
    std::cerr << "a request was taken that " << what << std::endl;
    std::abort();
}

/// As the server answers, without pictures.
class Answers : public httplib::Server {
public:
    Answers() {
        set_payload_max_length(kMostBodyBytes);
        set_pre_routing_handler([](const httplib::Request& request, httplib::Response& response) {
            const std::optional<Problem> refusal = checkRequest(request, true);
            if (!refusal) return HandlerResponse::Unhandled;
            require(refusal->status >= 400 && refusal->status < 500, "is refused as the server's fault");
            response.status = refusal->status;
            response.set_content(problemJson(refusal->status, refusal->what()), "application/problem+json");
            return HandlerResponse::Handled;
        });
        const auto answer = [](const httplib::Request& request, httplib::Response& response) {
            require(request.ranges.empty(), "has ranges");
            try {
                Query query = parseQuery(request);
                const std::string session = taken(query, "session");
                for (const auto& [key, value] : query)
                    require(key.find('\0') == std::string::npos && value.find('\0') == std::string::npos,
                            "holds a NUL");
                response.set_content(session, "text/plain");
            } catch (const Problem& problem) {
                response.status = problem.status;
            }
        };
        Get("/picture", answer);
        Get(R"(/([0-9A-Za-z_.-]+\.(?:png|jpe?g|webp)))",
            [](const httplib::Request& request, httplib::Response&) { queryOfName(request.matches[1].str()); });
        Post("/picture", [](const httplib::Request&, httplib::Response&, const httplib::ContentReader& read) {
            std::size_t size = 0;
            read([&](const char*, std::size_t more) { return (size += more) <= kMostBodyBytes; });
        });
    }
    /// All requests that some bytes hold.
    void answerAll(ClientStream& stream) {
        for (int i = 0; i < 100 && stream.readHead() != ClientStream::Head::missing; ++i) {
            bool closed = false;
            stream.begin(false);
            const auto taken = [&](httplib::Request& request) { stream.takeHead(request); };
            if (!process_request(stream, false, closed, taken) || closed || !stream.isThrough()) return;
        }
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static Answers answers;
    int ends[2];
    if (size > 32768 || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return 0;
    if (write(ends[0], data, size) != static_cast<ssize_t>(size)) std::abort();
    shutdown(ends[0], SHUT_WR);
    {
        ClientStream stream(ends[1], 1);
        answers.answerAll(stream);
    }
    close(ends[0]);
    return 0;
}
