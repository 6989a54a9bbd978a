#include "runtime/app/replayed_input.h"

#include <charconv>
#include <string>

namespace fulcrum::runtime {
namespace {

double notches_of(const std::string& text) {
    double notches = 0.0;
    (void)std::from_chars(text.data(), text.data() + text.size(), notches);
    return notches;
}

}  // namespace

void ReplayedInput::add_to(SessionInput& input) {
    for (; next_ < record_->events.size(); ++next_) {
        const RecordEvent& event = record_->events[next_];
        if (event.time_s > input.clock_s) {
            return;
        }
        if (event.kind == RecordEventKind::pressed) {
            input.keys.push_back(event.text);
        } else if (event.kind == RecordEventKind::wheel) {
            input.wheel += notches_of(event.text);
        } else if (event.kind == RecordEventKind::answered) {
            if (input.heard) {
                return;
            }
            input.heard = event.text;
        }
    }
}

}  // namespace fulcrum::runtime
