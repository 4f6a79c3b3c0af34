#pragma once
// Pictures over HTTP/1.1; docs/serve.md describes the interface.

#include <memory>

#include "app/serve/serve_options.h"

namespace nacre::app {

class Server {
public:
    /// Binds its port. @param options  outlives this @throws Error if there is no device, or the port is taken
    explicit Server(const ServeOptions& options);
    ~Server();

    int port() const;
    /// Answers requests until stop(). Finishes pictures in progress.
    void run();
    /// Thread-safe.
    void stop();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// `nacre serve`: until SIGINT or SIGTERM. @throws Error
void serveCommand(const ServeOptions& options);

}  // namespace nacre::app
