// Many pictures by one process and one device. Each thread takes a job through all its steps: while one draws, the
// others read and write theirs, or draw, too, where the device is the processor.

#include <sys/stat.h>

#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <unordered_set>
#include <vector>

#include "app/cli/batch_options.h"
#include "app/cli/commands.h"
#include "app/cli/picture_job.h"
#include "app/shared/json_text.h"
#include "app/shared/messages.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

using JobJson = nlohmann::ordered_json;

constexpr std::size_t kLongestLine = 1 << 20;

struct Line {
    std::uint64_t number;  ///< 1-based
    std::string text;
};

/// The lines of a file or of standard input, one at a time.
class Lines {
public:
    /// @throws Error
    explicit Lines(const std::string& path) : path_(path), in_(path == "-" ? std::cin : file_) {
        if (path == "-") return;
        std::error_code error;
        if (std::filesystem::is_directory(path, error)) throw Error("cannot read jobs", path, "it is a folder");
        file_.open(path, std::ios::binary);
        if (!file_) throw Error("cannot read jobs", path, std::strerror(errno));
    }

    /// The next line that is not empty; none at the end. @throws Error
    std::optional<Line> next() {
        const std::lock_guard lock(turn_);
        for (std::string text; readLine(text);)
            if (text.find_first_not_of(" \t\r") != std::string::npos) return Line{number_, std::move(text)};
        return std::nullopt;
    }

private:
    /// std::getline() takes whatever length there is.
    bool readLine(std::string& text) {
        text.clear();
        ++number_;
        char c = 0;
        while (in_.get(c) && c != '\n') {
            if (text.size() == kLongestLine)
                throw Error("cannot read jobs", path_, "a line has more than 1 MB", number_);
            text.push_back(c);
        }
        return in_ || !text.empty();
    }

    std::string path_;
    std::ifstream file_;
    std::istream& in_;
    std::mutex turn_;
    std::uint64_t number_ = 0;
};

/// There is no device: no other job needs to try.
struct NoDevice : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The renderers, made when jobs want them and anew after a loss: one of a GPU; of a device that computes on the
/// processor one a thread, since most of a small picture is done by the thread that asks for it.
class Renderers {
public:
    Renderers(const DeviceOptions& options, int threads) : options_(options), threads_(threads) {}

    /// @returns whether the device was there to the end; if not, the job is to be prepared again. @throws Error
    bool draw(PictureJob& job) {
        std::unique_ptr<Renderer> renderer = take();
        try {
            job.draw(*renderer);
        } catch (const Error&) {
            const bool lost = !renderer->deviceLoss().empty();
            if (lost) renderer.reset();
            giveBack(std::move(renderer), lost);
            if (!lost || tooManyLosses()) throw;
            return false;
        } catch (...) {
            giveBack(std::move(renderer));
            throw;
        }
        giveBack(std::move(renderer));
        return true;
    }

private:
    std::unique_ptr<Renderer> take() {
        std::unique_lock lock(turn_);
        idles_.wait(lock, [&] { return !idle_.empty() || atWork_ < most_; });
        if (idle_.empty()) {
            idle_.push_back(make());
            if (idle_.back()->stats().device.type == "software") most_ = threads_;
        }
        std::unique_ptr<Renderer> renderer = std::move(idle_.back());
        idle_.pop_back();
        ++atWork_;
        idles_.notify_one();
        return renderer;
    }

    void giveBack(std::unique_ptr<Renderer> renderer, bool lost = false) {
        const std::lock_guard lock(turn_);
        if (renderer) idle_.push_back(std::move(renderer));
        --atWork_;
        if (lost) ++losses_;
        idles_.notify_one();
    }

    bool tooManyLosses() {
        const std::lock_guard lock(turn_);
        return losses_ > kMostLosses;
    }

    std::unique_ptr<Renderer> make() {
        try {
            return std::make_unique<Renderer>(options_);
        } catch (const Error& error) {
            throw NoDevice(error.what());
        }
    }

    static constexpr int kMostLosses = 3;  // in a batch: more are no accident
    const DeviceOptions& options_;
    const int threads_;
    std::mutex turn_;  // of all below
    std::condition_variable idles_;
    std::vector<std::unique_ptr<Renderer>> idle_;
    int atWork_ = 0, most_ = 1, losses_ = 0;
};

bool isThere(const std::string& path) {
    struct stat status {};
    return path.empty() || (stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode));
}

std::uint64_t bytesOf(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

class Batch {
public:
    Batch(const BatchOptions& options, std::ostream& out)
        : options_(options), out_(out), lines_(options.path), renderers_(options.tried.device, options.parallel) {}

    bool run() {
        std::vector<std::thread> threads;
        for (int i = 1; i < options_.parallel; ++i) threads.emplace_back([this] { work(); });
        work();
        for (std::thread& thread : threads) thread.join();
        if (failure_) std::rethrow_exception(failure_);
        if (const double seconds = millisecondsSince(start_) / 1000; done_ + failed_ + skipped_ > 0)
            sayNote(std::to_string(done_) + " jobs done, " + std::to_string(failed_) + " failed, " +
                    std::to_string(skipped_) + " left out, in " + std::to_string(static_cast<int>(seconds)) + " s");
        return failed_ == 0;
    }

private:
    /// What one thread does: job after job, until there are none, or something fails that concerns them all.
    void work() {
        try {
            while (!stopped()) {
                const std::optional<Line> line = lines_.next();
                if (!line) return;
                report(doJob(*line));
            }
        } catch (...) {
            const std::lock_guard lock(turn_);
            if (!failure_) failure_ = std::current_exception();
        }
    }

    bool stopped() {
        const std::lock_guard lock(turn_);
        return failure_ != nullptr;
    }

    JobJson doJob(const Line& line) {
        const Clock::time_point start = Clock::now();
        JobJson told = {{"job", line.number}};
        try {
            const RenderOptions job = jobOf(line.text, options_);
            told["input"] = job.input.path;
            told["output"] = job.output;
            claim(job);
            if (options_.resume && isThere(job.output) && isThere(job.layers) && isThere(job.stats)) {
                told["status"] = "skipped";
                return told;
            }
            draw(job, told);
            told["status"] = "done";
            told["ms"] = millisecondsSince(start);
            told["bytes"] = bytesOf(job.output);
        } catch (const NoDevice&) {
            throw;
        } catch (const std::bad_alloc&) {
            fail(told, "out of memory", start);
        } catch (const std::exception& error) {
            fail(told, error.what(), start);
        }
        return told;
    }

    static void fail(JobJson& told, const std::string& why, Clock::time_point start) {
        told["status"] = "failed";
        told["ms"] = millisecondsSince(start);
        told["error"] = why;
    }

    void draw(const RenderOptions& options, JobJson& told) {
        for (bool drawn = false; !drawn;) {
            PictureJob job(options, silent_);
            job.prepare();
            drawn = renderers_.draw(job);
            if (!drawn) continue;
            job.write();
            if (!job.warnings().empty()) told["warnings"] = job.warnings();
        }
    }

    /// Two jobs of one file would each undo the other's work. @throws UsageError
    void claim(const RenderOptions& job) {
        const std::lock_guard lock(turn_);
        std::vector<std::size_t> places;
        for (const auto& [name, path] :
             {std::pair{"output", &job.output}, {"layers", &job.layers}, {"stats", &job.stats}}) {
            if (path->empty()) continue;
            places.push_back(std::hash<std::string>{}(placeOf(*path)));
            if (outputs_.count(places.back()))
                throw UsageError("\"" + std::string(name) + "\": an earlier job has the same file: " + *path);
        }
        outputs_.insert(places.begin(), places.end());
    }

    /// Where a file is, whatever leads there.
    static std::string placeOf(const std::string& path) {
        std::error_code error;
        const std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(path), error);
        return error ? path : place.string();
    }

    void report(const JobJson& told) {
        const std::string text = told.dump(-1, ' ', false, JobJson::error_handler_t::replace);
        const std::lock_guard lock(turn_);
        const std::string& status = told["status"].get_ref<const std::string&>();
        ++(status == "done" ? done_ : status == "failed" ? failed_ : skipped_);
        out_ << printableJson(text) << '\n' << std::flush;
        if (!out_) throw Error("cannot write to standard output", "", "");
    }

    const BatchOptions& options_;
    std::ostream& out_;
    Clock::time_point start_ = Clock::now();
    Lines lines_;
    Renderers renderers_;
    Progress silent_{false};
    std::mutex turn_;  // of all below
    std::unordered_set<std::size_t> outputs_;
    std::uint64_t done_ = 0, failed_ = 0, skipped_ = 0;
    std::exception_ptr failure_;
};

}  // namespace

bool batchCommand(const BatchOptions& options, std::ostream& out) { return Batch(options, out).run(); }

}  // namespace nacre::app
