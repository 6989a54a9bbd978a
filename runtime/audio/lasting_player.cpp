#include "runtime/audio/lasting_player.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {
namespace {

constexpr double kLook_s = 0.5;
constexpr double kFirstTry_s = 2.0;
constexpr double kMostWait_s = 60.0;

}  // namespace

void LastingPlayer::set_stream(SoundStream* stream) {
    stream_ = stream;
    player().set_stream(stream);
}

void LastingPlayer::set_volume(double gain) {
    volume_ = gain;
    player().set_volume(gain);
}

void LastingPlayer::update(double dt_s) {
    player().update(dt_s);
    since_s_ += std::isfinite(dt_s) ? std::max(dt_s, 0.0) : 0.0;
    if (heard_ && since_s_ >= kLook_s) {
        look_for_card();
    } else if (!heard_ && since_s_ >= wait_s_) {
        try_again();
    }
}

void LastingPlayer::look_for_card() {
    since_s_ = 0.0;
    if (heard_->audible()) {
        return;
    }
    heard_->set_stream(nullptr);
    heard_.reset();
    silent_->set_stream(stream_);
    wait_s_ = kFirstTry_s;
    notice_ =
        "The sound card is gone, so nothing is heard; plug it in again, or go on without sound.";
}

void LastingPlayer::try_again() {
    since_s_ = 0.0;
    wait_s_ = std::min(2.0 * wait_s_, kMostWait_s);
    auto opened = open_();
    if (!opened) {
        return;
    }
    silent_->set_stream(nullptr);
    heard_ = std::move(*opened);
    heard_->set_volume(volume_);
    heard_->set_stream(stream_);
    notice_ = "There is a sound card again.";
}

}  // namespace fulcrum::runtime
