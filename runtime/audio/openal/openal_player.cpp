#include "runtime/audio/openal/openal_player.h"

#define AL_ALEXT_PROTOTYPES
#include "runtime/audio/force_sound.h"
#include "runtime/audio/openal/openal_stream.h"
#include "runtime/audio/openal/quiet_backends.h"
#include "runtime/audio/sound_bank.h"
#include "runtime/audio/synthesis.h"
#include "runtime/audio/wav.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kStopFade_s = 0.02;
/// Below this the force sound's source is paused: nobody hears it, and the mixer rests.
constexpr double kInaudible = 1e-4;
constexpr double kForceLoudness = 0.5;

struct CloseDevice {
    void operator()(ALCdevice* device) const { alcCloseDevice(device); }
};
struct DestroyContext {
    void operator()(ALCcontext* context) const {
        if (alcGetCurrentContext() == context) {
            alcMakeContextCurrent(nullptr);
        }
        alcDestroyContext(context);
    }
};
using Device = std::unique_ptr<ALCdevice, CloseDevice>;
using Context = std::unique_ptr<ALCcontext, DestroyContext>;

struct Voice {
    ALuint source = 0;
    std::uint64_t started = 0;  ///< order of plays; the smallest is the oldest
    double gain = 0.0;
    double fade_left_s = -1.0;  ///< of a stop; negative when not stopping
};

/// Everything but the way of opening: voices, buffers, the force sound.
class OpenalVoices {
  public:
    OpenalVoices(Device device, Context context, const StreamQueue& queue)
        : device_(std::move(device)),
          context_(std::move(context)),
          queue_(queue),
          tells_leaving_(alcIsExtensionPresent(device_.get(), "ALC_EXT_disconnect") == ALC_TRUE) {}
    OpenalVoices(const OpenalVoices&) = delete;
    OpenalVoices& operator=(const OpenalVoices&) = delete;

    ~OpenalVoices() {
        use();
        stream_.reset();
        for (const Voice& voice : voices_) {
            alSourceStop(voice.source);
            alDeleteSources(1, &voice.source);
        }
        if (force_source_ != 0) {
            alSourceStop(force_source_);
            alDeleteSources(1, &force_source_);
        }
        end_speech();
        if (speech_.source != 0) {
            alDeleteSources(1, &speech_.source);
        }
        for (const auto& [name, buffer] : buffers_) {
            alDeleteBuffers(1, &buffer);
        }
    }

    void set_volume(double gain) {
        use();
        const double part = std::isfinite(gain) ? std::clamp(gain, 0.0, 1.0) : 1.0;
        alListenerf(AL_GAIN, static_cast<ALfloat>(part * master_gain_));
    }

    /// Makes sources and uploads the sounds; false when OpenAL could not.
    bool prepare(const std::vector<BankedSound>& bank, const SoundSettings& settings) {
        use();
        alGetError();
        master_gain_ = settings.master_gain;
        set_volume(1.0);
        for (const BankedSound& sound : bank) {
            buffers_[sound.name] = upload(sound.samples);
        }
        for (Voice& voice : voices_) {
            alGenSources(1, &voice.source);
            alSourcei(voice.source, AL_SOURCE_RELATIVE, AL_TRUE);
        }
        alGenSources(1, &speech_.source);
        alSourcei(speech_.source, AL_SOURCE_RELATIVE, AL_TRUE);
        if (settings.force_sound) {
            buffers_[""] = upload(synthesise_force_loop());
            alGenSources(1, &force_source_);
            alSourcei(force_source_, AL_SOURCE_RELATIVE, AL_TRUE);
            alSourcei(force_source_, AL_LOOPING, AL_TRUE);
            alSourcei(force_source_, AL_BUFFER, static_cast<ALint>(buffers_[""]));
        }
        return alGetError() == AL_NO_ERROR;
    }

    Expected<void> play(std::string_view name, double gain, double pitch) {
        const auto found = name.empty() ? buffers_.end() : buffers_.find(name);
        if (found == buffers_.end()) {
            return tl::unexpected(unknown_sound(name));
        }
        if (auto checked = check_play(gain, pitch); !checked) {
            return checked;
        }
        use();
        Voice& voice = free_voice();
        voice.started = ++plays_;
        voice.gain = gain;
        voice.fade_left_s = -1.0;
        alSourceStop(voice.source);
        alSourcei(voice.source, AL_BUFFER, static_cast<ALint>(found->second));
        alSourcef(voice.source, AL_GAIN, static_cast<ALfloat>(gain));
        alSourcef(voice.source, AL_PITCH, static_cast<ALfloat>(pitch));
        alSourcePlay(voice.source);
        return {};
    }

    void set_force(double force_N) { force_target_N_ = audible_force_N(force_N); }

    void set_stream(SoundStream* stream) {
        use();
        stream_.reset();
        if (stream != nullptr) {
            stream_.emplace(*stream, queue_);
        }
    }

    void speak(std::span<const float> samples) {
        use();
        end_speech();
        if (samples.empty()) {
            return;
        }
        speech_buffer_ = upload(samples);
        speech_.gain = 1.0;
        speech_.fade_left_s = -1.0;
        alSourcei(speech_.source, AL_BUFFER, static_cast<ALint>(speech_buffer_));
        alSourcef(speech_.source, AL_GAIN, 1.0F);
        alSourcePlay(speech_.source);
    }

    /// Whether its device is still there, where OpenAL can tell.
    [[nodiscard]] bool is_connected() const {
        ALCint is_there = ALC_TRUE;
        if (tells_leaving_) {
            alcGetIntegerv(device_.get(), ALC_CONNECTED, 1, &is_there);
        }
        return is_there != ALC_FALSE;
    }

    void hush() { speech_.fade_left_s = is_speaking() ? kStopFade_s : -1.0; }

    [[nodiscard]] bool is_speaking() const {
        use();
        ALint state = 0;
        alGetSourcei(speech_.source, AL_SOURCE_STATE, &state);
        return state == AL_PLAYING;
    }

    void update(double dt_s) {
        use();
        update_force(dt_s);
        if (stream_) {
            stream_->update();
        }
        const double dt = std::isfinite(dt_s) ? std::max(dt_s, 0.0) : 0.0;
        for (Voice& voice : voices_) {
            fade(voice, dt);
        }
        fade(speech_, dt);
    }

    void stop() {
        force_target_N_ = 0.0;
        for (Voice& voice : voices_) {
            voice.fade_left_s = kStopFade_s;
        }
        hush();
    }

    void render(float* to, std::size_t n_frames) {
        alcRenderSamplesSOFT(device_.get(), to, static_cast<ALCsizei>(n_frames));
    }

  private:
    void use() const {
        if (alcGetCurrentContext() != context_.get()) {
            alcMakeContextCurrent(context_.get());
        }
    }

    // Its source keeps no sound that nobody wants.
    void end_speech() {
        if (speech_buffer_ != 0) {
            alSourceStop(speech_.source);
            alSourcei(speech_.source, AL_BUFFER, 0);
            alDeleteBuffers(1, &speech_buffer_);
            speech_buffer_ = 0;
        }
    }

    static ALuint upload(std::span<const float> samples) {
        const std::vector<std::int16_t> pcm = to_pcm16(samples);
        ALuint buffer = 0;
        alGenBuffers(1, &buffer);
        alBufferData(buffer, AL_FORMAT_MONO16, pcm.data(),
                     static_cast<ALsizei>(pcm.size() * sizeof(std::int16_t)), kSampleRate_Hz);
        return buffer;
    }

    /// A voice that is to stop goes down in a straight line; it ends one update after it became silent, so
    /// that the mixer has ramped to zero by then.
    static void fade(Voice& voice, double dt_s) {
        if (voice.fade_left_s < 0.0) {
            return;
        }
        if (voice.fade_left_s == 0.0) {
            alSourceStop(voice.source);
            voice.fade_left_s = -1.0;
            return;
        }
        voice.fade_left_s = std::max(voice.fade_left_s - dt_s, 0.0);
        const double left = voice.fade_left_s / kStopFade_s;
        alSourcef(voice.source, AL_GAIN, static_cast<ALfloat>(voice.gain * left));
    }

    /// A voice that is silent, or else the one that has played longest.
    Voice& free_voice() {
        for (Voice& voice : voices_) {
            ALint state = 0;
            alGetSourcei(voice.source, AL_SOURCE_STATE, &state);
            if (state != AL_PLAYING) {
                return voice;
            }
        }
        return *std::min_element(
            voices_.begin(), voices_.end(),
            [](const Voice& a, const Voice& b) { return a.started < b.started; });
    }

    void update_force(double dt_s) {
        if (force_source_ == 0) {
            return;
        }
        force_N_ = follow(force_N_, force_target_N_, dt_s);
        const double gain = kForceLoudness * force_gain(force_N_);
        const bool audible = gain > kInaudible;
        alSourcef(force_source_, AL_GAIN, static_cast<ALfloat>(audible ? gain : 0.0));
        alSourcef(force_source_, AL_PITCH, static_cast<ALfloat>(force_pitch(force_N_)));
        if (audible != force_playing_) {
            audible ? alSourcePlay(force_source_) : alSourceStop(force_source_);
            force_playing_ = audible;
        }
    }

    Device device_;                                       // goes last
    Context context_;                                     // goes before its device
    std::map<std::string, ALuint, std::less<>> buffers_;  ///< "" is the force sound
    std::array<Voice, kVoices> voices_{};
    std::uint64_t plays_ = 0;
    Voice speech_;
    ALuint speech_buffer_ = 0;
    StreamQueue queue_;
    double master_gain_ = 1.0;
    bool tells_leaving_;
    std::optional<OpenalStream> stream_;
    ALuint force_source_ = 0;
    bool force_playing_ = false;
    double force_target_N_ = 0.0;
    double force_N_ = 0.0;
};

/// The SoundPlayer face, for a device (Base is SoundPlayer) or by loopback.
template <class Base>
class OpenalPlayer : public Base {
  public:
    OpenalPlayer(Device device, Context context, const StreamQueue& queue)
        : voices(std::move(device), std::move(context), queue) {}
    Expected<void> play(std::string_view name, double gain, double pitch) override {
        return voices.play(name, gain, pitch);
    }
    void set_force_sound(double force_N) override { voices.set_force(force_N); }
    void set_volume(double gain) override { voices.set_volume(gain); }
    void set_stream(SoundStream* stream) override { voices.set_stream(stream); }
    void speak(std::span<const float> samples) override { voices.speak(samples); }
    void hush() override { voices.hush(); }
    [[nodiscard]] bool is_speaking() const override { return voices.is_speaking(); }
    void update(double dt_s) override { voices.update(dt_s); }
    void stop() override { voices.stop(); }
    [[nodiscard]] bool audible() const override { return voices.is_connected(); }

    OpenalVoices voices;
};

class Loopback final : public OpenalPlayer<LoopbackPlayer> {
  public:
    using OpenalPlayer::OpenalPlayer;
    std::vector<float> render(std::size_t n_frames) override {
        std::vector<float> samples(2 * n_frames);
        voices.render(samples.data(), n_frames);
        return samples;
    }
};

Error no_sound(const char* why) {
    return {std::string("sound is off: ") + why, {}, "plug in a sound card or go on without sound"};
}

template <class Player>
Expected<std::unique_ptr<Player>> finish_opening(Device device, const ALCint* attributes,
                                                 const StreamQueue& queue,
                                                 const SoundSettings& settings) {
    const auto bank = make_bank(settings);
    if (!bank) {
        return tl::unexpected(bank.error());
    }
    Context context(alcCreateContext(device.get(), attributes));
    if (!context || alcMakeContextCurrent(context.get()) == ALC_FALSE) {
        return tl::unexpected(no_sound("the sound card could not be used"));
    }
    auto player = std::make_unique<Player>(std::move(device), std::move(context), queue);
    if (!player->voices.prepare(*bank, settings)) {
        return tl::unexpected(no_sound("the sound card took no sounds"));
    }
    return player;
}

}  // namespace

Expected<std::unique_ptr<SoundPlayer>> open_openal_device(const SoundSettings& settings) {
    quieten_backends();
    ask_for_short_periods();
    Device device(alcOpenDevice(nullptr));
    if (!device) {
        return tl::unexpected(no_sound("no sound card was found"));
    }
    auto player = finish_opening<OpenalPlayer<SoundPlayer>>(std::move(device), nullptr,
                                                            kThreadedQueue, settings);
    if (!player) {
        return tl::unexpected(player.error());
    }
    return std::unique_ptr<SoundPlayer>(std::move(*player));
}

Expected<std::unique_ptr<LoopbackPlayer>> open_openal_loopback(const SoundSettings& settings) {
    quieten_backends();
    if (alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback") == ALC_FALSE) {
        return tl::unexpected(no_sound("this OpenAL has no loopback"));
    }
    Device device(alcLoopbackOpenDeviceSOFT(nullptr));
    if (!device) {
        return tl::unexpected(no_sound("the loopback device did not open"));
    }
    // Plain stereo floats: no head model, no limiter, so that what comes out is what went in.
    constexpr std::array<ALCint, 11> kAttributes{ALC_FREQUENCY,
                                                 kSampleRate_Hz,
                                                 ALC_FORMAT_CHANNELS_SOFT,
                                                 ALC_STEREO_SOFT,
                                                 ALC_FORMAT_TYPE_SOFT,
                                                 ALC_FLOAT_SOFT,
                                                 ALC_HRTF_SOFT,
                                                 ALC_FALSE,
                                                 ALC_OUTPUT_LIMITER_SOFT,
                                                 ALC_FALSE,
                                                 0};
    auto player =
        finish_opening<Loopback>(std::move(device), kAttributes.data(), kUpdatedQueue, settings);
    if (!player) {
        return tl::unexpected(player.error());
    }
    return std::unique_ptr<LoopbackPlayer>(std::move(*player));
}

}  // namespace fulcrum::runtime
