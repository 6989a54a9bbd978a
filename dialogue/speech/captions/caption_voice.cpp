#include "dialogue/speech/captions/caption_voice.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kMostWaiting =
    16;  ///< beyond this the oldest is left out: nobody reads so far behind

double within(double value, double least, double most, double otherwise) {
    return std::isfinite(value) ? std::clamp(value, least, most) : otherwise;
}

int count_words(std::string_view text) {
    int count = 0;
    bool inside = false;
    for (const char letter : text) {
        const bool space = letter == ' ' || letter == '\n' || letter == '\t';
        count += !space && !inside ? 1 : 0;
        inside = !space;
    }
    return count;
}

}  // namespace

CaptionVoice::CaptionVoice(CaptionSettings settings) {
    const CaptionSettings usual;
    settings_.words_per_s = within(settings.words_per_s, 0.2, 10.0, usual.words_per_s);
    settings_.settle_s = within(settings.settle_s, 0.0, 10.0, usual.settle_s);
    settings_.least_s = within(settings.least_s, 0.1, 60.0, usual.least_s);
}

double CaptionVoice::reading_time_s(std::string_view text) const {
    return std::max(settings_.least_s,
                    count_words(text) / settings_.words_per_s + settings_.settle_s);
}

void CaptionVoice::say(std::string_view text) {
    if (text.empty()) {
        return;
    }
    const bool free = !speaking();
    waiting_.emplace_back(text);
    if (waiting_.size() > kMostWaiting) {
        waiting_.pop_front();
    }
    if (free) {
        next();
    }
}

void CaptionVoice::next() {
    caption_.said = std::move(waiting_.front());
    waiting_.pop_front();
    caption_.text = part_emphasis(caption_.said);
    caption_.duration_s = reading_time_s(caption_.text.plain);
    caption_.shown_s = 0.0;
}

void CaptionVoice::step(double dt_s) {
    if (!(dt_s > 0.0)) {
        return;
    }
    caption_.shown_s += dt_s;
    // A long step may pass several captions; each takes its own time.
    while (!waiting_.empty() && caption_.shown_s >= caption_.duration_s) {
        const double rest_s = caption_.shown_s - caption_.duration_s;
        next();
        caption_.shown_s = rest_s;
    }
}

void CaptionVoice::stop() {
    waiting_.clear();
    caption_ = {};
}

bool CaptionVoice::speaking() const {
    return !waiting_.empty() || caption_.shown_s < caption_.duration_s;
}

}  // namespace fulcrum::dialogue
