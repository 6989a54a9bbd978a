// Why a force is felt at one moment: each effect's share of it, and what the limits and the gate took away.
//
//   sum of the effects = asked for,   asked for + limit + gate = felt          up to the rounding of a sum
//   limit  what |asked| > max takes: asked (max / |asked| - 1); nothing while a fault or a closed gate holds, for then the gate
//          takes all
//   gate   the rest: slower than asked for after a start, or a fade
//   share in per cent: 100 (part . felt) / |felt|^2, so that all of them together are 100; a part across the force has none
//
// Thread: any but the haptic one. Cost: some additions an effect.
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/messages.h"
#include "haptics/record/record.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// One part of a force.
struct ForcePart {
    std::string name;
    Wrench wrench_W{};
};

struct ForceAccount {
    std::vector<ForcePart> effects;
    Wrench asked_W{};
    Wrench limit_W{};
    Wrench gate_W{};
    Wrench felt_W{};
    GatePhase gate = GatePhase::waiting;
    Fault faults = Fault::none;
    // Of a record alone.
    std::size_t hand = 0;  ///< whose: 0 for the first
    std::uint64_t tick = 0;
    double time_s = 0.0;
    std::string lesson;
    std::string touched;  ///< the body's name, empty for none
};

/// What the gate lets through at most; 0 where it is not known, then the limit takes nothing.
struct MostFelt {
    double force_N = 0.0;
    double torque_Nm = 0.0;
};

/// The account of a round. `names` and `shares_W` are in one order; a share without a name is passed over.
[[nodiscard]] ForceAccount make_account(std::span<const std::string> names,
                                        std::span<const Wrench> shares_W, const Wrench& asked_W,
                                        const Wrench& felt_W, GatePhase gate, Fault faults,
                                        const MostFelt& most);
/// That of the round of a record at `time_s`, the newest that is not later. Refuses a time outside the record, and a record that does
/// not tell the shares, in one sentence.
[[nodiscard]] Expected<ForceAccount> find_account(const Record& record, double time_s);

/// How much of the force that is felt a part is, in per cent; 0 where nothing is felt.
[[nodiscard]] double percent_of(const Vector3& part_W, const Vector3& felt_W);

/// A table for people, one part a line, 80 columns.
[[nodiscard]] std::string account_text(const ForceAccount& account);
/// Those of all hands at one moment as one JSON object: see runtime/README.md.
[[nodiscard]] std::string accounts_json(std::span<const ForceAccount> accounts);

}  // namespace fulcrum::runtime
