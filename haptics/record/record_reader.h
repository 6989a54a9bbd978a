// Reads records.
//
// Thread: load path. Cost: one pass.
#pragma once

#include "haptics/base/error.h"
#include "haptics/record/record.h"

#include <cstddef>
#include <span>
#include <string>

namespace fulcrum {

/// Reads a whole record. Refuses, with one sentence: wrong magic or version, a bad checksum, counts
/// or sizes that cannot be, times that run backwards or are not finite, anything truncated. Never
/// reads outside `bytes`, never allocates more than they justify.
[[nodiscard]] Expected<Record> read_record(std::span<const std::byte> bytes);
/// The same for a file whose writer was stopped in the middle: keeps every whole block before the
/// first bad or missing byte and sets `cut_off`. A bad header is still refused.
[[nodiscard]] Expected<Record> recover_record(std::span<const std::byte> bytes);
/// Reads the file at `path` (at most 2 GB) with `recover_record`; `where` of an error is the path.
[[nodiscard]] Expected<Record> load_record(const std::string& path);

}  // namespace fulcrum
