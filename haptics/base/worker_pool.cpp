#include "haptics/base/worker_pool.h"

#include <algorithm>
#include <system_error>

namespace fulcrum {
namespace {

constexpr int kPieceBits = 20;
constexpr std::uint64_t kPieceMask = (std::uint64_t{1} << kPieceBits) - 1;
// Of a caller whose own pieces are done: looks this often before it sleeps, for the others' end soon as well.
constexpr int kLooks = 2000;
constexpr std::uint32_t kEnd = 1;
constexpr std::uint32_t kOneRound = 2;

}  // namespace

WorkerPool::WorkerPool(int n_workers) {
    const int most = std::clamp(n_workers, 1, kMostWorkers);
    threads_.reserve(static_cast<std::size_t>(most - 1));
    try {
        for (int worker = 1; worker < most; ++worker) {
            threads_.emplace_back([this, worker] { serve(worker); });
        }
    } catch (const std::system_error&) {
        // A thread was refused: those that there are share the pieces.
        return;
    }
}

WorkerPool::~WorkerPool() {
    round_.fetch_or(kEnd, std::memory_order_acq_rel);
    round_.notify_all();
}

void WorkerPool::share_out(int n_pieces) noexcept {
    n_pieces = std::min(n_pieces, kMostPieces);
    n_left_.store(n_pieces, std::memory_order_relaxed);
    const std::uint32_t round = round_.load(std::memory_order_relaxed) + kOneRound;
    word_.store(std::uint64_t{round} << 2 * kPieceBits | static_cast<std::uint64_t>(n_pieces)
                                                             << kPieceBits,
                std::memory_order_release);
    round_.store(round, std::memory_order_release);
    round_.notify_all();
    take_pieces(0);
    for (int i = 0; i < kLooks && n_left_.load(std::memory_order_acquire) > 0; ++i) {
    }
    for (std::int32_t left = n_left_.load(std::memory_order_acquire); left > 0;
         left = n_left_.load(std::memory_order_acquire)) {
        n_left_.wait(left, std::memory_order_acquire);
    }
}

// Whoever has taken a piece of a round is in it: the round ends only when that piece is done.
void WorkerPool::take_pieces(int worker) noexcept {
    for (;;) {
        const std::uint64_t word = word_.fetch_add(1, std::memory_order_acq_rel);
        const std::uint64_t piece = word & kPieceMask;
        if (piece >= (word >> kPieceBits & kPieceMask)) {
            return;
        }
        call_(work_, static_cast<int>(piece), worker);
        if (n_left_.fetch_sub(1, std::memory_order_acq_rel) == 1) {
            n_left_.notify_one();
        }
    }
}

void WorkerPool::serve(int worker) noexcept {
    for (std::uint32_t round = round_.load(std::memory_order_acquire); (round & kEnd) == 0;
         round = round_.load(std::memory_order_acquire)) {
        take_pieces(worker);
        round_.wait(round, std::memory_order_acquire);
    }
}

}  // namespace fulcrum
