#include "runtime/audio/openal/openal_microphone.h"

#include "dialogue/speech/word_graph.h"
#include "haptics/base/clock.h"
#include "runtime/audio/openal/quiet_backends.h"

#define AL_ALEXT_PROTOTYPES
#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr double kPatience_s = 2.0;
constexpr ALCsizei kHeld_samples =
    dialogue::kHeardRate_Hz;  // a second, for a thread that comes late

struct CloseCapture {
    void operator()(ALCdevice* device) const {
        alcCaptureStop(device);
        alcCaptureCloseDevice(device);
    }
};
using Capture = std::unique_ptr<ALCdevice, CloseCapture>;

class OpenalMicrophone final : public Microphone {
  public:
    explicit OpenalMicrophone(Capture device)
        : device_(std::move(device)),
          tells_leaving_(alcIsExtensionPresent(device_.get(), "ALC_EXT_disconnect") == ALC_TRUE),
          last_heard_s_(monotonic_now_s()) {
        alcCaptureStart(device_.get());
    }

    Expected<std::size_t> read(std::span<std::int16_t> samples) override {
        ALCint is_there = ALC_TRUE;
        if (tells_leaving_) {
            alcGetIntegerv(device_.get(), ALC_CONNECTED, 1, &is_there);
        }
        ALCint waiting = 0;
        alcGetIntegerv(device_.get(), ALC_CAPTURE_SAMPLES, 1, &waiting);
        const double now_s = monotonic_now_s();
        if (waiting > 0) {
            last_heard_s_ = now_s;
        }
        if (is_there == ALC_FALSE || now_s - last_heard_s_ > kPatience_s) {
            return fail("the microphone was unplugged", {}, "plug it in again, or type");
        }
        const auto n = std::min(static_cast<std::size_t>(std::max(waiting, 0)), samples.size());
        alcCaptureSamples(device_.get(), samples.data(), static_cast<ALCsizei>(n));
        return n;
    }

  private:
    Capture device_;
    bool tells_leaving_;
    double last_heard_s_;
};

Expected<std::unique_ptr<Microphone>> open_microphone() {
    Capture device(
        alcCaptureOpenDevice(nullptr, dialogue::kHeardRate_Hz, AL_FORMAT_MONO16, kHeld_samples));
    if (!device) {
        return fail("no microphone was found", {}, "plug one in, or type");
    }
    return std::make_unique<OpenalMicrophone>(std::move(device));
}

}  // namespace

OpenMicrophone microphone_opener() {
    quieten_backends();  // sets variables of the environment, which other threads read
    ask_for_short_periods();
    return open_microphone;
}

}  // namespace fulcrum::runtime
