// Many pictures in one process, on one device. Each thread runs all steps of a job: while some draw, the others read
// and write files.

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <thread>
#include <vector>

#include "app/cli/batch_lines.h"
#include "app/cli/commands.h"
#include "app/cli/picture_job.h"
#include "app/cli/picture_options.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "app/files/printable.h"
#include "app/files/spare_memory.h"
#include "app/movie/stop_request.h"
#include "engine/error.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

using JobJson = nlohmann::ordered_json;

/// There is no device: other jobs would fail as well.
struct NoDevice : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The renderers, made on demand and after a loss. A software device has one per thread, since the calling thread does
/// most of a small picture's work. On a GPU a few share the device: while it works for one, the host prepares bakes and
/// records frames for the others.
class Renderers {
public:
    Renderers(const DeviceOptions& options, int threads) : options_(options), threads_(threads) {}

    /// @returns whether the device was not lost; otherwise prepare the job again. @throws Error
    bool draw(PictureJob& job) {
        std::unique_ptr<Canvas> canvas = take();
        try {
            job.draw(*canvas);
        } catch (const Error&) {
            const bool lost = canvas->isLost();
            if (lost)
                dropLost(std::move(canvas));
            else
                giveBack(std::move(canvas));
            if (!lost || tooManyLosses()) throw;
            return false;
        } catch (...) {
            giveBack(std::move(canvas));
            throw;
        }
        giveBack(std::move(canvas));
        return true;
    }

private:
    std::unique_ptr<Canvas> take() {
        std::unique_lock lock(turn_);
        while (idle_.empty()) {
            idles_.wait(lock, [&] { return !idle_.empty() || atWork_ < most_; });
            if (!idle_.empty()) break;
            try {
                idle_.push_back(make());
                most_ = isSoftware(*idle_.back()) ? threads_ : std::min(threads_, kMostOfGpu);
            } catch (const NoDevice&) {
                if (atWork_ == 0) throw;
                most_ = atWork_;  // the renderers that there are go on
            }
        }
        std::unique_ptr<Canvas> canvas = std::move(idle_.back());
        idle_.pop_back();
        ++atWork_;
        idles_.notify_one();
        return canvas;
    }

    void giveBack(std::unique_ptr<Canvas> canvas) {
        const std::lock_guard lock(turn_);
        if (!canvas->isSpent()) idle_.push_back(std::move(canvas));
        --atWork_;
        idles_.notify_one();
    }

    /// Drops every canvas of a lost device. The first to report it counts the loss.
    void dropLost(std::unique_ptr<Canvas> canvas) {
        const std::shared_ptr<SharedDevice> device = canvas->renderer.device();
        canvas.reset();
        const std::lock_guard lock(turn_);
        --atWork_;
        if (lost_.lock() != device) ++losses_;
        lost_ = device;
        if (shared_ == device) shared_.reset();
        std::erase_if(idle_, [&](const auto& idle) { return idle->renderer.device() == device; });
        idles_.notify_one();
    }

    bool tooManyLosses() {
        const std::lock_guard lock(turn_);
        return losses_ > kMostLosses;
    }

    std::unique_ptr<Canvas> make() {
        try {
            if (shared_) return std::make_unique<Canvas>(shared_);
        } catch (const Error& error) {
            if (atWork_ > 0) throw NoDevice(error.what());
            shared_.reset();  // lost, perhaps
        }
        try {
            auto first = std::make_unique<Canvas>(options_);
            if (!isSoftware(*first)) shared_ = first->renderer.device();
            return first;
        } catch (const Error& error) {
            throw NoDevice(error.what());
        }
    }

    static bool isSoftware(const Canvas& canvas) { return canvas.renderer.stats().device.type == "software"; }

    static constexpr int kMostLosses = 3;  // in a batch: more are no accident
    static constexpr int kMostOfGpu = 6;   // renderers: each has its own images and pipelines
    const DeviceOptions& options_;
    const int threads_;
    std::mutex turn_;  // of all below
    std::condition_variable idles_;
    std::vector<std::unique_ptr<Canvas>> idle_;
    std::shared_ptr<SharedDevice> shared_;  // a GPU
    std::weak_ptr<SharedDevice> lost_;      // the last one
    int atWork_ = 0, most_ = 1, losses_ = 0;
};

/// Whether a job's file exists, or the job has none. An empty file does not count: it is left from a crash or another
/// program.
bool isThere(const std::string& path) {
    struct stat status {};
    return path.empty() || (stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0);
}

std::uint64_t fileSize(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

class Batch {
public:
    Batch(const BatchOptions& options, std::ostream& out)
        : options_(options),
          out_(out),
          lines_(options.path, [this] { return stopped(); }),
          renderers_(options.tried.device, options.parallel),
          files_(options.path),
          progress_(std::in_place, !isatty(STDOUT_FILENO)) {  // without progress if the jobs' lines are visible
        progress_->begin("no job done");
    }

    /// @returns whether all jobs succeeded @throws Error if stopped
    bool run() {
        // Threads of one job's tasks: others have jobs of their own, and starting one takes longer than its share of a
        // small molecule.
        setThreadsPerTask(std::max(1u, threadsPerTask() / static_cast<unsigned>(options_.parallel)));
        std::vector<std::thread> threads(static_cast<std::size_t>(options_.parallel - 1));
        for (std::thread& thread : threads)
            if (!mayStart(thread, [this] { work(); })) break;
        work();
        for (std::thread& thread : threads)
            if (thread.joinable()) thread.join();
        progress_.reset();
        if (failure_) std::rethrow_exception(failure_);
        const double seconds = millisecondsSince(start_) / 1000;
        const std::string summary = std::to_string(done_) + " jobs done, " + std::to_string(failed_) + " failed, " +
                                    std::to_string(skipped_) + " skipped, in " +
                                    std::to_string(static_cast<int>(seconds)) + " s";
        if (stop_.asked()) throw Error("stopped", options_.path, summary + " (--resume goes on)");
        if (done_ + failed_ + skipped_ > 0) sayNote(summary);
        return failed_ == 0;
    }

private:
    /// One thread's work: job after job, until there are none, it is stopped, or an error concerns all jobs.
    void work() {
        try {
            while (!stopped()) {
                const std::optional<BatchLine> line = lines_.next();
                if (!line) return;
                report(doJob(*line));
                givePicturesMemoryBack();
            }
        } catch (...) {
            const std::lock_guard lock(turn_);
            if (!failure_) failure_ = std::current_exception();
        }
    }

    bool stopped() {
        const std::lock_guard lock(turn_);
        return failure_ != nullptr || stop_.asked();
    }

    JobJson doJob(const BatchLine& line) {
        const Clock::time_point start = Clock::now();
        JobJson told = readNames(line);
        HeardMessages heard;
        try {
            const PictureDescription job = parseJob(line.whole(), options_);
            if (told["input"].is_null()) told["input"] = job.input.path;
            files_.claim(job);
            if (options_.resume && isThere(job.output) && isThere(job.layers) && isThere(job.stats) &&
                isThere(job.saveView)) {
                told["status"] = "skipped";
                return told;
            }
            draw(job);
            told["status"] = "done";
            told["ms"] = millisecondsSince(start);
            told["bytes"] = fileSize(job.output);
        } catch (const NoDevice&) {
            throw;
        } catch (const std::bad_alloc&) {
            fail(told, "out of memory", start);
        } catch (const std::exception& error) {
            fail(told, error.what(), start);
        }
        if (!heard.warnings.empty()) told["warnings"] = heard.warnings;
        if (!heard.notes.empty()) told["notes"] = heard.notes;
        return told;
    }

    /// The file names in a line, even if the line has errors.
    static JobJson readNames(const BatchLine& line) {
        JobJson told = {{"job", line.number}, {"input", nullptr}, {"output", nullptr}};
        const JobJson job = parseJson<JobJson>(line.text);
        for (const char* name : {"input", "output"})
            if (job.is_object() && job.contains(name)) told[name] = job[name];
        return told;
    }

    static void fail(JobJson& told, const std::string& why, Clock::time_point start) {
        told["status"] = "failed";
        told["ms"] = millisecondsSince(start);
        told["error"] = shortened(why);
    }

    void draw(const PictureDescription& options) {
        for (bool drawn = false; !drawn;) {
            PictureJob job(options, silent_);
            job.prepare();
            for (const std::string& warning : job.warnings()) sayWarning(warning);
            drawn = renderers_.draw(job);
            if (drawn) job.write();
        }
    }

    void report(const JobJson& told) {
        const std::string text = told.dump(-1, ' ', false, JobJson::error_handler_t::replace);
        const std::lock_guard lock(turn_);
        const std::string& status = told["status"].get_ref<const std::string&>();
        ++(status == "done" ? done_ : status == "failed" ? failed_ : skipped_);
        out_ << printableJson(text) << '\n' << std::flush;
        if (!out_) throw Error("cannot write to standard output", "", "");
        const std::uint64_t jobs = done_ + failed_ + skipped_;
        progress_->begin(std::to_string(jobs) + (jobs == 1 ? " job done" : " jobs done"));
    }

    const BatchOptions& options_;
    std::ostream& out_;
    Clock::time_point start_ = Clock::now();
    StopRequest stop_;  // running jobs are finished; a second signal ends them at once
    BatchLines lines_;
    Renderers renderers_;
    BatchFiles files_;
    Progress silent_{false};
    std::optional<Progress> progress_;
    std::mutex turn_;  // of all below
    std::uint64_t done_ = 0, failed_ = 0, skipped_ = 0;
    std::exception_ptr failure_;
};

}  // namespace

bool batchCommand(const BatchOptions& options, std::ostream& out) {
    removeUnfinishedOnSignals();  // for a second signal
    return Batch(options, out).run();
}

}  // namespace nacre::app
