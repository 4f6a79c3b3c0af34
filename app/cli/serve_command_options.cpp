#include "app/cli/serve_command_options.h"

#include <algorithm>
#include <filesystem>
#include <thread>

#include "app/cli/picture_options.h"
#include "app/files/output_file.h"
#include "app/picture/option_values.h"

namespace nacre::app {
namespace {

/// "8080", "0.0.0.0:8080", "[::1]:8080". @throws std::invalid_argument
void takeAddress(const std::string& text, ServeOptions& options) {
    const std::size_t colon = text.rfind(':');
    if (colon != std::string::npos) {
        options.address = text.substr(0, colon);
        if (options.address.starts_with('[') && options.address.ends_with(']'))
            options.address = options.address.substr(1, options.address.size() - 2);
        if (options.address.empty()) throw std::invalid_argument("expected ADDRESS:PORT");
    }
    options.port = static_cast<int>(parseInteger(text.substr(colon == std::string::npos ? 0 : colon + 1), 0, 65535));
}

}  // namespace

void addServe(CommandSpec& command, ServeOptions& options) {
    options.workers = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 64u));
    options.picture.input.memoryMegabytes = 2048;
    command.value("--listen", "[ADDRESS:]PORT", "127.0.0.1:8080",
                  "Address to listen on; port 0: any free port. Only this machine can reach 127.0.0.1",
                  [&](const std::string& text) { takeAddress(text, options); });
    command.value("--root", "DIR", "none", "Folder whose files are inputs; nothing outside it is read",
                  [&](const std::string& text) {
                      if (!std::filesystem::is_directory(fileName(text)))
                          throw std::invalid_argument("'" + text + "' is not a folder");
                      options.root = text;
                  });
    command.flag("--allow-download", options.picture.input.allowDownload,
                 "Download the structures that requests name; otherwise only the cache is used");
    command.value("--jobs", "N", "one per processor", "Pictures drawn at the same time, 1 to 64",
                  [&](const std::string& text) { options.workers = static_cast<int>(parseInteger(text, 1, 64)); });
    command.value("--queue", "N", "64", "Requests that wait for a worker, 1 to 10000; more are answered with 429",
                  [&](const std::string& text) { options.queue = static_cast<int>(parseInteger(text, 1, 10000)); });
    command.value("--timeout", "S", "60", "Maximum time of a request in seconds, 1 to 3600",
                  [&](const std::string& text) { options.seconds = parseNumber(text, 1, 3600); });
    command.value(
        "--pictures", "MB|off", "256", "Disk cache of pictures, up to 1048576 MB; the least recently used are removed",
        [&](const std::string& text) { options.cacheMiB = text == "off" ? 0 : parseInteger(text, 1, 1 << 20); });
    command.value("--memory", "MB", "2048", "Memory limit for a molecule, 1 to 1048576", [&](const std::string& text) {
        options.picture.input.memoryMegabytes = parseInteger(text, 1, 1 << 20);
    });
    command.value("--cache", "DIR|off", "NACRE_CACHE, else ~/.cache/nacre",
                  "Folder for downloads, ambient occlusion and pictures",
                  [&](const std::string& text) { options.picture.input.cache = fileName(text); });
    addPicture(command, options.picture, Topic::device | Topic::path);
}

}  // namespace nacre::app
