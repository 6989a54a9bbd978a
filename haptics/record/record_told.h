// Which kind of the file each thing is that a loop was told. Private to haptics/record.
#pragma once

#include "haptics/record/told_layout.h"

#include <cstddef>
#include <span>

namespace fulcrum::record_layout {

[[nodiscard]] constexpr RecordToldKind kind_of(const ForceCommand&) {
    return RecordToldKind::command;
}
[[nodiscard]] constexpr RecordToldKind kind_of(const WorldFrame&) {
    return RecordToldKind::world;
}
[[nodiscard]] constexpr RecordToldKind kind_of(const AxleOrders&) {
    return RecordToldKind::axles;
}
[[nodiscard]] constexpr RecordToldKind kind_of(const RigidFrame&) {
    return RecordToldKind::rigid;
}
[[nodiscard]] constexpr RecordToldKind kind_of(const LineState&) {
    return RecordToldKind::line;
}
[[nodiscard]] constexpr RecordToldKind kind_of(const ToldReading&) {
    return RecordToldKind::reading;
}

/// The next of `parts`, at `at`, which goes on behind it; `told.at` has been set to where `parts` will lie, plus `at`. False where there is no
/// whole one of a kind that is known.
[[nodiscard]] bool take_told(Source& source, std::span<const std::byte> parts, std::size_t& at,
                             RecordTold& told);

}  // namespace fulcrum::record_layout
