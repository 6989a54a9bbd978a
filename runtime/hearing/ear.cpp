#include "runtime/hearing/ear.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kLook_s = 0.01;
constexpr double kSwitchedOff_s = 4.0;      // of zeros: a room is never so quiet
constexpr double kFall = 0.9;               // of the level, a block
constexpr std::size_t kMostUtterances = 4;  // nobody took: the oldest goes
constexpr std::size_t kMostEarTroubles = 16;
constexpr std::size_t kRead = 8 * kBlock;
constexpr int kMostReads = 16;  // at once

// 0 to 1 on a scale of decibels.
double level_of(std::span<const std::int16_t, kBlock> block) {
    double sum = 0.0;
    for (const std::int16_t sample : block) {
        const double x = sample / 32768.0;
        sum += x * x;
    }
    const double mean = sum / static_cast<double>(kBlock);
    const double level_dB = mean > 0.0 ? 10.0 * std::log10(mean) : Ear::kQuietest_dB;
    return std::clamp(1.0 - level_dB / Ear::kQuietest_dB, 0.0, 1.0);
}

}  // namespace

struct Ear::Work {
    Work(const GateSettings& settings, OpenMicrophone opener, double again_s)
        : gate(settings), open(std::move(opener)), retry_s(again_s) {}

    UtteranceGate gate;
    OpenMicrophone open;
    double retry_s;

    // Written by who asks.
    std::atomic<bool> wanted{false};
    std::atomic<bool> held{false};
    std::atomic<bool> speaks{false};
    // Written by the thread.
    std::atomic<bool> has_microphone{true};
    std::atomic<bool> hears{false};
    std::atomic<bool> deaf{false};
    std::atomic<double> level{0.0};

    std::mutex mutex;
    std::condition_variable end_asked;
    bool ends = false;
    std::deque<std::vector<std::int16_t>> utterances;
    std::deque<std::string> troubles;

    // The thread's own.
    std::unique_ptr<Microphone> microphone;
    std::vector<std::int16_t> part;  // of a block
    double zeros_s = 0.0;
    bool told_missing = false;
    bool told_zeros = false;
    std::thread thread;

    void run() {
        while (sleep(microphone || open_microphone() ? kLook_s : retry_s)) {
            if (microphone) {
                hear_all();
            }
        }
        microphone.reset();
    }

    // False when it is to end.
    bool sleep(double time_s) {
        std::unique_lock lock(mutex);
        return !end_asked.wait_for(lock, std::chrono::duration<double>(time_s),
                                   [this] { return ends; });
    }

    bool open_microphone() {
        auto opened = open();
        if (!opened) {
            lose(opened.error());
            return false;
        }
        microphone = std::move(*opened);
        told_zeros = false;
        zeros_s = 0.0;
        part.clear();
        return true;
    }

    void lose(const Error& error) {
        microphone.reset();
        has_microphone.store(false, std::memory_order_release);
        hears.store(false, std::memory_order_release);
        level.store(0.0, std::memory_order_release);
        if (!std::exchange(told_missing, true)) {
            tell(to_sentence(error));
        }
    }

    // What has come, yet not for ever: a source that gives more than a second a second must not keep the thread from its end.
    void hear_all() {
        std::array<std::int16_t, kRead> read{};
        for (int i = 0; i < kMostReads; ++i) {
            const auto n = microphone->read(read);
            if (!n) {
                lose(n.error());
                return;
            }
            if (*n == 0) {
                return;
            }
            part.insert(part.end(), read.begin(), read.begin() + static_cast<std::ptrdiff_t>(*n));
            std::size_t at = 0;
            for (; at + kBlock <= part.size(); at += kBlock) {
                hear(std::span<const std::int16_t, kBlock>(part.data() + at, kBlock));
            }
            part.erase(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(at));
        }
    }

    void hear(std::span<const std::int16_t, kBlock> block) {
        has_microphone.store(true, std::memory_order_release);
        told_missing = false;
        auto utterance = gate.step(
            block, {wanted.load(std::memory_order_acquire), held.load(std::memory_order_acquire),
                    speaks.load(std::memory_order_acquire)});
        hears.store(gate.hears(), std::memory_order_release);
        deaf.store(gate.deaf(), std::memory_order_release);
        level.store(std::max(level_of(block), kFall * level.load(std::memory_order_relaxed)),
                    std::memory_order_release);
        look_for_zeros(block);
        if (utterance) {
            const std::lock_guard lock(mutex);
            utterances.push_back(std::move(*utterance));
            if (utterances.size() > kMostUtterances) {
                utterances.pop_front();
            }
        }
    }

    void look_for_zeros(std::span<const std::int16_t, kBlock> block) {
        const bool is_zero = std::ranges::all_of(block, [](std::int16_t x) { return x == 0; });
        zeros_s = is_zero ? zeros_s + kBlock_s : 0.0;
        if (zeros_s > kSwitchedOff_s && !std::exchange(told_zeros, true)) {
            tell(to_sentence(
                {"the microphone gives no sound", {}, "switch it on, choose another, or type"}));
        }
    }

    void tell(const std::string& sentence) {
        const std::lock_guard lock(mutex);
        if (troubles.size() < kMostEarTroubles) {
            troubles.push_back(sentence);
        }
    }
};

Ear::Ear(const GateSettings& settings, OpenMicrophone open, double retry_s)
    : work_(std::make_unique<Work>(settings, std::move(open), retry_s)) {
    work_->thread = std::thread([work = work_.get()] { work->run(); });
}

Ear::~Ear() {
    {
        const std::lock_guard lock(work_->mutex);
        work_->ends = true;
    }
    work_->end_asked.notify_all();
    work_->thread.join();
}

void Ear::listen(bool wanted) {
    work_->wanted.store(wanted, std::memory_order_release);
    if (!wanted) {
        const std::lock_guard lock(work_->mutex);
        work_->utterances.clear();
    }
}

void Ear::hold(bool down) {
    work_->held.store(down, std::memory_order_release);
}

void Ear::speak(bool speaks) {
    work_->speaks.store(speaks, std::memory_order_release);
}

EarState Ear::state() const {
    return {work_->has_microphone.load(std::memory_order_acquire),
            work_->hears.load(std::memory_order_acquire),
            work_->deaf.load(std::memory_order_acquire),
            work_->level.load(std::memory_order_acquire)};
}

std::optional<std::vector<std::int16_t>> Ear::take() {
    const std::lock_guard lock(work_->mutex);
    if (work_->utterances.empty()) {
        return {};
    }
    std::optional<std::vector<std::int16_t>> utterance(std::move(work_->utterances.front()));
    work_->utterances.pop_front();
    return utterance;
}

std::string Ear::take_trouble() {
    const std::lock_guard lock(work_->mutex);
    if (work_->troubles.empty()) {
        return {};
    }
    std::string trouble = std::move(work_->troubles.front());
    work_->troubles.pop_front();
    return trouble;
}

}  // namespace fulcrum::runtime
