#include "runtime/hearing/utterance_gate.h"

#include "dialogue/speech/word_graph.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {
namespace {

bool within(double value, double low, double high) {
    return value >= low && value <= high;
}

std::size_t samples_in(double time_s) {
    return static_cast<std::size_t>(time_s * dialogue::kHeardRate_Hz);
}

}  // namespace

Expected<void> validate(const GateSettings& settings) {
    const bool good = within(settings.before_s, 0.0, 2.0) && within(settings.pause_s, 0.1, 5.0) &&
                      within(settings.release_s, 0.0, 2.0) && within(settings.least_s, 0.0, 2.0) &&
                      within(settings.most_s, 1.0, 60.0) && within(settings.ring_s, 0.0, 2.0);
    if (!good) {
        return fail("a time of what is heard is out of its range", {},
                    "give 0 to 2 s, for a pause 0.1 to 5 s, for the longest utterance 1 to 60 s");
    }
    return validate(settings.voice);
}

std::optional<std::vector<std::int16_t>> UtteranceGate::step(
    std::span<const std::int16_t, kBlock> block, const GateInput& input) {
    // The program's own voice says nothing of the room's noise either.
    if (input.speaks) {
        deaf_s_ = settings_.ring_s;
    } else {
        deaf_s_ -= std::min(deaf_s_, kBlock_s);
    }
    if (input.speaks || deaf()) {
        forget();
        return {};
    }
    const bool is_speech = activity_.step(block);
    before_.insert(before_.end(), block.begin(), block.end());
    while (before_.size() > samples_in(settings_.before_s) + kBlock) {
        before_.pop_front();
    }
    if (!input.wanted) {
        hears_ = false;
        onset_ = 0;
        was_held_ = input.held;
        return {};
    }
    if (!hears_) {
        if (begins(input, is_speech)) {
            hears_ = true;
            quiet_s_ = 0.0;
            spoken_s_ = settings_.mode == ListenMode::always ? kOnset * kBlock_s : 0.0;
            heard_.assign(before_.begin(), before_.end());
            last_ = 0;
            note(is_speech);
        }
        return {};
    }
    heard_.insert(heard_.end(), block.begin(), block.end());
    note(is_speech);
    if (!ends(input, is_speech)) {
        return {};
    }
    hears_ = false;
    onset_ = 0;
    if (spoken_s_ < settings_.least_s) {
        return {};
    }
    return cut_out();
}

// A key that was down before anybody listened has to go down again.
bool UtteranceGate::begins(const GateInput& input, bool is_speech) {
    onset_ = is_speech ? onset_ + 1 : 0;
    const bool pressed = input.held && !was_held_;
    was_held_ = input.held;
    return settings_.mode == ListenMode::hold ? pressed : onset_ >= kOnset;
}

bool UtteranceGate::ends(const GateInput& input, bool is_speech) {
    was_held_ = input.held;
    const bool goes_on = settings_.mode == ListenMode::hold ? input.held : is_speech;
    const double patience_s =
        settings_.mode == ListenMode::hold ? settings_.release_s : settings_.pause_s;
    quiet_s_ = goes_on ? 0.0 : quiet_s_ + kBlock_s;
    spoken_s_ += goes_on ? kBlock_s : 0.0;
    return quiet_s_ >= patience_s || heard_.size() >= samples_in(settings_.most_s);
}

void UtteranceGate::note(bool is_speech) {
    if (is_speech) {
        first_ = last_ == 0 ? heard_.size() - std::min(heard_.size(), kOnset * kBlock) : first_;
        last_ = heard_.size();
    }
}

std::vector<std::int16_t> UtteranceGate::cut_out() {
    std::vector<std::int16_t> heard = std::exchange(heard_, {});
    if (last_ > 0) {
        const std::size_t margin = samples_in(settings_.before_s);
        heard.resize(std::min(heard.size(), last_ + margin));
        const std::size_t cut = first_ - std::min(first_, margin);
        heard.erase(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(cut));
    }
    return heard;
}

// What was heard of the program's own voice goes too; a key that is held still counts when it is over.
void UtteranceGate::forget() {
    hears_ = false;
    was_held_ = false;
    onset_ = 0;
    before_.clear();
    heard_.clear();
}

}  // namespace fulcrum::runtime
