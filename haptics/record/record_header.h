// The head of a record, to and from bytes. Private to haptics/record.
#pragma once

#include "haptics/base/error.h"
#include "haptics/record/record.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum::record_layout {

/// What stands before the first block.
struct Head {
    RecordHeader header;
    std::uint32_t version = kRecordVersion;
    std::size_t n_bytes = 0;
};

/// Puts a header of today's version at the end of the bytes; texts are cut and lists shortened to what the format holds.
void put_header(const RecordHeader& header, std::vector<std::byte>& bytes);
/// Reads the header of any version that is known; refuses what is none, in one sentence.
[[nodiscard]] Expected<Head> read_header(std::span<const std::byte> bytes);

}  // namespace fulcrum::record_layout
