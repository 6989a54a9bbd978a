// A few threads that stand ready and share pieces of work which come again and again, as the islands of a world do each step.
//
// The caller works as well. Pieces are taken by counting one word up, in which the round, the number of pieces and the next piece
// stand together: who wakes too late finds nothing left, and nobody is waited for but those who work on a piece.
//
// Thread: `run` on one thread, which waits for the others' pieces: never the haptic one. Cost: with one piece or one thread that of a
// loop; else some microseconds to wake the others. No allocation after construction.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace fulcrum {

class WorkerPool {
  public:
    static constexpr int kMostWorkers = 16;
    static constexpr int kMostPieces = 1 << 19;

    /// With the caller `n_workers` work, 1 to kMostWorkers; fewer where the system gives no more threads: the result is the same.
    explicit WorkerPool(int n_workers);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    [[nodiscard]] int n_workers() const noexcept { return static_cast<int>(threads_.size()) + 1; }

    /// Calls work(piece, worker) once for each piece from 0 to n_pieces - 1, at most kMostPieces, and returns when all are done. `worker`
    /// is from 0 to n_workers - 1, and no two pieces at a time have the same. Must not throw.
    template <class Work>
    void run(int n_pieces, const Work& work) noexcept {
        if (n_pieces <= 1 || threads_.empty()) {
            for (int piece = 0; piece < n_pieces; ++piece) {
                work(piece, 0);
            }
            return;
        }
        call_ = [](const void* of, int piece, int worker) noexcept {
            (*static_cast<const Work*>(of))(piece, worker);
        };
        work_ = &work;
        share_out(n_pieces);
    }

  private:
    void share_out(int n_pieces) noexcept;
    void take_pieces(int worker) noexcept;
    void serve(int worker) noexcept;

    // Written by the caller before a round; read by who has taken a piece of it.
    void (*call_)(const void*, int, int) noexcept = nullptr;
    const void* work_ = nullptr;
    alignas(64) std::atomic<std::uint64_t> word_{
        0};  // 24 bits of the round, 20 of the number of pieces, 20 of the next one
    alignas(64) std::atomic<std::int32_t> n_left_{0};  // pieces not done
    // Bit 0: the end; above it the round. One word: who has read it as not ended sleeps on what the end changes.
    alignas(64) std::atomic<std::uint32_t> round_{0};
    std::vector<std::jthread> threads_;
};

}  // namespace fulcrum
