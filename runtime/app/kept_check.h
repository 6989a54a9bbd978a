// What `fulcrum check` found the last time, for a lesson of which nothing has changed since.
//
//   key    SHA-256 over all that a check depends on: the program's build, the limits of this place, which packages are installed (grammar,
//          dictionaries), the files that all lessons share by name, size and time of change, and each file in the lesson's folder byte by byte
//   name   the SHA-256 of the folder's own name: one file a lesson, in a folder that is the user's alone (private_folder.h: there is
//          the old one or the new one whenever a program or a computer stops)
//   kept   only what was looked at to its end, and only where the key is the same then as at the beginning
// What cannot be read or kept is looked at again: it costs time, nothing else.
//
// Thread: any one; load. Cost: reads the lesson's files, 4 ns a byte; none of more than kMostLesson_bytes is kept.
#pragma once

#include "runtime/app/places.h"
#include "runtime/scene/site_limits.h"

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>

namespace fulcrum::runtime {

struct FoundBefore {
    std::string said;  ///< all lines
    std::time_t at = 0;
};

class KeptCheck {
  public:
    static constexpr std::uint64_t kMostLesson_bytes = 64U << 20U;

    /// Of the lesson in `folder`; kept in `cache`, or nowhere where that is empty.
    KeptCheck(const Places& places, const std::filesystem::path& folder, const SiteLimits& site,
              std::filesystem::path cache);

    [[nodiscard]] std::optional<FoundBefore> read() const;
    /// Keeps what has been said of the lesson, if it is still as it was.
    void keep(const std::string& said) const;

  private:
    [[nodiscard]] std::string find_key() const;

    Places places_;
    std::filesystem::path folder_;
    SiteLimits site_;
    std::filesystem::path cache_;
    std::string key_;  ///< of the lesson as it was when this was made; empty: nothing is kept
};

/// $XDG_CACHE_HOME/fulcrum/checks, or ~/.cache/fulcrum/checks; empty where there is no home. Nothing is made.
[[nodiscard]] std::filesystem::path default_check_cache_folder();

}  // namespace fulcrum::runtime
