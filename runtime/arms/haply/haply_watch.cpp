#include "runtime/arms/haply/haply_watch.h"

#include "runtime/arms/haply/haply_judge.h"

#include <cmath>

namespace fulcrum::runtime {
namespace {

constexpr double kScaleWait_s = 0.9;  // less than until it is asked again
constexpr double kScaleChange = 1.0e-6;

}  // namespace

void HaplyWatch::begin(const HaplyArm& arm, std::optional<double> force_scale, double now_s) {
    asked_s_ = now_s;
    answered_s_ = now_s;
    query_ = {};
    find(find_haply_change(first_, arm));
    compare(force_scale);
}

bool HaplyWatch::is_due(double now_s) {
    if (now_s - asked_s_ < kAskAgain_s) {
        return false;
    }
    asked_s_ = now_s;
    if (!scale_path_.empty() && force_scale_) {
        query_.begin(scale_path_, port_, now_s + kScaleWait_s);
    }
    return true;
}

void HaplyWatch::note(const HaplyArm& arm, double now_s) {
    find(find_haply_change(first_, arm));
    if (arm.config) {
        answered_s_ = now_s;
    } else if (now_s - answered_s_ > kUnanswered_s) {
        find("whether it tells its settings");
    }
}

void HaplyWatch::step() {
    if (query_.state() != HttpQuery::State::waits || query_.step() != HttpQuery::State::done) {
        return;
    }
    // One that fails is asked again; the stream itself tells whether the service is there.
    const HttpAnswer answer = query_.answer();
    if (answer.status == 200) {
        compare(parse_haply_force_scale(answer.body));
    }
}

void HaplyWatch::find(const std::string& change) {
    if (change_.empty()) {
        change_ = change;
    }
}

void HaplyWatch::compare(std::optional<double> force_scale) {
    if (force_scale_ && force_scale && std::abs(*force_scale_ - *force_scale) > kScaleChange) {
        find("the scale of forces");
    }
}

}  // namespace fulcrum::runtime
