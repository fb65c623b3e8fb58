// Loops and conveyors over all cores. What they compute never depends on the number of threads: ranges have a fixed
// size, and results are taken over in order.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace reflectance {

/// How many threads to use: `wanted`, or one per core where it is 0.
[[nodiscard]] inline int threadsFor(int wanted)
{
    return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Runs work() on that many threads, this one among them, until all have returned; throws what the first of them threw.
template <class Work> void onThreads(int threads, const Work& work)
{
    std::exception_ptr failure;
    std::once_flag isFirst;
    const auto guarded = [&] {
        try {
            work();
        } catch (...) {
            std::call_once(isFirst, [&] { failure = std::current_exception(); });
        }
    };
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < threads; ++i)
            others.emplace_back(guarded);
        guarded();
    }
    if (failure)
        std::rethrow_exception(failure);
}

/// Calls body(range, first, last) for 0 .. count in ranges of `length`, from several threads.
template <class Body> void inRanges(int threads, std::size_t count, std::size_t length, const Body& body)
{
    const std::size_t ranges = (count + length - 1) / length;
    std::atomic<std::size_t> next{0};
    onThreads(static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(threads), ranges)), [&] {
        for (std::size_t i = next++; i < ranges; i = next++)
            body(i, i * length, std::min(count, (i + 1) * length));
    });
}

/// A conveyor: take(item) fetches the next item, one at a time, and is false at the end; work(item) runs on several
/// threads; give(item) takes the result over, one at a time and in the order of taking, and is false to stop all.
/// Each thread has one Item, which keeps its buffers from turn to turn.
template <class Item, class Take, class Work, class Give>
void inOrder(int threads, const Take& take, const Work& work, const Give& give)
{
    std::mutex taking;
    std::mutex giving;
    std::condition_variable isTurn;
    std::size_t taken = 0;
    std::size_t given = 0;
    std::atomic<bool> isStopped = false;
    const auto stop = [&] {
        const std::lock_guard lock(giving);
        isStopped = true;
        isTurn.notify_all();
    };
    const auto turn = [&](Item& item) {
        std::unique_lock takes(taking);
        if (isStopped || !take(item))
            return false;
        const std::size_t number = taken++;
        takes.unlock();
        work(item);
        std::unique_lock gives(giving);
        isTurn.wait(gives, [&] { return isStopped || given == number; });
        if (!isStopped && !give(item))
            isStopped = true;
        ++given;
        isTurn.notify_all();
        return !isStopped;
    };
    onThreads(threads, [&] {
        try {
            Item item;
            bool goesOn = true;
            while (goesOn)
                goesOn = turn(item);
        } catch (...) {
            stop();
            throw;
        }
    });
}

} // namespace reflectance
