// A device's traits as facts of a record's header, and back: what repeats a run must be what was held in it, for the loop's
// estimator, brake and gate depend on it.
//
// Thread: load path.
#pragma once

#include "haptics/device/device.h"
#include "haptics/record/record.h"

#include <optional>
#include <string_view>
#include <vector>

namespace fulcrum {

/// The value of the fact of this name; nothing where the header has none.
[[nodiscard]] std::optional<std::string_view> find_fact(const RecordHeader& header,
                                                        std::string_view name);

/// Puts what the device can do behind the facts.
void list_traits(const DeviceTraits& traits, std::vector<RecordFact>& facts);
/// What the recorded device could do; nothing where the record does not tell all of it, or tells what cannot be.
[[nodiscard]] std::optional<DeviceTraits> find_traits(const RecordHeader& header);

}  // namespace fulcrum
