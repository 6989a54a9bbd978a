#include "runtime/audio/openal/openal_stream.h"

#include "runtime/audio/waveform.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fulcrum::runtime {
namespace {

// Below the length of a buffer, so that none waits for more than one look.
constexpr std::chrono::milliseconds kLook{2};

}  // namespace

OpenalStream::OpenalStream(SoundStream& stream, const StreamQueue& queue)
    : stream_(stream), buffers_(queue.n_buffers), samples_(queue.n_samples), pcm_(queue.n_samples) {
    alGenSources(1, &source_);
    alSourcei(source_, AL_SOURCE_RELATIVE, AL_TRUE);
    alGenBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
    for (const ALuint buffer : buffers_) {
        fill(buffer);
    }
    alSourcePlay(source_);
    if (queue.own_thread) {
        thread_ = std::thread([this] {
            while (!ends_.load(std::memory_order_acquire)) {
                refill();
                std::this_thread::sleep_for(kLook);
            }
        });
    }
}

OpenalStream::~OpenalStream() {
    ends_.store(true, std::memory_order_release);
    if (thread_.joinable()) {
        thread_.join();
    }
    alSourceStop(source_);
    alSourcei(source_, AL_BUFFER, 0);
    alDeleteSources(1, &source_);
    alDeleteBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
}

void OpenalStream::fill(ALuint buffer) {
    stream_.render(samples_);
    std::ranges::transform(samples_, pcm_.begin(), [](float x) {
        return static_cast<std::int16_t>(std::lround(std::clamp(x, -1.0F, 1.0F) * 32767.0F));
    });
    alBufferData(buffer, AL_FORMAT_MONO16, pcm_.data(),
                 static_cast<ALsizei>(pcm_.size() * sizeof(std::int16_t)), kSampleRate_Hz);
    alSourceQueueBuffers(source_, 1, &buffer);
}

void OpenalStream::update() {
    if (!thread_.joinable()) {
        refill();
    }
}

void OpenalStream::refill() {
    ALint heard = 0;
    alGetSourcei(source_, AL_BUFFERS_PROCESSED, &heard);
    for (; heard > 0; --heard) {
        ALuint buffer = 0;
        alSourceUnqueueBuffers(source_, 1, &buffer);
        fill(buffer);
    }
    ALint state = 0;
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    if (state != AL_PLAYING) {
        alSourcePlay(source_);
    }
}

}  // namespace fulcrum::runtime
