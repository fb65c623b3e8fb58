// One piece of slow work on a thread of its own: it hands back a value, shows how far it is, and is given up at once when
// nobody wants it any more.
#pragma once

#include "core/render/progress.h"

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <thread>

namespace reflectance::explorer {

template <class T> class Worker {
public:
    /// Looks at progress.cancel often and gives nothing where it is set.
    using Work = std::function<std::optional<T>(Progress& progress)>;

    /// `wake` is called from the thread when the work is done.
    explicit Worker(std::function<void()> wake) : wake_(std::move(wake)) {}
    ~Worker() { cancel(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Gives up what still runs and starts this.
    void start(Work work)
    {
        cancel();
        job_ = std::make_unique<Job>();
        job_->thread = std::jthread([this, job = job_.get(), work = std::move(work)] {
            job->promise.set_value(work(job->progress));
            wake_();
        });
    }

    /// Waits until the work has noticed.
    void cancel()
    {
        if (job_)
            job_->progress.cancel = true;
        job_.reset();
    }

    [[nodiscard]] bool busy() const { return job_ != nullptr; }
    [[nodiscard]] double done() const { return job_ ? job_->progress.done.load() : 0.0; } ///< 0 .. 1

    /// The result, once; never a cancelled one.
    [[nodiscard]] std::optional<T> take()
    {
        if (!job_ || job_->future.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return std::nullopt;
        std::optional<T> result = job_->future.get();
        job_.reset();
        return result;
    }

private:
    struct Job {
        Progress progress;
        std::promise<std::optional<T>> promise;
        std::future<std::optional<T>> future = promise.get_future();
        std::jthread thread; // last: joined before what it uses goes
    };
    std::function<void()> wake_;
    std::unique_ptr<Job> job_;
};

} // namespace reflectance::explorer
