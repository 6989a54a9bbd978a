#include "runtime/app/key_hand.h"

#include <algorithm>

namespace fulcrum::runtime {

void KeyHand::hold_by(bool left_handed) {
    keys_ = left_handed ? kOfRightHand : kOfLeftHand;
    release();
}

std::string list_hand_keys(bool left_handed) {
    const KeyHand::Keys& keys = left_handed ? KeyHand::kOfRightHand : KeyHand::kOfLeftHand;
    std::string list;
    for (std::size_t way = 0; way < KeyHand::button; ++way) {
        list += (way == 0 ? "" : ", ") + label_at(keys[way][0]);
    }
    return list;
}

void KeyHand::release() {
    held_ = {};
    speed_ = 0.0;
}

double KeyHand::step_px(const PictureSize& size, double dt_s) const {
    const double speed =
        speed_ > 0.0 ? std::min(speed_ + settings_.growth * dt_s, settings_.quick) : settings_.slow;
    return speed * dt_s * size.height_px;
}

void KeyHand::take_keys(WindowEvents& events, bool types) {
    for (const KeyPress& press : events.pressed) {
        const auto key = std::ranges::find(keys_, press.place.empty() ? press.key : press.place);
        if (key != keys_.end() && !press.repeat && !types && !press.control && !press.alt) {
            held_[static_cast<std::size_t>(key - keys_.begin())] = true;
        }
        events.wheel += press.key == "page_up" ? 1.0 : press.key == "page_down" ? -1.0 : 0.0;
    }
    for (const std::string& name : events.released_places) {
        const auto key = std::ranges::find(keys_, name);
        if (key != keys_.end()) {
            held_[static_cast<std::size_t>(key - keys_.begin())] = false;
        }
    }
}

void KeyHand::take(WindowEvents& events, bool types, const PictureSize& size, double dt_s) {
    if (events.lost_focus) {
        release();
    }
    take_keys(events, types);
    if (events.pointer_moved) {
        pointer_px_.reset();
    }
    const auto along = [&](Way less, Way more) {
        return (held_[more] ? 1.0 : 0.0) - (held_[less] ? 1.0 : 0.0);
    };
    const Vector2 way(along(left, right), along(up, down));
    if (way.isZero()) {
        speed_ = 0.0;
    } else {
        const Vector2 from =
            pointer_px_.value_or(Vector2(events.pointer_x_px, events.pointer_y_px));
        const double step = step_px(size, dt_s);
        speed_ = speed_ > 0.0 ? std::min(speed_ + settings_.growth * dt_s, settings_.quick)
                              : settings_.slow;
        const Vector2 most(std::max(size.width_px, 1), std::max(size.height_px, 1));
        pointer_px_ = (from + step * way.normalized()).cwiseMax(0.0).cwiseMin(most);
    }
    if (pointer_px_) {
        events.pointer_x_px = pointer_px_->x();
        events.pointer_y_px = pointer_px_->y();
    }
    events.button_down[0] = events.button_down[0] || held_[button];
}

}  // namespace fulcrum::runtime
