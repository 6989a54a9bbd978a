#include "runtime/app/kept_check.h"

#include "tests/unit/runtime/rig.h"

#include <sys/stat.h>

using namespace fulcrum::runtime::test;
namespace fs = std::filesystem;

namespace {

// A lesson, what it shares with others, and where checks are kept.
struct CheckedLesson {
    ScratchFolder folder;
    Places places;
    fs::path lesson = folder.path() / "stone";
    fs::path cache = folder.path() / "cache" / "checks";
    std::string said = "lesson.lua:2: \xE2\x80\xA6\nstone: it can be played.\n";

    CheckedLesson() {
        places.scripts_lib = folder.path() / "lib";
        fs::create_directories(places.scripts_lib);
        fs::create_directories(lesson);
        write(lesson / "lesson.lua", "return L");
    }
    static void write(const fs::path& file, const std::string& text) {
        std::ofstream(file) << text;
    }
    [[nodiscard]] KeptCheck check(const SiteLimits& site = {}) const {
        return {places, lesson, site, cache};
    }
    [[nodiscard]] std::string found(const SiteLimits& site = {}) const {
        const auto before = check(site).read();
        return before ? before->said : "";
    }
};

}  // namespace

TEST_CASE("kept check: told again as long as nothing changes that it was of") {
    const CheckedLesson of;
    CHECK(of.found().empty());
    of.check().keep(of.said);
    CHECK(of.found() == of.said);
    CHECK(of.found(make_site_limits(2.0)).empty());
    // Each of these was not there then; taken back, it is the same lesson.
    for (const fs::path& file :
         {of.lesson / "apple.glb", of.lesson / "more.lua", of.places.scripts_lib / "game.lua"}) {
        of.write(file, "x");
        CHECK(of.found().empty());
        fs::remove(file);
        CHECK(of.found() == of.said);
    }
    of.write(of.lesson / "lesson.lua", "return l");
    CHECK(of.found().empty());
    // What changes while it is looked at is not kept, nor is anything without a place for it.
    const KeptCheck begun = of.check();
    of.write(of.lesson / "lesson.lua", "return M");
    begun.keep(of.said);
    CHECK(of.found().empty());
    const KeptCheck nowhere(of.places, of.lesson, {}, {});
    nowhere.keep(of.said);
    CHECK_FALSE(nowhere.read());
}

TEST_CASE("kept check: half a file, or one that others may write to, is none") {
    const CheckedLesson of;
    const KeptCheck check = of.check();
    check.keep(of.said);
    const fs::path file = fs::directory_iterator(of.cache)->path();
    std::ifstream stream(file);
    const std::string whole(std::istreambuf_iterator<char>(stream), {});
    CHECK(check.read());
    bool is_ever_read = false;
    for (std::size_t n = 0; n < whole.size(); ++n) {
        of.write(file, whole.substr(0, n));
        is_ever_read = is_ever_read || check.read();
    }
    CHECK_FALSE(is_ever_read);
    of.write(file, whole);
    CHECK(check.read());
    ::chmod(file.c_str(), 0666);
    CHECK_FALSE(check.read());
}
