// Work while loading that falls into many independent pieces, on a few threads.
//
// The pieces are taken in order, so that those which cost more do not hold up the others; what each of them writes must be its
// own. The calling thread works as well, and is the only one that tells how far the work has come.
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

/// Told the share done, 0 to 1; may be empty.
using LoadProgress = std::function<void(double)>;

/// Calls work(piece) once for each of 0 to n - 1, on `n_threads` threads at most. `work` must not throw.
template <class Work>
void parallel_for(std::size_t n, std::size_t n_threads, const Work& work,
                  const LoadProgress& progress = {}) {
    constexpr std::size_t kChunk = 64;
    std::atomic<std::size_t> next{0};
    const auto take_chunk = [&]() noexcept {
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
    constexpr std::size_t kChunksBetween = 64;
    for (std::size_t i = 1; take_chunk(); ++i) {
        if (progress && i % kChunksBetween == 0) {
            progress(static_cast<double>(std::min(n, next.load(std::memory_order_relaxed))) /
                     static_cast<double>(n));
        }
    }
}

}  // namespace fulcrum
