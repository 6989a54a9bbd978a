#include "runtime/audio/openal/openal_stream.h"

#include "runtime/audio/waveform.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {

OpenalStream::OpenalStream(SoundStream& stream)
    : stream_(stream), samples_(kStreamBuffer), pcm_(kStreamBuffer) {
    alGenSources(1, &source_);
    alSourcei(source_, AL_SOURCE_RELATIVE, AL_TRUE);
    alGenBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
    for (const ALuint buffer : buffers_) {
        fill(buffer);
    }
    alSourcePlay(source_);
}

OpenalStream::~OpenalStream() {
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
