// Work while loading that falls into many independent pieces, on a few threads.
//
// The pieces are taken in order, so that those which cost more do not hold up the others; what each of them writes must be its
// own. The calling thread works as well, and is the only one that tells how far the work has come: after each 64 pieces of its own,
// and where they take long every 50 ms. A piece that may take longer than that asks within itself, and ends early where it is told.
//
// Thread: load; returns when all is done. Cost: one atomic count a chunk of pieces.
#pragma once

#include "haptics/base/load_progress.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <type_traits>
#include <vector>

namespace fulcrum {

/// What a piece of work asks whether it should go on.
class WorkWatch {
  public:
    /// `pulse` is null but on the calling thread.
    WorkWatch(std::atomic<bool>& is_stopped, LoadPulse* pulse,
              const std::atomic<std::size_t>& begun, std::size_t n) noexcept
        : is_stopped_(is_stopped), pulse_(pulse), begun_(begun), n_(n) {}

    /// `soon` false asks at once. What is told must not throw.
    [[nodiscard]] bool goes_on(bool soon = true) noexcept {
        if (pulse_ != nullptr) {
            const double share =
                static_cast<double>(std::min(n_, begun_.load(std::memory_order_relaxed))) /
                static_cast<double>(n_);
            if (!(soon ? pulse_->goes_on(share) : pulse_->goes_on_now(share))) {
                is_stopped_.store(true, std::memory_order_relaxed);
            }
        }
        return !is_stopped_.load(std::memory_order_relaxed);
    }

  private:
    std::atomic<bool>& is_stopped_;
    LoadPulse* pulse_;
    const std::atomic<std::size_t>& begun_;
    std::size_t n_;
};

template <class Work>
void do_piece(const Work& work, std::size_t piece, WorkWatch& watch) {
    if constexpr (std::is_invocable_v<const Work&, std::size_t, WorkWatch&>) {
        work(piece, watch);
    } else {
        work(piece);
    }
}

/// Calls work(piece), or work(piece, watch), once for each of 0 to n - 1, on `n_threads` threads at most. False where it was stopped: then
/// some pieces are not done. What a piece throws on whatever thread is thrown here, once no thread works any more.
template <class Work>
bool parallel_for(std::size_t n, std::size_t n_threads, const Work& work,
                  const LoadProgress& progress = {}) {
    constexpr std::size_t kChunk = 64;
    std::atomic<std::size_t> next{0};
    std::atomic<bool> is_stopped{false};
    std::atomic<bool> has_failed{false};
    std::exception_ptr failure;
    const auto take_chunk = [&](WorkWatch& watch) noexcept {
        const std::size_t first = next.fetch_add(kChunk, std::memory_order_relaxed);
        try {
            for (std::size_t i = first; i < std::min(n, first + kChunk); ++i) {
                if (!watch.goes_on()) {
                    return false;
                }
                do_piece(work, i, watch);
            }
        } catch (...) {
            if (!has_failed.exchange(true)) {
                failure = std::current_exception();
            }
            is_stopped.store(true, std::memory_order_relaxed);
        }
        return first + kChunk < n;
    };
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(n_threads, n / kChunk + 1); ++i) {
        others.emplace_back([&] {
            WorkWatch watch(is_stopped, nullptr, next, n);
            while (take_chunk(watch)) {
            }
        });
    }
    LoadPulse pulse(progress);
    WorkWatch watch(is_stopped, &pulse, next, n);
    while (take_chunk(watch) && watch.goes_on(false)) {
    }
    others.clear();
    if (failure) {
        std::rethrow_exception(failure);
    }
    return !is_stopped.load(std::memory_order_relaxed);
}

}  // namespace fulcrum
