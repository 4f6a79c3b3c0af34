#include "app/serve/server.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

#include "app/cli/commands.h"
#include "app/files/cache_folder.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "app/files/output_file.h"
#include "app/images/image_file.h"
#include "app/movie/stop_request.h"
#include "app/picture/option_schema.h"
#include "app/serve/http_server.h"
#include "app/serve/metrics.h"
#include "app/serve/page.h"
#include "app/serve/picture_store.h"
#include "app/serve/problem.h"
#include "app/serve/uploads.h"
#include "app/serve/workers.h"
#include "engine/error.h"
#include "engine/milliseconds.h"

namespace nacre::app {
namespace {

using httplib::Request;
using httplib::Response;

constexpr std::size_t kConnections = 256;                    // threads that read requests and wait for pictures
constexpr std::size_t kMostBodies = std::size_t{512} << 20;  // bytes, of all requests together

std::string unescaped(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned code = 0;
        if (text[i] == '%' && i + 2 < text.size() &&
            std::sscanf(std::string(text.substr(i + 1, 2)).c_str(), "%2x", &code) == 1) {
            plain += static_cast<char>(code);
            i += 2;
        } else {
            plain += text[i] == '+' ? ' ' : text[i];
        }
    }
    return plain;
}

/// Keys and values in their order, which httplib's own table loses.
Query queryOf(const Request& request) {
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

/// Takes a key out of a query. @returns its last value
std::string taken(Query& query, const std::string& key) {
    std::string value;
    std::erase_if(query, [&](const auto& pair) {
        if (pair.first == key) value = pair.second;
        return pair.first == key;
    });
    return value;
}

std::string mediaType(const std::string& extension) {
    if (extension == ".png") return "image/png";
    if (extension == ".webp") return "image/webp";
    if (extension == ".tif" || extension == ".tiff") return "image/tiff";
    if (extension == ".exr") return "image/x-exr";
    return "image/jpeg";
}

/// A request's body in a file, for as long as it is read.
class BodyFile {
public:
    explicit BodyFile(const std::string& body) {
        if (body.empty()) throw Problem(400, "the body is empty: a structure or a saved view is expected");
        std::string name = (std::filesystem::temp_directory_path() / "nacre-body-XXXXXX").string();
        const int file = mkstemp(name.data());
        if (file < 0) throw Problem(503, "no room for the request's body");
        path_ = name;
        std::size_t done = 0;
        while (done < body.size()) {
            const ssize_t written = write(file, body.data() + done, body.size() - done);
            if (written <= 0) break;
            done += static_cast<std::size_t>(written);
        }
        close(file);
        if (done < body.size()) throw Problem(503, "no room for the request's body");
    }
    ~BodyFile() { std::remove(path_.c_str()); }
    BodyFile(const BodyFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

/// An error's text without paths that the client did not name.
std::string without(std::string text, const std::string& place) {
    for (std::size_t at; !place.empty() && (at = text.find(place)) != std::string::npos;)
        text.replace(at, place.size(), "the input");
    return text;
}

}  // namespace

struct Server::Parts {
    explicit Parts(const ServeOptions& asked)
        : options(asked),
          store(asked.cacheMiB > 0 ? cacheFolder(asked.picture.input.cache, "pictures") : "",
                static_cast<std::uint64_t>(asked.cacheMiB) << 20),
          workers(asked) {
        http.set_payload_max_length(kMostBodyBytes);
        http.set_tcp_nodelay(true);
        // Not shared with another process, which httplib asks for by default.
        http.set_socket_options([](socket_t socket) {
            const int yes = 1;
            setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        });
        addRoutes();
        if (options.port == 0)
            bound = http.bind_to_any_port(options.address.c_str());
        else if (http.bind_to_port(options.address.c_str(), options.port))
            bound = options.port;
        if (bound <= 0)
            throw Error("cannot listen", options.address + ":" + std::to_string(options.port),
                        "the port is taken, or the address is not this machine's");
        http.holdConnections(1024);
    }

    void addRoutes() {
        http.Get("/", [](const Request&, Response& response) {
            response.set_header(
                "Content-Security-Policy",
                "default-src 'self'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src 'self' blob:");
            response.set_content(kServePage, "text/html; charset=utf-8");
        });
        http.Get("/health", [](const Request&, Response& response) { response.set_content("ok\n", "text/plain"); });
        http.Get("/metrics", [this](const Request&, Response& response) {
            response.set_content(metrics.text(workers.waiting()), "text/plain; version=0.0.4");
        });
        http.Get("/options", [](const Request&, Response& response) {
            static const std::string schema = optionSchema("Options of GET /picture", isServed);
            response.set_content(schema, "application/schema+json");
        });
        http.Get("/picture", answer([this](const Request& request, Response& response) {
                     sendPicture(queryOf(request), "", request, response);
                 }));
        http.Post("/picture", withBody([this](const Request& request, const std::string& body, Response& response) {
                      const BodyFile file(body);
                      sendPicture(queryOf(request), file.path(), request, response);
                  }));
        http.Post("/structures", withBody([this](const Request&, const std::string& body, Response& response) {
                      response.set_content(jsonText({{"input", uploads.keep(body)}}), "application/json");
                  }));
        http.Get("/info", answer([this](const Request& request, Response& response) { sendInfo(request, response); }));
        http.Get(R"(/([0-9A-Za-z_.-]+\.(?:png|jpe?g|webp)))",
                 answer([this](const Request& request, Response& response) {
                     Query query = queryOfName(request.matches[1].str());
                     if (query.empty()) throw Problem(404, "no picture has this name");
                     for (auto& pair : queryOf(request)) query.push_back(std::move(pair));
                     sendPicture(query, "", request, response);
                 }));
        http.set_error_handler([](const Request& request, Response& response) {
            if (!response.body.empty()) return;
            const std::string detail = response.status == 404 ? "there is no " + request.path
                                       : response.status == 413
                                           ? "a body has at most " + std::to_string(kMostBodyBytes >> 20) + " MiB"
                                           : titleOf(response.status);
            response.set_content(problemJson(response.status, detail), "application/problem+json");
        });
        http.set_logger([this](const Request&, const Response& response) {
            metrics.answered(response.status, response.body.size());
        });
    }

    using Handler = std::function<void(const Request&, Response&)>;
    /// The same, with failures as problems.
    Handler answer(Handler handler) {
        return [this, handler = std::move(handler)](const Request& request, Response& response) {
            const Clock::time_point start = Clock::now();
            try {
                handler(request, response);
            } catch (const Problem& problem) {
                response.headers.clear();  // of a picture
                response.status = problem.status;
                response.set_header("Cache-Control", "no-store");
                response.set_content(problemJson(problem.status, problem.what()), "application/problem+json");
            } catch (const std::exception& error) {
                response.status = 500;
                response.set_content(problemJson(500, error.what()), "application/problem+json");
            }
            metrics.took(millisecondsSince(start) / 1000);
            if (response.status == 429 || response.status == 503) response.set_header("Retry-After", "1");
        };
    }

    using BodyHandler = std::function<void(const Request&, const std::string&, Response&)>;
    /// The body as bytes, whatever type its client calls it.
    httplib::Server::HandlerWithContentReader withBody(BodyHandler handler) {
        return [this, handler = std::move(handler)](const Request& request, Response& response,
                                                    const httplib::ContentReader& read) {
            std::string body;
            bool room = true;
            const bool whole = read([&](const char* data, std::size_t size) {
                room = (bodies += size) <= kMostBodies;
                body.append(data, size);
                return room && body.size() <= kMostBodyBytes;
            });
            const std::size_t received = body.size();
            const auto leave = [&](void*) { bodies -= received; };
            const std::unique_ptr<void, decltype(leave)> held(this, leave);
            if (!whole) {
                response.status = !room ? 503 : body.size() > kMostBodyBytes || response.status == 413 ? 413 : 400;
                if (!room) response.set_header("Retry-After", "1");
                return;  // the error handler says why
            }
            answer([&](const Request& whose, Response& to) { handler(whose, body, to); })(request, response);
        };
    }

    void sendPicture(Query query, const std::string& body, const Request& request, Response& response) {
        const std::string session = taken(query, "session");
        const bool moving = !taken(query, "moving").empty();
        const PictureRequest asked = pictureRequest(query, body, options, uploads.folder());
        const std::string extension = extensionOf(asked.description.output);
        const std::string name = contentKey(asked.identity + program()) + extension;
        const std::string tag = "\"" + name.substr(0, 32) + "\"";
        if (body.empty() && !moving) {
            response.set_header("ETag", tag);
            // A file's content may change: must be revalidated.
            const bool file = asked.description.input.path.find(':') == std::string::npos;
            response.set_header("Cache-Control", file ? "no-cache" : "public, max-age=3600");
            if (request.get_header_value("If-None-Match").find(tag) != std::string::npos) {
                response.status = 304;
                return;
            }
            if (std::optional<std::string> kept = store.find(name)) {
                metrics.hit();
                return response.set_content(std::move(*kept), mediaType(extension));
            }
        } else {
            response.set_header("Cache-Control", "no-store");
        }
        try {
            ServedPicture picture = workers.draw(asked, moving ? session : "");
            if (body.empty() && !moving) store.keep(name, picture.bytes);
            for (const std::string& warning : picture.warnings)
                response.set_header("Nacre-Warning", printable(without(warning, asked.description.input.path)));
            response.set_content(std::move(picture.bytes), mediaType(extension));
        } catch (const Problem& problem) {
            const bool known = asked.description.input.path.find(':') != std::string::npos;
            throw Problem(problem.status,
                          known ? problem.what() : without(problem.what(), asked.description.input.path));
        }
    }

    void sendInfo(const Request& request, Response& response) {
        const PictureRequest asked = pictureRequest(queryOf(request), "", options, uploads.folder());
        InfoOptions info;
        info.picture = asked.description;
        info.paths = {asked.description.input.path};
        info.json = true;
        std::ostringstream text;
        try {
            const std::lock_guard lock(oneInfo);
            const HeardMessages heard;
            infoCommand(info, text);
        } catch (const Error& error) {
            throw Problem(422, without(error.what(), info.paths.front()));
        }
        const bool file = info.paths.front().find(':') == std::string::npos;
        response.set_content(file ? without(text.str(), info.paths.front()) : text.str(), "application/json");
    }

    /// Everything else that decides a picture's bytes.
    static const std::string& program() {
        static const std::string text = [] {
            std::ostringstream out;
            versionCommand(out);
            return out.str();
        }();
        return text;
    }

    const ServeOptions& options;
    HttpServer http{kConnections};
    std::atomic<std::size_t> bodies{0};  ///< bytes of bodies that requests hold
    Metrics metrics;
    PictureStore store;
    Uploads uploads;
    std::mutex oneInfo;
    Workers workers;
    int bound = 0;
};

Server::Server(const ServeOptions& options) : parts_(std::make_unique<Parts>(options)) {}
Server::~Server() = default;

int Server::port() const { return parts_->bound; }
void Server::run() { parts_->http.listen_after_bind(); }
void Server::stop() { parts_->http.stop(); }

void serveCommand(const ServeOptions& options) {
    const StopRequest stop;
    Server server(options);
    std::thread listening([&] { server.run(); });
    sayNote("serving http://" + options.address + ":" + std::to_string(server.port()) + "/ (Ctrl C stops it)");
    while (!stop.asked()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    server.stop();
    listening.join();
}

}  // namespace nacre::app
