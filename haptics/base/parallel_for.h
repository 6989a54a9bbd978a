// Work while loading that falls into many independent pieces, on a few threads.
//
// The pieces are taken in order, so that those which cost more do not hold up the others; what each of them writes must be its
// own. The calling thread works as well, and is the only one that tells how far the work has come: after each 64 pieces of its own.
//
// Thread: load; returns when all is done. Cost: one atomic count a chunk of pieces.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace fulcrum {

/// Told the share done, 0 to 1; false stops the work. May be empty.
using LoadProgress = std::function<bool(double)>;

/// Calls work(piece) once for each of 0 to n - 1, on `n_threads` threads at most. `work` must not throw. False where it was
/// stopped: then some pieces are not done.
template <class Work>
bool parallel_for(std::size_t n, std::size_t n_threads, const Work& work,
                  const LoadProgress& progress = {}) {
    constexpr std::size_t kChunk = 64;
    std::atomic<std::size_t> next{0};
    std::atomic<bool> is_stopped{false};
    const auto take_chunk = [&]() noexcept {
        if (is_stopped.load(std::memory_order_relaxed)) {
            return false;
        }
        const std::size_t first = next.fetch_add(kChunk, std::memory_order_relaxed);
        for (std::size_t i = first; i < std::min(n, first + kChunk); ++i) {
            work(i);
        }
        return first + kChunk < n;
    };
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(n_threads, n / kChunk + 1); ++i) {
        others.emplace_back([&] {
            while (take_chunk()) {
            }
        });
    }
    while (take_chunk()) {
        if (progress) {
            const std::size_t n_begun = std::min(n, next.load(std::memory_order_relaxed));
            const bool goes_on = progress(static_cast<double>(n_begun) / static_cast<double>(n));
            is_stopped.store(!goes_on, std::memory_order_relaxed);
        }
    }
    others.clear();
    return !is_stopped.load(std::memory_order_relaxed);
}

}  // namespace fulcrum
