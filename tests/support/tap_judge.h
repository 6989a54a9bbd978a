// Tells what a hand has tapped from what was sent to it on its way, by the nearest of taps that it knows.
//
//   sent_i = sum_k c_k depth_(i-k) + a exp(-B t_i) sin(2 pi f t_i)      t_i: the middle of round i; a > 0
// The first part is how a linear contact answers the hand's way, whoever holds the handle; the rest is what rings. f and B are those of a
// grid that leave least, and a tap's place is (log f, log B, log sum c): pitch, decay and stiffness. For as long as the hand is in, and
// without the first round, of whose way before nothing is known.
#pragma once

#include "haptics/link/felt_judge.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::test {

inline constexpr double kTapRound_s = 0.001;

/// Along what is tapped, in the rounds from the touch on.
struct TapForces {
    std::vector<double> asked_N, sent_N;
    std::vector<double> depth_m;         ///< how deep the hand is
    bool clips = false;                  ///< more was asked for than the limit
    FeltLimit broken = FeltLimit::none;  ///< first, of what a record of all rounds would tell
};

/// How much of what was asked for was sent: of the squares between 20 and 400 Hz, as a tap is felt.
[[nodiscard]] double find_share_sent(const TapForces& forces);

struct TapTraits {
    double frequency_Hz = 0.0;
    double decay_per_s = 0.0;
    double stiffness_N_per_m = 0.0;
};
/// What was asked for is not looked at. All 1 of one that nothing touched.
[[nodiscard]] TapTraits find_traits(const TapForces& forces);

class TapJudge {
  public:
    void learn(const std::string& material, const TapForces& forces) {
        known_.emplace_back(material, find_traits(forces));
    }
    /// The material of the nearest tap that it has learnt; empty where there is none.
    [[nodiscard]] std::string tell(const TapForces& forces) const;

  private:
    std::vector<std::pair<std::string, TapTraits>> known_;
};

}  // namespace fulcrum::test
