#include "runtime/app/site_file.h"

#include "runtime/files/other_writers.h"
#include "runtime/files/user_folder.h"
#include "runtime/scene/lesson_limits.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostBytes = 65536;
constexpr const char* kAsk = "mend or remove it, or ask who keeps this computer";
constexpr const char* kLetRead = "let everybody read this file, or ask who keeps this computer";
constexpr const char* kMend =
    "write lines such as \"force_limit = 3\", or ask who keeps this computer";

struct Limit {
    std::string_view word;
    double low, high;
    std::optional<double> SiteFile::*place;
};
constexpr std::array<Limit, 4> kLimits{
    {{"force_limit", kLeastForceLimit_N, kMostForceLimit_N, &SiteFile::force_N},
     {"torque_limit", 0.0, 1.0, &SiteFile::torque_Nm},
     {"speed_limit", 0.5, 10.0, &SiteFile::speed_m_per_s},
     {"energy_limit", 0.5, 20.0, &SiteFile::energy_J}}};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos
               ? std::string_view{}
               : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// One line without its comment; empty ones say nothing.
Expected<void> take_line(std::string_view line, const std::string& where, SiteFile& site) {
    if (line.empty()) {
        return {};
    }
    const std::size_t equals = line.find('=');
    const std::string_view word = trimmed(line.substr(0, equals));
    const auto limit = std::find_if(kLimits.begin(), kLimits.end(),
                                    [&](const Limit& l) { return l.word == word; });
    if (equals == std::string_view::npos || limit == kLimits.end()) {
        return fail("this is no limit: force_limit, torque_limit, speed_limit and energy_limit are",
                    where, kMend);
    }
    const std::string_view number = trimmed(line.substr(equals + 1));
    double value = 0.0;
    const auto parsed = std::from_chars(number.data(), number.data() + number.size(), value);
    if (parsed.ec != std::errc{} || parsed.ptr != number.data() + number.size() ||
        !(value >= limit->low && value <= limit->high)) {
        return fail(std::string(word) + " is no number within its range", where, kMend);
    }
    // Said twice, the smaller holds.
    std::optional<double>& place = site.*(limit->place);
    place = std::min(place.value_or(value), value);
    return {};
}

// Whether the file is there; refuses what is unfit to say what a hand may feel. A pipe is not opened: nobody may ever write to it.
Expected<bool> look_for(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found) {
        if (const auto link = find_dangling_link(file)) {
            return fail("this link to the limits of this place leads nowhere", link->string(),
                        kAsk);
        }
        return false;
    }
    if (error || status.type() != std::filesystem::file_type::regular) {
        return fail("the limits of this place cannot be read", file.string(), kLetRead);
    }
    if (const auto others = find_other_writers(file)) {
        return fail("whoever likes can change the limits of this place: " + *others, file.string(),
                    "take that away (chmod go-w), or ask who keeps this computer");
    }
    return true;
}

// Whether it belongs to this user or to who keeps the computer, whose the root folder is.
bool is_kept_here(const std::filesystem::path& file) {
    struct stat about {};
    struct stat root {};
    return ::stat(file.c_str(), &about) != 0 || ::stat("/", &root) != 0 ||
           about.st_uid == root.st_uid || about.st_uid == ::geteuid();
}

// What one file sets, over what is there.
void take_least(std::optional<double>& limit, const std::optional<double>& other) {
    if (other) {
        limit = std::min(limit.value_or(*other), *other);
    }
}

}  // namespace

Expected<SiteFile> parse_site_file(std::string_view text, std::string_view name) {
    SiteFile site;
    int number = 0;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        ++number;
        const std::string where = std::string(name) + ":" + std::to_string(number);
        if (auto taken = take_line(trimmed(line.substr(0, line.find('#'))), where, site); !taken) {
            return tl::unexpected(taken.error());
        }
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    }
    return site;
}

Expected<SiteFile> load_site_file(const std::filesystem::path& file) {
    const auto is_there = look_for(file);
    if (!is_there) {
        return tl::unexpected(is_there.error());
    }
    if (!*is_there) {
        return SiteFile{};
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return fail("the limits of this place cannot be read", file.string(), kLetRead);
    }
    std::string text(kMostBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (stream.bad() || text.size() > kMostBytes) {
        return fail("the limits of this place cannot be read: more than 64 kB, or no text",
                    file.string(), kMend);
    }
    return parse_site_file(text, file.string());
}

Expected<SiteLimits> find_site_limits(std::optional<double> asked_N,
                                      const std::filesystem::path& shared_file) {
    if (!is_kept_here(shared_file)) {
        return fail("the limits of this place are another user's", shared_file.string(), kAsk);
    }
    auto shared = load_site_file(shared_file);
    if (!shared) {
        return tl::unexpected(shared.error());
    }
    SiteFile site = *shared;
    // Who has no home folder has no file there.
    if (const auto folder = find_user_folder("XDG_CONFIG_HOME", ".config", "")) {
        const auto own = load_site_file(*folder / "fulcrum" / "site.conf");
        if (!own) {
            return tl::unexpected(own.error());
        }
        for (const Limit& limit : kLimits) {
            take_least(site.*(limit.place), *own.*(limit.place));
        }
    }
    take_least(site.force_N, asked_N);
    SiteLimits limits = make_site_limits(site.force_N.value_or(SiteLimits{}.force_N));
    limits.torque_Nm = site.torque_Nm.value_or(limits.torque_Nm);
    limits.speed_m_per_s = site.speed_m_per_s.value_or(limits.speed_m_per_s);
    limits.energy_J = site.energy_J.value_or(limits.energy_J);
    return limits;
}

Expected<SiteLimits> find_site_limits(std::optional<double> asked_N) {
    return find_site_limits(asked_N, kSharedSiteFile);
}

}  // namespace fulcrum::runtime
