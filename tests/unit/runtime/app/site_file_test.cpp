#include "runtime/app/site_file.h"

#include "tests/unit/runtime/rig.h"

#include <sys/stat.h>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

// A user's folder for settings of the test's own.
class OwnSettings {
  public:
    OwnSettings() {
        const char* const value = std::getenv("XDG_CONFIG_HOME");
        before_ = value == nullptr ? "" : value;
        ::setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
    }
    ~OwnSettings() {
        if (before_.empty()) {
            ::unsetenv("XDG_CONFIG_HOME");
        } else {
            ::setenv("XDG_CONFIG_HOME", before_.c_str(), 1);
        }
    }
    OwnSettings(const OwnSettings&) = delete;
    OwnSettings& operator=(const OwnSettings&) = delete;
    [[nodiscard]] std::filesystem::path own_file() const {
        return folder_.path() / "fulcrum" / "site.conf";
    }
    [[nodiscard]] std::filesystem::path shared_file() const {
        return folder_.path() / "shared.conf";
    }

  private:
    ScratchFolder folder_;
    std::string before_;
};

std::string complaint(const std::string& text) {
    const auto site = parse_site_file(text, "site.conf");
    return site ? "" : to_sentence(site.error());
}

}  // namespace

TEST_CASE("site file: four limits, comments and empty lines") {
    const auto site = value_of(parse_site_file(
        "# this room\n\nforce_limit = 3 # newtons\r\n\ttorque_limit=0.2\nspeed_limit = "
        "2\nenergy_limit = 1.5",
        "f"));
    CHECK(site.force_N == 3.0);
    CHECK(site.torque_Nm == 0.2);
    CHECK(site.speed_m_per_s == 2.0);
    CHECK(site.energy_J == 1.5);
    const auto nothing = value_of(parse_site_file("", "f"));
    CHECK_FALSE(nothing.force_N);
    // Said twice, the smaller holds.
    CHECK(parse_site_file("force_limit = 2\nforce_limit = 4", "f")->force_N == 2.0);
}

TEST_CASE("site file: what is no limit is told with its line, and nothing is guessed") {
    check_says(complaint("force_limit = 3\nforse_limit = 2"), {"site.conf:2"});
    for (const char* const bad :
         {"force_limit", "= 3", "force_limit 3", "force_limit = ", "force_limit = three",
          "force_limit = 3 N", "force_limit = 0.4", "force_limit = 10.1", "force_limit = nan",
          "force_limit = inf", "force_limit = -1", "torque_limit = 1.1", "speed_limit = 0",
          "energy_limit = 21", "\xff\xfe", "force_limit = 3 force_limit = 2"}) {
        INFO(bad);
        check_says(complaint(bad), {"site.conf:1"});
    }
}

TEST_CASE("site file: of the computer's, the user's and the command line's the least holds") {
    const OwnSettings settings;
    const auto find = [&](std::optional<double> asked_N) {
        return value_of(find_site_limits(asked_N, settings.shared_file()));
    };
    CHECK(find({}).force_N == SafetySettings{}.max_force_N);
    CHECK(find(10.0).force_N == 10.0);
    CHECK(find(2.0).force_N == 2.0);
    // A gentler force is gentler to the wrist.
    CHECK(find(2.5).torque_Nm == Approx(0.5 * SafetySettings{}.max_torque_Nm));
    write_text(settings.shared_file(), "force_limit = 4\nenergy_limit = 2\n");
    CHECK(find(10.0).force_N == 4.0);
    CHECK(find(3.0).force_N == 3.0);
    CHECK(find({}).energy_J == 2.0);
    write_text(settings.own_file(),
               "force_limit = 2\nenergy_limit = 9\nspeed_limit = 1\ntorque_limit = 0.1\n");
    CHECK(find(10.0).force_N == 2.0);
    CHECK(find({}).energy_J == 2.0);
    CHECK(find({}).speed_m_per_s == 1.0);
    CHECK(find({}).torque_Nm == 0.1);
    // Files may allow more than is usual.
    write_text(settings.shared_file(), "force_limit = 8\n");
    write_text(settings.own_file(), "");
    CHECK(find({}).force_N == 8.0);
}

TEST_CASE("site file: one that cannot be read keeps every lesson from starting") {
    const OwnSettings settings;
    write_text(settings.shared_file(), "force_limit = 99\n");
    CHECK_FALSE(find_site_limits({}, settings.shared_file()));
    std::filesystem::remove(settings.shared_file());
    std::filesystem::create_directory(settings.shared_file());
    CHECK_FALSE(find_site_limits({}, settings.shared_file()));
    std::filesystem::remove(settings.shared_file());
    write_text(settings.own_file(), std::string(70'000, '#'));
    CHECK_FALSE(find_site_limits({}, settings.shared_file()));
    write_text(settings.own_file(), "force_limit = 1");
    CHECK(find_site_limits({}, settings.shared_file()));
}

TEST_CASE("site file: a link that leads nowhere is no place without limits") {
    const OwnSettings settings;
    const std::filesystem::path shared = settings.shared_file();
    std::filesystem::create_symlink("/nowhere/site.conf", shared);
    CHECK(error_of(find_site_limits({}, shared)).where == shared.string());
    // A folder on the way is on a share that is away.
    const std::filesystem::path share = shared.parent_path() / "share";
    std::filesystem::create_symlink("/nowhere", share);
    CHECK(error_of(find_site_limits({}, share / "site.conf")).where == share.string());
    // One that leads somewhere is followed.
    std::filesystem::remove(shared);
    write_text(shared.parent_path() / "real.conf", "force_limit = 2");
    std::filesystem::create_symlink("real.conf", shared);
    CHECK(value_of(find_site_limits({}, shared)).force_N == 2.0);
}

TEST_CASE("site file: one that others may change, or whose folder they may, starts no lesson") {
    const OwnSettings settings;
    const std::filesystem::path shared = settings.shared_file();
    const auto is_refused = [&] {
        const auto limits = find_site_limits({}, shared);
        return !limits && limits.error().where == shared.string();
    };
    write_text(shared, "force_limit = 2");
    CHECK_FALSE(is_refused());
    REQUIRE(::chmod(shared.c_str(), 0666) == 0);
    CHECK(is_refused());
    REQUIRE(::chmod(shared.c_str(), 0644) == 0);
    CHECK_FALSE(is_refused());
    const std::filesystem::path folder = shared.parent_path();
    REQUIRE(::chmod(folder.c_str(), 0777) == 0);
    CHECK(is_refused());
    REQUIRE(::chmod(folder.c_str(), 01777) == 0);
    CHECK_FALSE(is_refused());
    if (::geteuid() == 0) {
        constexpr uid_t kNobody = 65534;
        REQUIRE(::chown(shared.c_str(), kNobody, kNobody) == 0);
        CHECK(is_refused());
    }
}

TEST_CASE("site file: a pipe in its place makes nobody wait, and no lesson starts") {
    const ScratchFolder folder;
    const auto file = folder.path() / "site.conf";
    REQUIRE(::mkfifo(file.c_str(), 0644) == 0);
    CHECK(error_of(load_site_file(file)).where == file.string());
}
