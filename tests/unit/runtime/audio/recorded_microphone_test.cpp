#include "runtime/audio/recorded_microphone.h"

#include <catch2/catch.hpp>

#include <array>
#include <numeric>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

struct Recording {
    double now_s = 5.0;
    std::vector<std::int16_t> samples = std::vector<std::int16_t>(1600);
    RecordedMicrophone microphone;
    std::array<std::int16_t, 4000> read{};

    explicit Recording(RecordedMicrophoneSettings settings = {})
        : microphone(counted(), with_clock(std::move(settings))) {}
    std::size_t at(double time_s) {
        now_s = 5.0 + time_s;
        return microphone.read(read).value();
    }

  private:
    std::vector<std::int16_t> counted() {
        std::iota(samples.begin(), samples.end(), std::int16_t{1});
        return samples;
    }
    RecordedMicrophoneSettings with_clock(RecordedMicrophoneSettings settings) {
        settings.now_s = [this] { return now_s; };
        return settings;
    }
};

}  // namespace

TEST_CASE(
    "recorded microphone: gives what was due since the last time, and silence behind its end") {
    Recording recording;
    CHECK(recording.at(0.0) == 0);
    CHECK(recording.at(0.01) == 160);
    CHECK(recording.read[0] == 1);
    CHECK(recording.read[159] == 160);
    CHECK(recording.at(0.01) == 0);
    CHECK(recording.at(0.03) == 320);
    CHECK(recording.read[0] == 161);
    CHECK(recording.at(0.11) == 1280);
    CHECK(recording.read[1119] == 1600);
    CHECK(recording.read[1120] == 0);
}

TEST_CASE("recorded microphone: what does not fit comes next; quicker than time when asked") {
    Recording recording({.speed = 10.0});
    CHECK(recording.at(0.1) == 4000);
    CHECK(recording.at(0.1) == 4000);
    CHECK(recording.at(0.1) == 4000);
    CHECK(recording.at(0.1) == 4000);
    CHECK(recording.at(0.1) == 0);
}

TEST_CASE("recorded microphone: unplugged at its time, and for good") {
    Recording recording({.unplugged_at_s = 0.5});
    CHECK(recording.at(0.25) == 4000);
    recording.now_s = 5.5;
    CHECK_FALSE(recording.microphone.read(recording.read));
    recording.now_s = 6.0;
    const auto gone = recording.microphone.read(recording.read);
    REQUIRE_FALSE(gone);
    CHECK(to_sentence(gone.error()).find("unplugged") != std::string::npos);
}
