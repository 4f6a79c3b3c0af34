#include "app/serve/server.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <future>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include "app/cli/commands.h"
#include "app/files/cache_folder.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "app/files/opened_file.h"
#include "app/files/output_file.h"
#include "app/files/unnamed_file.h"
#include "app/images/image_file.h"
#include "app/movie/stop_request.h"
#include "app/picture/option_json.h"
#include "app/serve/http_server.h"
#include "app/serve/page.h"
#include "app/serve/picture_store.h"
#include "app/serve/problem.h"
#include "app/serve/request_head.h"
#include "app/serve/uploads.h"
#include "app/serve/workers.h"
#include "engine/error.h"
#include "engine/milliseconds.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

using httplib::Request;
using httplib::Response;

/// On Linux; elsewhere 0.
std::uint64_t residentBytes() {
    std::uint64_t whole = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> whole >> resident;
    return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

constexpr std::size_t kAnswering = 256;                      // threads that read bodies and wait for pictures
constexpr std::size_t kConnections = 640;                    // in addition; a process often has 1024 descriptors
constexpr std::size_t kMostBodies = std::size_t{512} << 20;  // bytes, in all requests together
const std::string kTooLarge = "a body has at most " + std::to_string(kMostBodyBytes >> 20) + " MiB";

std::string mediaType(const std::string& extension) {
    if (extension == ".png") return "image/png";
    if (extension == ".webp") return "image/webp";
    if (extension == ".tif" || extension == ".tiff") return "image/tiff";
    if (extension == ".exr") return "image/x-exr";
    return "image/jpeg";
}

/// A text without paths of this machine or names of uploads.
std::string forClient(std::string text, const PictureDescription& asked) {
    const auto hide = [&](const std::string& path) {
        for (std::size_t at; (at = text.find(path)) != std::string::npos;) text.replace(at, path.size(), "the input");
    };
    const auto hideFile = [&](const std::shared_ptr<const OpenedFile>& file) {
        if (!file) return;
        hide(file->path());
        if (file->hasFolder() || file->name().starts_with(Uploads::kPrefix)) hide(file->name());
    };
    hideFile(asked.input.opened);
    for (const FurtherInput& further : asked.input.further) hideFile(further.opened);
    return text;
}

/// "127.0.0.1:8080", "[::1]:8080"
std::string formatAddress(const ServeOptions& asked, int port) {
    const bool colons = asked.address.find(':') != std::string::npos;
    return (colons ? "[" + asked.address + "]" : asked.address) + ":" + std::to_string(port);
}

/// Why binding failed, and what to do. @param reason  from errno; 0: the address is invalid
std::string whyNotBound(const ServeOptions& asked, int reason) {
    const std::string free = "--listen " + formatAddress(asked, 0) + " takes a free port";
    if (reason == EADDRINUSE) return "another program listens there; stop it, or name another port: " + free;
    if (reason == EACCES) return "this port needs more rights; name one from 1024 on, or any: " + free;
    return "not an address of this machine; --listen 127.0.0.1:" + std::to_string(asked.port) +
           " is for programs of this machine, --listen 0.0.0.0:" + std::to_string(asked.port) + " for its network";
}

/// Counters, in the format of Prometheus.
class Metrics {
public:
    void answered(int status, std::uint64_t bytes) {
        const std::lock_guard lock(turn_);
        ++requests_[status];
        bytes_ += bytes;
    }

    void took(double seconds) {
        const std::lock_guard lock(turn_);
        ++durations_[static_cast<std::size_t>(std::lower_bound(kBounds.begin(), kBounds.end(), seconds) -
                                              kBounds.begin())];
        seconds_ += seconds;
    }

    void hit() {
        const std::lock_guard lock(turn_);
        ++hits_;
    }

    void drawn() {
        const std::lock_guard lock(turn_);
        ++drawn_;
    }

    /// Text format 0.0.4. @param waiting  number of waiting requests @param devices  created so far
    std::string text(std::size_t waiting, std::uint64_t devices) const;

private:
    static constexpr std::array kBounds{0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0};
    mutable std::mutex turn_;
    std::map<int, std::uint64_t> requests_;  ///< by status
    std::array<std::uint64_t, kBounds.size() + 1> durations_{};
    double seconds_ = 0;
    std::uint64_t bytes_ = 0, hits_ = 0, drawn_ = 0;
};

std::string Metrics::text(std::size_t waiting, std::uint64_t devices) const {
    const std::lock_guard lock(turn_);
    std::ostringstream text;
    text << "# HELP nacre_requests_total Requests answered, by status.\n# TYPE nacre_requests_total counter\n";
    for (const auto& [status, number] : requests_)
        text << "nacre_requests_total{status=\"" << status << "\"} " << number << '\n';
    text
        << "# HELP nacre_cache_hits_total Pictures served from the disk cache.\n# TYPE nacre_cache_hits_total counter\n"
        << "nacre_cache_hits_total " << hits_ << '\n'
        << "# HELP nacre_pictures_drawn_total Pictures drawn.\n# TYPE nacre_pictures_drawn_total counter\n"
        << "nacre_pictures_drawn_total " << drawn_ << '\n'
        << "# HELP nacre_devices_total Devices made.\n# TYPE nacre_devices_total counter\n"
        << "nacre_devices_total " << devices << '\n'
        << "# HELP nacre_sent_bytes_total Bytes of bodies sent.\n# TYPE nacre_sent_bytes_total counter\n"
        << "nacre_sent_bytes_total " << bytes_ << '\n'
        << "# HELP nacre_waiting_requests Requests that wait for a worker.\n# TYPE nacre_waiting_requests gauge\n"
        << "nacre_waiting_requests " << waiting << '\n'
        << "# HELP process_resident_memory_bytes Resident memory.\n# TYPE process_resident_memory_bytes gauge\n"
        << "process_resident_memory_bytes " << residentBytes() << '\n'
        << "# HELP nacre_request_seconds Time to answer a request.\n# TYPE nacre_request_seconds histogram\n";
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kBounds.size(); ++i)
        text << "nacre_request_seconds_bucket{le=\"" << kBounds[i] << "\"} " << (sum += durations_[i]) << '\n';
    sum += durations_.back();
    text << "nacre_request_seconds_bucket{le=\"+Inf\"} " << sum << "\nnacre_request_seconds_sum " << seconds_
         << "\nnacre_request_seconds_count " << sum << '\n';
    return text.str();
}

/// `http` answers requests from serve() until stop(), which is thread-safe; pictures in progress are finished.
struct Server {
    /// Binds its port. @param asked  outlives this @throws Error if there is no device, or the port is taken
    explicit Server(const ServeOptions& asked)
        : options(asked),
          store(asked.cacheMiB > 0 ? cacheFolder(asked.picture.input.cache, "pictures") : "",
                static_cast<std::uint64_t>(asked.cacheMiB) << 20),
          workers(asked) {
        http.set_payload_max_length(kMostBodyBytes);
        // Does not share the address with another process, as httplib does by default.
        http.set_socket_options([](socket_t socket) {
            const int yes = 1;
            setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        });
        http.set_default_headers({{"X-Content-Type-Options", "nosniff"}});
        addRoutes();
        errno = 0;
        if (options.port == 0)
            bound = http.bind_to_any_port(options.address.c_str());
        else if (http.bind_to_port(options.address.c_str(), options.port))
            bound = options.port;
        if (bound <= 0) throw Error("cannot listen", formatAddress(options, options.port), whyNotBound(options, errno));
    }

    void addRoutes() {
        http.set_pre_routing_handler([local = isLoopback(options.address)](const Request& request, Response& response) {
            const std::optional<Problem> refusal = checkRequest(request, local);
            if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
            if (refusal->status == 405) response.set_header("Allow", allowedMethods(request.path));
            tell(*refusal, response);
            return httplib::Server::HandlerResponse::Handled;
        });
        http.Get("/", [](const Request&, Response& response) {
            response.set_header(
                "Content-Security-Policy",
                "default-src 'self'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src 'self' blob:");
            response.set_content(kServePage, "text/html; charset=utf-8");
        });
        http.answerAtGate("/health");
        http.Get("/health", [](const Request&, Response& response) { response.set_content("ok\n", "text/plain"); });
        http.Get("/metrics", [this](const Request&, Response& response) {
            response.set_content(metrics.text(workers.waiting(), workers.devices()), "text/plain; version=0.0.4");
        });
        http.Get("/options", [](const Request&, Response& response) {
            static const std::string schema = optionSchema("Options of GET /picture", isServed);
            response.set_content(schema, "application/schema+json");
        });
        http.Get("/picture", answer([this](const Request& request, Response& response) {
                     sendPicture(parseQuery(request), nullptr, request, response);
                 }));
        http.Post("/picture", withBody([this](const Request& request, const UnnamedFile& body, Response& response) {
                      sendPicture(parseQuery(request), &body, request, response);
                  }));
        http.Post("/structures", withBody([this](const Request&, const UnnamedFile& body, Response& response) {
                      response.set_content(jsonText({{"input", uploads.keep(body)}}), "application/json");
                  }));
        http.Get("/info", answer([this](const Request& request, Response& response) { sendInfo(request, response); }));
        http.Get(R"(/([0-9A-Za-z_.-]+\.(?:png|jpe?g|webp)))",
                 answer([this](const Request& request, Response& response) {
                     Query query = queryOfName(request.matches[1].str());
                     if (query.empty()) throw Problem(404, "no picture has this name");
                     for (auto& pair : parseQuery(request)) query.push_back(std::move(pair));
                     sendPicture(query, nullptr, request, response);
                 }));
        http.set_error_handler([](const Request& request, Response& response) {
            if (!response.body.empty()) return;
            const std::string detail = response.status == 404   ? "there is no " + request.path
                                       : response.status == 413 ? kTooLarge
                                                                : statusTitle(response.status);
            tell(Problem(response.status, detail), response);
        });
        http.set_logger([this](const Request&, const Response& response) {
            metrics.answered(response.status, response.body.size());
        });
    }

    static void tell(const Problem& problem, Response& response) {
        for (const char* ofPicture : {"ETag", "Cache-Control", "Nacre-Warning"}) response.headers.erase(ofPicture);
        response.status = problem.status;
        response.set_header("Cache-Control", "no-store");
        if (problem.status == 429 || problem.status == 503) response.set_header("Retry-After", "1");
        response.set_content(problemJson(problem.status, problem.what()), "application/problem+json");
    }

    using Handler = std::function<void(const Request&, Response&)>;
    /// Answers with a problem if the handler throws.
    Handler answer(Handler handler) {
        return [this, handler = std::move(handler)](const Request& request, Response& response) {
            const Clock::time_point start = Clock::now();
            try {
                handler(request, response);
            } catch (const Problem& problem) {
                tell(problem, response);
            } catch (const std::bad_alloc&) {
                tell(Problem(503, "out of memory"), response);
            } catch (const std::exception& error) {
                tell(Problem(500, error.what()), response);
            }
            metrics.took(millisecondsSince(start) / 1000);
        };
    }

    using BodyHandler = std::function<void(const Request&, const UnnamedFile&, Response&)>;
    /// Receives the body as bytes, whatever its content type.
    httplib::Server::HandlerWithContentReader withBody(BodyHandler handler) {
        return [this, handler = std::move(handler)](const Request& request, Response& response,
                                                    const httplib::ContentReader& read) {
            std::size_t received = 0;
            const auto leave = [&](void*) { bodies -= received; };
            const std::unique_ptr<void, decltype(leave)> held(this, leave);
            std::optional<UnnamedFile> body;
            bool room = true;
            const bool whole = read([&](const char* data, std::size_t size) {
                received += size;
                room = (bodies += size) <= kMostBodies;
                if (!room || received > kMostBodyBytes) return false;
                try {
                    if (!body) body.emplace();
                    body->append({data, size});
                } catch (const Error&) {
                    room = false;
                }
                return room;
            });
            if (whole) {
                answer([&](const Request& whose, Response& to) {
                    if (!body) throw Problem(400, "the body is empty: a structure or a saved view is expected");
                    handler(whose, *body, to);
                })(request, response);
                return;
            }
            const bool large = received > kMostBodyBytes || response.status == 413;
            if (!room)
                tell(Problem(503, "no room for the request's body"), response);
            else if (large)
                tell(Problem(413, kTooLarge), response);
            else if (response.status < 400)
                tell(Problem(400, "the body ends early, or is not encoded as its head says"), response);
        };
    }

    void sendPicture(Query query, const UnnamedFile* body, const Request& request, Response& response) {
        const std::string session = taken(query, "session");
        const bool moving = !taken(query, "moving").empty();
        const PictureRequest asked = pictureRequest(query, body, options, uploads);
        const std::string extension = fileExtension(asked.description.output);
        const std::string name = contentKey(asked.identity + program()) + extension;
        const std::string tag = "\"" + name.substr(0, 32) + "\"";
        const bool kept = !body && !moving;
        if (kept) {
            response.set_header("ETag", tag);
            // A file's content may change: must be revalidated.
            const bool file = asked.description.input.opened != nullptr;
            response.set_header("Cache-Control", file ? "no-cache" : "public, max-age=3600");
            if (request.get_header_value("If-None-Match").find(tag) != std::string::npos) {
                response.status = 304;
                return;
            }
            if (std::optional<std::string> known = store.find(name)) {
                metrics.hit();
                return response.set_content(std::move(*known), mediaType(extension));
            }
        } else {
            response.set_header("Cache-Control", "no-store");
        }
        const auto draw = [&] {
            ServedPicture picture = workers.draw(asked, moving ? session : "");
            metrics.drawn();
            if (kept && picture.asAsked) store.keep(name, picture.bytes);
            return picture;
        };
        try {
            const SharedPictures::Shared picture =
                moving ? std::make_shared<const ServedPicture>(draw()) : shared.get(name, draw);
            if (!picture->asAsked) response.headers.erase("ETag");
            addWarnings(*picture, asked.description, response);
            response.set_content(picture->bytes, mediaType(extension));
        } catch (const Problem& problem) {
            throw Problem(problem.status, forClient(problem.what(), asked.description));
        }
    }

    /// As headers; proxies accept some kilobytes.
    static void addWarnings(const ServedPicture& picture, const PictureDescription& asked, Response& response) {
        constexpr std::size_t kMost = 2048;
        std::size_t bytes = 0;
        for (const std::string& warning : picture.warnings) {
            const std::string text = printable(forClient(warning, asked));
            if ((bytes += text.size()) > kMost) return response.set_header("Nacre-Warning", "...");
            response.set_header("Nacre-Warning", text);
        }
    }

    void sendInfo(const Request& request, Response& response) {
        const PictureRequest asked = pictureRequest(parseQuery(request), nullptr, options, uploads);
        InfoOptions info;
        info.picture = asked.description;
        info.paths = {asked.description.input.path};
        info.output = InfoOptions::Output::json;
        try {
            const std::string told = workers.run([info](const std::function<void()>& check) mutable {
                info.onStep = check;
                std::ostringstream text;
                const HeardMessages heard;
                try {
                    infoCommand(info, text);
                } catch (const Error& error) {
                    throw unreadable(error, info.paths.front());
                }
                return text.str();
            });
            response.set_content(forClient(told, asked.description), "application/json");
        } catch (const Problem& problem) {
            throw Problem(problem.status, forClient(problem.what(), asked.description));
        }
    }

    /// Everything else that affects a picture's bytes.
    static const std::string& program() {
        static const std::string text = [] {
            std::ostringstream out;
            versionCommand(out);
            return out.str();
        }();
        return text;
    }

    const ServeOptions& options;
    HttpServer http{kAnswering, kConnections};
    std::atomic<std::size_t> bodies{0};  ///< bytes of bodies held by requests
    Metrics metrics;
    PictureStore store;
    Uploads uploads;
    SharedPictures shared;
    Workers workers;
    int bound = 0;
};

}  // namespace

void serveCommand(const ServeOptions& options) {
    constexpr std::chrono::seconds kGrace(8);  // container engines kill after 10
    const StopRequest stop;
    auto server = std::make_unique<Server>(options);
    std::promise<void> stopped;
    std::packaged_task<void()> serving([&] {
        server->http.serve();
        stopped.get_future().wait();
        server.reset();
    });
    std::future<void> ended = serving.get_future();
    std::thread listening = startThread(std::move(serving));
    sayNote("serving http://" + formatAddress(options, server->bound) + "/ (Ctrl C stops it)");
    while (!stop.asked() && ended.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
    }
    server->http.stop();
    stopped.set_value();
    if (ended.wait_for(kGrace) != std::future_status::ready) {
        sayNotice("stopped while pictures were still drawn");
        std::_Exit(0);  // their files have no names
    }
    listening.join();
    ended.get();
}

}  // namespace nacre::app
