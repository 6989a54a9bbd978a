#include "runtime/audio/voice/speech_maker.h"

#include "runtime/audio/resample.h"
#include "runtime/audio/wav.h"
#include "runtime/audio/waveform.h"
#include "runtime/files/run_program.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostWav_bytes = 16'000'000;  // three minutes at 44 kHz
constexpr double kMostProgram_s = 10.0;
constexpr std::size_t kMostKept = 8;

// What a program gave, ready to be heard.
Expected<std::vector<float>> make_speech(const VoiceSettings& settings, std::string_view text,
                                         const std::atomic<bool>& cancelled) {
    return run_program({make_voice_words(settings, text), kMostWav_bytes, kMostProgram_s},
                       cancelled)
        .and_then([](const std::string& wav) { return read_wav(wav); })
        .map([](const WavSound& sound) {
            return resample(sound.samples, sound.rate_Hz, kSampleRate_Hz);
        });
}

}  // namespace

struct SpeechMaker::Shop {
    VoiceSettings settings;
    mutable std::mutex mutex;
    std::condition_variable asked;
    std::deque<std::string> waiting;
    std::deque<MadeSpeech> ready;
    std::deque<MadeSpeech> kept;  // the newest last
    bool busy = false;
    bool ends = false;
    std::string trouble;
    bool told_trouble = false;
    std::uint64_t round = 0;  // forgotten so often
    std::atomic<bool> cancelled{false};
    std::thread thread;

    void work() {
        std::unique_lock lock(mutex);
        while (!ends) {
            if (waiting.empty()) {
                asked.wait(lock);
                continue;
            }
            MadeSpeech made{std::move(waiting.front()), {}};
            waiting.pop_front();
            const std::uint64_t its_round = round;
            busy = true;
            cancelled.store(false, std::memory_order_release);
            lock.unlock();
            auto samples = make_speech(settings, made.text, cancelled);
            lock.lock();
            busy = false;
            if (its_round != round) {
                continue;
            }
            if (samples) {
                made.samples = std::move(*samples);
                keep(made);
            } else if (!told_trouble) {
                told_trouble = true;
                trouble = to_sentence(samples.error());
            }
            ready.push_back(std::move(made));
        }
    }

    void keep(const MadeSpeech& made) {
        kept.push_back(made);
        if (kept.size() > kMostKept) {
            kept.pop_front();
        }
    }
};

SpeechMaker::SpeechMaker(const VoiceSettings& settings) : shop_(std::make_unique<Shop>()) {
    shop_->settings = settings;
    shop_->thread = std::thread([shop = shop_.get()] { shop->work(); });
}

SpeechMaker::~SpeechMaker() {
    {
        const std::lock_guard lock(shop_->mutex);
        shop_->ends = true;
        shop_->cancelled.store(true, std::memory_order_release);
    }
    shop_->asked.notify_all();
    shop_->thread.join();
}

void SpeechMaker::ask(std::string_view text) {
    {
        const std::lock_guard lock(shop_->mutex);
        const auto found = std::ranges::find(shop_->kept, text, &MadeSpeech::text);
        if (found != shop_->kept.end() && shop_->waiting.empty() && !shop_->busy) {
            shop_->ready.push_back(*found);
            return;
        }
        shop_->waiting.emplace_back(text);
    }
    shop_->asked.notify_all();
}

std::optional<MadeSpeech> SpeechMaker::take() {
    const std::lock_guard lock(shop_->mutex);
    if (shop_->ready.empty()) {
        return {};
    }
    std::optional<MadeSpeech> made(std::move(shop_->ready.front()));
    shop_->ready.pop_front();
    return made;
}

void SpeechMaker::forget() {
    const std::lock_guard lock(shop_->mutex);
    shop_->waiting.clear();
    shop_->ready.clear();
    ++shop_->round;
    shop_->cancelled.store(true, std::memory_order_release);
}

int SpeechMaker::n_waiting() const {
    const std::lock_guard lock(shop_->mutex);
    return static_cast<int>(shop_->waiting.size() + shop_->ready.size()) + (shop_->busy ? 1 : 0);
}

std::string SpeechMaker::take_trouble() {
    const std::lock_guard lock(shop_->mutex);
    return std::exchange(shop_->trouble, {});
}

}  // namespace fulcrum::runtime
