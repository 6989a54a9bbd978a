// The limits of this place, in a file that a teacher writes and whoever keeps the computer can lock:
//
//   # what a hand may feel here
//   force_limit = 3        newtons, 0.5 to 10
//   torque_limit = 0.2     newton metres, 0 to 1
//   speed_limit = 2        metres a second above which nothing is felt, 0.5 to 10
//   energy_limit = 3       joules given to a hand in about a second, 0.5 to 20
//
// /etc/fulcrum/site.conf holds for everybody on the computer, fulcrum/site.conf in the user's folder for settings for that user; of both,
// and of --force-limit, the least of each limit holds, so that no pupil gets around a file that only the administrator can write. A file
// that cannot be read, is a link that leads nowhere, may be written by others (other_writers.h) or says what it may not, keeps every lesson
// from starting: without it nobody knows what is allowed.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"
#include "runtime/scene/site_limits.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace fulcrum::runtime {

inline constexpr const char* kSharedSiteFile = "/etc/fulcrum/site.conf";

/// A force limit that nobody has set in a file or on the command line is SafetySettings'; a file may allow more, to the hard caps.
struct SiteFile {
    std::optional<double> force_N, torque_Nm, speed_m_per_s, energy_J;
};

/// The file's text; `name` is what an error says before the line.
[[nodiscard]] Expected<SiteFile> parse_site_file(std::string_view text, std::string_view name);

/// Reads `file`; nothing where there is none. Refuses a dangling link to it or to a folder on the way, what is no plain file or may be written
/// by others, more than 64 kB, and what parse_site_file refuses.
[[nodiscard]] Expected<SiteFile> load_site_file(const std::filesystem::path& file);

/// Both files, and `asked_N` of --force-limit: the least of each. Where nothing sets a limit it is the usual one.
[[nodiscard]] Expected<SiteLimits> find_site_limits(std::optional<double> asked_N);
/// The same, with the shared file elsewhere; for tests.
[[nodiscard]] Expected<SiteLimits> find_site_limits(std::optional<double> asked_N,
                                                    const std::filesystem::path& shared_file);

}  // namespace fulcrum::runtime
