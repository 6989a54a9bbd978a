#include "runtime/app/kept_check.h"

#include "haptics/base/sha256.h"
#include "runtime/app/program_build.h"
#include "runtime/files/private_folder.h"
#include "runtime/files/user_folder.h"

#include <charconv>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

namespace fulcrum::runtime {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMark = "fulcrum check 1";
constexpr std::uint64_t kMostSaid_bytes = 1U << 20U;
constexpr const char* kInstalledPackages = "/var/lib/dpkg/status";

class Key {
  public:
    void add(std::string_view text) {
        const std::string length = std::to_string(text.size()) + ' ';  // "ab" "c" is not "a" "bc"
        hash_.add(std::as_bytes(std::span(length)));
        hash_.add(std::as_bytes(std::span(text)));
    }
    void add(double number) { add(std::to_string(number)); }
    void add_by_time(const fs::path& file) {
        std::error_code error;
        add(file.filename().string());
        add(std::to_string(fs::file_size(file, error)));
        add(std::to_string(fs::last_write_time(file, error).time_since_epoch().count()));
    }
    std::string finish() { return to_hex(hash_.finish()); }

  private:
    Sha256 hash_;
};

std::string name_of(const fs::path& folder) {
    std::error_code error;
    Key name;
    name.add(fs::weakly_canonical(folder, error).string());
    return name.finish() + ".check";
}

/// The text up to the next line's end, which is taken off.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

std::optional<std::int64_t> to_number(std::string_view text) {
    std::int64_t number = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
    return parsed.ec == std::errc{} ? std::optional(number) : std::nullopt;
}

}  // namespace

KeptCheck::KeptCheck(const Places& places, const fs::path& folder, const SiteLimits& site,
                     fs::path cache)
    : places_(places), folder_(folder), site_(site), cache_(std::move(cache)), key_(find_key()) {}

std::string KeptCheck::find_key() const {
    const std::string build = program_build_id();
    if (cache_.empty() || build == "unknown") {
        return {};
    }
    Key key;
    key.add(build);
    for (const double limit :
         {site_.force_N, site_.torque_Nm, site_.speed_m_per_s, site_.energy_J}) {
        key.add(limit);
    }
    key.add_by_time(kInstalledPackages);
    for (const fs::path& shared : {places_.scripts_lib, places_.words, places_.models}) {
        for (const fs::path& file : entries_of(shared)) {
            key.add_by_time(file);
        }
    }
    // A lesson reads what lies beside it, and no folder in it.
    std::uint64_t n_bytes = 0;
    for (const fs::path& file : entries_of(folder_)) {
        std::error_code error;
        if (!fs::is_regular_file(file, error)) {
            continue;
        }
        n_bytes += fs::file_size(file, error);
        if (error || n_bytes > kMostLesson_bytes) {
            return {};
        }
        std::ifstream stream(file, std::ios::binary);
        key.add(file.filename().string());
        key.add(std::string(std::istreambuf_iterator<char>(stream), {}));
    }
    return key.finish();
}

std::optional<FoundBefore> KeptCheck::read() const {
    if (key_.empty()) {
        return std::nullopt;
    }
    const auto cache = PrivateFolder::open(cache_, "");
    if (!cache || !*cache) {
        return std::nullopt;
    }
    const auto bytes = (*cache)->read(name_of(folder_), kMostSaid_bytes);
    if (!bytes || !*bytes) {
        return std::nullopt;
    }
    std::string_view text(reinterpret_cast<const char*>((*bytes)->data()), (*bytes)->size());
    const bool is_same = take_line(text) == kMark && take_line(text) == key_;
    const auto at = to_number(take_line(text));
    const auto n_said = to_number(take_line(text));
    std::tm parts{};
    const bool is_time = at && ::localtime_r(&*at, &parts) != nullptr;
    if (!is_same || !is_time || !n_said || std::cmp_not_equal(text.size(), *n_said)) {
        return std::nullopt;
    }
    return FoundBefore{std::string(text), static_cast<std::time_t>(*at)};
}

void KeptCheck::keep(const std::string& said) const {
    if (key_.empty() || find_key() != key_) {
        return;
    }
    std::string text;
    for (const std::string& line : {std::string(kMark), key_, std::to_string(std::time(nullptr)),
                                    std::to_string(said.size())}) {
        text += line + '\n';
    }
    text += said;
    if (const auto cache = PrivateFolder::create(cache_, "");
        cache && text.size() <= kMostSaid_bytes) {
        (void)cache->replace(name_of(folder_), std::as_bytes(std::span(text)));
    }
}

fs::path default_check_cache_folder() {
    const auto folder = find_user_folder("XDG_CACHE_HOME", ".cache", "set HOME");
    return folder ? *folder / "fulcrum" / "checks" : fs::path();
}

}  // namespace fulcrum::runtime
