// What a person is told of the link to an arm: why nobody answers, and when the way becomes too long for forces, and is not any more, or longer than the walls were made for.
//
// An arm says nothing to who has not its key, so from here another key looks like nobody. What tells them apart: where no
// program waits at a port, its computer says so (udp(7): ECONNREFUSED); and what comes with another seal or version is counted.
//
// Thread: any. Cost: builds sentences.
#pragma once

#include "haptics/base/error.h"
#include "haptics/link/link_device.h"

#include <string>

namespace fulcrum::runtime {

/// Why no arm has said welcome; `is_refused`: its computer has said that nothing waits at that port.
[[nodiscard]] Error explain_silence(const LinkStatus& status, bool is_refused,
                                    const std::string& address, const std::string& key_file);

/// Said when the way has become too long for forces (`status.too_long`), or is not any more.
[[nodiscard]] std::string describe_way(const LinkStatus& status, double most_round_trip_s);

/// Said when the way has become much longer than that for which what is touched was made.
[[nodiscard]] std::string describe_slower_way(const LinkStatus& status, double made_for_s);

}  // namespace fulcrum::runtime
