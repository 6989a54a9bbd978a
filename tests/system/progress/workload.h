// A lesson's worth of records by number, the same in every program that knows the seed: what one process wrote, another
// can repeat and check.
#pragma once

#include "runtime/progress/store.h"

#include <cstdint>
#include <set>
#include <string>

namespace fulcrum::runtime::test {

/// Record 0 is the learner, 1 the session, then attempts (every third with two errors), the last one the session's end.
class Workload {
  public:
    Workload(std::uint64_t seed, std::int64_t records) : seed_(seed), records_(records) {}

    [[nodiscard]] std::int64_t records() const noexcept { return records_; }

    /// Writes record `number`, below `records()`.
    [[nodiscard]] Expected<void> write(ProgressStore& store, std::int64_t number) const;

    /// Those of the numbers that `data` does not hold, or holds with other content.
    [[nodiscard]] std::set<std::int64_t> missing(const ProgressData& data,
                                                 const std::set<std::int64_t>& numbers) const;

    /// True when `data` holds every record once and nothing else.
    [[nodiscard]] bool is_all_of(const ProgressData& data) const;

    [[nodiscard]] Learner learner() const;

  private:
    [[nodiscard]] RecordId id(std::int64_t number) const;
    [[nodiscard]] SessionRecord session() const;
    [[nodiscard]] SessionEnd end() const;
    [[nodiscard]] AttemptRecord attempt(std::int64_t number) const;

    std::uint64_t seed_;
    std::int64_t records_;
};

}  // namespace fulcrum::runtime::test
