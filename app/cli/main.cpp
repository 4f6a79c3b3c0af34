// The headless command line: 0 done, 1 failed with one line on standard error, 2 wrong usage.

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/loopback.h"
#include "app/cli/options.h"
#include "app/files/messages.h"
#include "app/files/notices.h"
#include "app/files/printable.h"
#ifdef NACRE_DESKTOP
#include "app/desktop/view_command.h"
#endif
#include "app/serve/server.h"
#ifdef NACRE_XR
#include "app/xr/xr_command.h"
#endif
#include "engine/devices.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

int complain(const std::string& text, int code) {
    sayError(text);
    return code;
}

void run(const CommandLine& line, std::ostream& out) {
    switch (line.command) {
        case Command::help:
            out << line.help;
            break;
        case Command::version:
            versionCommand(out);
            break;
        case Command::notices:
            out << notices();
            break;
        case Command::render:
            renderCommand(line.render);
            break;
        case Command::movie:
            movieCommand(line.movie);
            break;
        case Command::batch:
            if (!batchCommand(line.batch, std::cout)) throw Error("batch", line.batch.path, "not all jobs are done");
            break;
        case Command::serve:
#ifdef NACRE_LOOPBACK
            listenAnywhere();  // its option sets the address
#endif
            serveCommand(line.serve);
            break;
        case Command::figure:
            figureCommand(line.figure);
            break;
        case Command::looks:
            looksCommand(line.looks, out);
            break;
        case Command::exporting:
            exportCommand(line.exported);
            break;
        case Command::view:
#ifdef NACRE_DESKTOP
            viewCommand(line.view);
#endif
            break;
        case Command::xr:
#ifdef NACRE_XR
            xrCommand(line.view.first);
#endif
            break;
        case Command::bench:
            benchCommand(line.bench, out);
            break;
        case Command::plan:
            planCommand(line.plan, out);
            break;
        case Command::info:
            infoCommand(line.info, out);
            break;
        case Command::devices:
            devicesCommand(line.devices, out);
            break;
    }
}

/// Prints a command's output, even if it failed afterwards.
void print(const CommandLine& line) {
    std::ostringstream out;
    std::exception_ptr failure;
    try {
        run(line, out);
    } catch (...) {
        failure = std::current_exception();
    }
    const bool own = line.command == Command::help || line.command == Command::notices;
    std::cout << (own ? out.str() : printableLines(out.str())) << std::flush;
    if (failure) std::rethrow_exception(failure);
}

int complete(int argc, char** argv) {
    try {
        const CommandLine line = parseCommandLine(argc, argv);
        if (line.quiet) beQuiet();
        if (line.verbose) beVerbose();
        print(line);
        if (!std::cout) return complain("cannot write to standard output", 1);
        return 0;
    } catch (const UsageError& error) {
        const std::string_view why = error.what();
        const bool usage = why.starts_with("usage: ");
        return complain((usage ? "" : "wrong usage: ") + std::string(why) + " (see --help)", 2);
    } catch (const std::bad_alloc&) {
        constexpr std::string_view kText = "nacre: error: out of memory\n";  // without memory
        [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kText.data(), kText.size());
        return 1;
    } catch (const std::exception& error) {
        return complain(error.what(), 1);
    }
}

/// Prevents the loader from loading Mesa's GPU drivers if the kernel has none: they would only report no device.
void skipDriversWithoutDevices() {
#ifdef __linux__
    if (access("/dev/dri", F_OK) == 0 || access("/dev/kgsl-3d0", F_OK) == 0 || access("/dev/dxg", F_OK) == 0) return;
    constexpr int kKeep = 0;  // the user's choice
    setenv("VK_LOADER_DRIVERS_DISABLE",
           "intel_icd*,intel_hasvk_icd*,radeon_icd*,nouveau_icd*,broadcom_icd*,freedreno_icd*,panfrost_icd*,asahi_icd*",
           kKeep);
#endif
}

}  // namespace
}  // namespace nacre::app

int main(int argc, char** argv) {
    nacre::app::skipDriversWithoutDevices();
    nacre::letDriversTuneHeap();
#ifdef NACRE_LOOPBACK
    nacre::app::listenOnLoopbackAlone();
#endif
    return nacre::app::complete(argc, argv);
}
