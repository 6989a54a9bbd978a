#include "runtime/arms/haply/force_proof.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr double kMostEchoed = 1.25;  // of what was sent; more is somebody else's, or a scale

}  // namespace

Vector3 ForceProof::allow(const Vector3& wanted_N, double now_s) noexcept {
    if (verdict_ == Verdict::refused || !is_finite(wanted_N)) {
        return Vector3::Zero();
    }
    const double limit_N =
        verdict_ == Verdict::proven
            ? std::min(most_N_, kTrial_N + kRise_N_per_s * std::max(0.0, now_s - proven_s_))
            : std::min(most_N_, kTrial_N);
    const double length_N = wanted_N.norm();
    return length_N > limit_N ? Vector3(wanted_N * (limit_N / length_N)) : wanted_N;
}

void ForceProof::note_sent(const Vector3& force_N, double now_s) noexcept {
    sent_[next_] = force_N;
    next_ = (next_ + 1) % kRemembered;
    if (moved_s_ < 0.0 && (force_N - sent_then_).norm() > kMoved_N) {
        moved_s_ = now_s;
    }
}

void ForceProof::note_state(const Vector3& position_m, const Vector3& velocity_m_per_s,
                            const Vector3& echo_N, double now_s) noexcept {
    if (verdict_ == Verdict::open) {
        judge(echo_N, now_s);
    }
    note_more(echo_N);
    watch(position_m, velocity_m_per_s, echo_N, now_s);
}

// Forces of several programs add; and a service may begin to give more than it is told.
void ForceProof::note_more(const Vector3& echo_N) noexcept {
    constexpr double kMargin_N = 0.3;
    double sent_N = 0.0;
    for (const Vector3& sent : sent_) {
        sent_N = std::max(sent_N, sent.norm());
    }
    const bool is_more = echo_N.norm() > kMostEchoed * sent_N + kMargin_N;
    n_more_ = is_more ? std::min(n_more_ + 1, kMostMore) : 0;
}

bool ForceProof::is_echo(const Vector3& echo_N) const noexcept {
    constexpr double kLeast = 0.5;
    constexpr double kCosine = 0.8;
    const double length_N = echo_N.norm();
    return std::ranges::any_of(sent_, [&](const Vector3& sent) {
        const double sent_N = sent.norm();
        return sent_N >= kAsked_N && length_N >= kLeast * sent_N &&
               length_N <= kMostEchoed * sent_N && echo_N.dot(sent) >= kCosine * length_N * sent_N;
    });
}

void ForceProof::judge(const Vector3& echo_N, double now_s) noexcept {
    if (is_echo(echo_N)) {
        verdict_ = Verdict::proven;
        proven_s_ = now_s;
        return;
    }
    const bool was_asked =
        std::ranges::all_of(sent_, [](const Vector3& sent) { return sent.norm() >= kAsked_N; });
    n_waited_ += was_asked ? 1 : 0;
    if (n_waited_ < kMostStates) {
        return;
    }
    n_waited_ = 0;
    if (has_switched_) {
        verdict_ = Verdict::refused;
    } else {
        has_switched_ = true;
        word_ = other(word_);
    }
}

void ForceProof::watch(const Vector3& position_m, const Vector3& velocity_m_per_s,
                       const Vector3& echo_N, double now_s) noexcept {
    const bool is_same =
        has_state_ && position_m == position_ && velocity_m_per_s == velocity_ && echo_N == echo_;
    if (!is_same) {
        has_state_ = true;
        is_stuck_ = false;
        position_ = position_m;
        velocity_ = velocity_m_per_s;
        echo_ = echo_N;
        sent_then_ = sent_[(next_ + kRemembered - 1) % kRemembered];
        moved_s_ = -1.0;
    } else if (moved_s_ >= 0.0 && now_s - moved_s_ > kStuck_s) {
        is_stuck_ = true;
    }
}

}  // namespace fulcrum::runtime
