// Which arms of makers can be a hand here: each is asked for by the process that would serve it, and let go at once.
//
// Thread: load path. Cost: a process an arm, at the same time; as long as the slowest maker's library takes, kArmBegin_s at most.
#pragma once

#include "runtime/app/arm_kind.h"
#include "runtime/app/device_list.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// An entry for each maker, whose arm is there, or with what is missing.
[[nodiscard]] std::vector<DeviceEntry> find_makers_arms();

/// What the process that serves an arm said up to where it waits, or does not: a line each.
[[nodiscard]] DeviceEntry read_arm_entry(const OwnArmKind& kind,
                                         const std::vector<std::string>& lines);

}  // namespace fulcrum::runtime
