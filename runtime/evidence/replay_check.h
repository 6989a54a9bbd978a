// Does a run that repeats a record give the record's forces, bit for bit; and where it does not, where first and why likely?
//
//   round --> the record's round of the same tick --> same bits of hand, each effect's share, commanded, applied
// What differs first in the order of a round is named: a hand before an effect, an effect before the sum, the sum before what the gate
// let through. Why is read off the two headers: program, lesson, files, options, limits, plan, in this order; and of a run in real time off
// what its record cannot hold: rounds that were lost, and a tool that ended its search by the clock.
//
// Thread: that which takes the rounds from the ring. Cost: a comparison of some hundred bytes a round.
#pragma once

#include "haptics/handover/record_sample.h"
#include "haptics/record/record.h"

#include <cstdint>
#include <memory>
#include <string>

namespace fulcrum::runtime {

/// A record's fact: "real time" or "virtual".
inline constexpr const char* kClockFact = "option.clock";
inline constexpr const char* kRealTime = "real time";
/// A record's fact: what the tool had of each step, microseconds; of a run in real time alone.
inline constexpr const char* kToolTimeFact = "live.tool us";
/// Whether a record is of a run in real time and holds all that its loops were told in it.
[[nodiscard]] bool tells_all(const Record& record);

/// What of a round differs first.
enum class Difference : std::uint8_t { none, time, hand, effect, commanded, applied, state };

struct ReplayReport {
    std::uint64_t n_compared = 0;
    std::uint64_t n_different = 0;        ///< rounds whose applied force or torque differs
    double most_N = 0.0;                  ///< by how much the applied force differs at most
    Difference first = Difference::none;  ///< of the first round in which anything differs
    std::uint64_t tick = 0;               ///< that round
    double time_s = 0.0;
    std::string effect;  ///< whose share, for Difference::effect
    Wrench is_W{};       ///< what it was now ...
    Wrench was_W{};      ///< ... and in the record
    /// Never of nothing.
    [[nodiscard]] bool same() const { return n_compared > 0 && first == Difference::none; }
};

class ReplayCheck {
  public:
    /// `header`: of the run that is compared.
    ReplayCheck(std::shared_ptr<const Record> record, RecordHeader header);

    void take(const RecordRound& round);
    [[nodiscard]] const ReplayReport& report() const { return report_; }
    /// What came of it, one sentence, and where forces differ a second one on why.
    [[nodiscard]] std::string sentence() const;

  private:
    [[nodiscard]] std::string explain() const;
    void find_first(const RecordRound& round, std::size_t i);
    void differ(Difference what, const RecordSample& at, const Wrench& is_W, const Wrench& was_W,
                std::string effect = {});

    std::shared_ptr<const Record> record_;
    RecordHeader header_;
    bool has_same_effects_;
    ReplayReport report_{};
};

/// Why two runs of these headers may give other forces: the facts that differ, as a clause; what stands in one of them alone, the device
/// and who holds it are passed over. Empty where all are the same.
[[nodiscard]] std::string explain_difference(const RecordHeader& record, const RecordHeader& now);

}  // namespace fulcrum::runtime
