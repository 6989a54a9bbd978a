// Any bytes at all as a WAV file: heard or refused, never a crash, a leak or a number out of range.
#include "runtime/audio/resample.h"
#include "runtime/audio/wav.h"
#include "tests/fuzz/promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    const auto sound =
        fulcrum::runtime::read_wav({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!sound) {
        require(sound.error().message.rfind("it is no WAV file", 0) == 0);
        require(!sound.error().what_to_do.empty());
        return 0;
    }
    require(sound->rate_Hz >= 4000 && sound->rate_Hz <= 192'000);
    for (const float sample : sound->samples) {
        require(sample >= -1.0F && sample <= 1.0F);
    }
    // A recogniser hears it at its own rate.
    constexpr std::size_t kSome = 64;
    const std::span some(sound->samples.data(), std::min(sound->samples.size(), kSome));
    for (const float sample : fulcrum::runtime::resample(some, sound->rate_Hz, 16'000)) {
        require(std::isfinite(sample));
    }
    return 0;
}
