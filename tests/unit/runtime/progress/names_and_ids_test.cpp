#include "dialogue/unicode.h"
#include "runtime/progress/database_path.h"
#include "runtime/progress/records.h"
#include "runtime/progress/text_rules.h"
#include "tests/unit/runtime/progress/progress_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <random>
#include <sys/stat.h>

using namespace fulcrum::runtime::test;

namespace {

// Sets a variable of the environment, or takes it away, and puts it back at the end.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) {
            old_ = old;
        }
        value == nullptr ? unsetenv(name) : setenv(name, value, 1);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }

  private:
    const char* name_;
    std::optional<std::string> old_;
};

}  // namespace

TEST_CASE("database path: XDG_DATA_HOME, else the home folder; relative ones don't count") {
    const Variable home("HOME", "/pupils/mina");
    {
        const Variable data("XDG_DATA_HOME", "/data");
        CHECK(default_database_path() == "/data/fulcrum/progress.db");
    }
    {
        const Variable data("XDG_DATA_HOME", nullptr);
        CHECK(default_database_path() == "/pupils/mina/.local/share/fulcrum/progress.db");
    }
    for (const char* useless : {"", "relative/data"}) {
        const Variable data("XDG_DATA_HOME", useless);
        CHECK(default_database_path() == "/pupils/mina/.local/share/fulcrum/progress.db");
    }
    const Variable data("XDG_DATA_HOME", nullptr);
    const Variable no_home("HOME", "relative");
    CHECK_FALSE(default_database_path());
}

TEST_CASE("database path: the file and its folders are private, and what exists is left alone") {
    const TemporaryFolder folder;
    const std::string path = folder.file("a/b/progress.db");
    REQUIRE(create_private_file(path));
    struct stat status {};
    REQUIRE(stat(path.c_str(), &status) == 0);
    CHECK((status.st_mode & 0777U) == 0600);
    REQUIRE(stat(folder.file("a").c_str(), &status) == 0);
    CHECK((status.st_mode & 0777U) == 0700);
    write_bytes(path, "kept");
    REQUIRE(create_private_file(path));
    CHECK(bytes_of(path) == "kept");
}

TEST_CASE("record ids: 32 hexadecimal digits, no two alike, every digit varies") {
    RecordId changed(32, '0');
    RecordId previous;
    for (int i = 0; i < 200; ++i) {
        const RecordId id = random_record_id();
        CHECK(is_record_id(id));
        CHECK(id != previous);
        for (std::size_t digit = 0; i > 0 && digit < id.size(); ++digit) {
            changed[digit] = id[digit] != previous[digit] ? 'x' : changed[digit];
        }
        previous = id;
    }
    CHECK(changed == RecordId(32, 'x'));
    CHECK_FALSE(is_record_id(""));
    CHECK_FALSE(is_record_id(RecordId(31, 'a')));
    CHECK_FALSE(is_record_id(RecordId(32, 'A')));
    CHECK_FALSE(is_record_id(RecordId(33, 'a')));
    CHECK_FALSE(is_record_id(RecordId(32, 'g')));
}

TEST_CASE("store: bad records are refused in one sentence by either store") {
    OwnClassroom room;
    const auto null_store = make_null_store();
    CHECK_FALSE(null_store->keeps());
    for (ProgressStore* store : {room.store.get(), null_store.get()}) {
        AttemptRecord attempt = attempt_for(room.session.id, "heaviest", 0, true);
        check_says(error_text(store->add_attempt(attempt)), {"count attempts from 1"});
        attempt.attempt = 1;
        attempt.answer_s = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.answer_s = -1.0;
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.answer_s = 1.0;
        for (const double none : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
            attempt.confidence = none;
            CHECK_FALSE(store->add_attempt(attempt));
        }
        attempt.confidence = 1.0;
        attempt.errors = {{"", "a", "b"}};
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.errors.clear();
        CHECK(error_text(validate(attempt)).empty());
        // Of a form that nobody heard there is nothing to keep.
        attempt.form_known = false;
        for (const bool of_target : {false, true}) {
            attempt.form_right = !of_target;
            attempt.target_right = of_target;
            check_says(error_text(store->add_attempt(attempt)), {"a form that nobody heard"});
        }
        attempt.target_right = false;
        attempt.errors = {{"M:DET", "", "the"}};
        CHECK_FALSE(store->add_attempt(attempt));
        attempt.errors.clear();
        CHECK(error_text(validate(attempt)).empty());
        attempt.id = "1234";
        CHECK_FALSE(store->add_attempt(attempt));
        CHECK_FALSE(store->end_session({room.session.id, 0, EndReason::finished, 4, 0, 1}));
        CHECK_FALSE(store->end_session({room.session.id, 0, EndReason::finished, 0, 0, 0}));
        SessionRecord session = room.session;
        session.id = random_record_id();
        session.settings = {{"a", "1"}, {"a", "2"}};
        CHECK_FALSE(store->begin_session(session));
        session.settings.clear();
        session.lesson.clear();
        CHECK_FALSE(store->begin_session(session));
        CHECK_FALSE(store->enrol("\n"));
        CHECK_FALSE(store->add_learner({random_record_id(), " blank ", 0}));
    }
    CHECK(room.store->read({})->attempts.empty());
}

TEST_CASE("nickname: 1 to 40 characters of any script, without blanks at its ends") {
    CHECK(checked_nickname("Mina") == "Mina");
    CHECK(checked_nickname("  Mina B. ") == "Mina B.");
    CHECK(checked_nickname("\u00A0민아\u3000") == "민아");
    CHECK(checked_nickname("🍉") == "🍉");
    std::string forty;
    for (int i = 0; i < 40; ++i) {
        forty += "é";
    }
    CHECK(checked_nickname(forty) == forty);
    CHECK_FALSE(checked_nickname(forty + "x"));
    for (const char* bad : {"", "   ", "\u3000"}) {
        CHECK_FALSE(checked_nickname(bad));
    }
}

TEST_CASE("nickname: control, hidden and reordering characters are refused") {
    for (const std::string& bad :
         {std::string("a\0b", 3), std::string("a\nb"), std::string("a\x1b[2J"),
          std::string("a\x7f"), std::string("a\u0085"), std::string("a\u200Bb"),
          std::string("a\u202Eb"), std::string("a\u2066b"), std::string("\uFEFFa"),
          std::string("a\u2028b")}) {
        CAPTURE(bad);
        CHECK_FALSE(checked_nickname(bad));
    }
}

TEST_CASE("nickname: what is no UTF-8 is refused") {
    for (const char* bad : {"\x80", "\xC0\x80", "\xED\xA0\x80", "\xC3", "\xE2(\xA1"}) {
        CAPTURE(bad);
        CHECK_FALSE(checked_nickname(std::string("a") + bad));
    }
}

TEST_CASE("nickname: capitals, blanks and how an accent was typed make no other name") {
    for (const auto& [one, other] :
         std::vector<std::pair<const char*, const char*>>{{"Mina", "MINA"},
                                                          {" Mina  \u00A0\u3000 B. ", "mina b."},
                                                          {"José", "JOSE\u0301"},
                                                          {"Strauß", "STRAUSS"},
                                                          {"Zoë", "zoe\u0308"},
                                                          {"Юля", "ЮЛЯ"},
                                                          {"민아", "\u1106\u1175\u11ABᄋ\u1161"}}) {
        CAPTURE(one, other);
        CHECK(folded_nickname(one) == folded_nickname(other));
    }
    for (const auto& [one, other] : std::vector<std::pair<const char*, const char*>>{
             {"Jose", "José"}, {"Mina B", "MinaB"}, {"Mina", "Mia"}, {"İpek", "Ipek"}}) {
        CAPTURE(one, other);
        CHECK(folded_nickname(one) != folded_nickname(other));
    }
}

TEST_CASE("kept text: any bytes become clean UTF-8, and mending twice changes nothing") {
    CHECK(kept_text("the heaviest, 민아!") == "the heaviest, 민아!");
    CHECK(kept_text("a\tb\xC3") == "a b\uFFFD");
    std::mt19937 random(3);
    for (int round = 0; round < 2'000; ++round) {
        std::string bytes(random() % 40, ' ');
        for (char& c : bytes) {
            c = static_cast<char>(random());
        }
        const std::string kept = kept_text(bytes);
        REQUIRE(kept_text(kept) == kept);
        for (std::size_t at = 0; at < kept.size();) {
            const auto character = fulcrum::dialogue::character_at(kept, at);
            REQUIRE(character.valid);
            REQUIRE_FALSE(is_control(character.code));
            at += character.bytes;
        }
    }
}

TEST_CASE("kept text: is cut between two characters") {
    std::string long_text = "x";
    while (long_text.size() < 2 * kMaxKeptTextBytes) {
        long_text += "민";
    }
    const std::string kept = kept_text(long_text);
    CHECK(kept.size() == kMaxKeptTextBytes);  // 1 + 3 · 1333 = 4000
    CHECK(kept_text("y" + long_text).size() == kMaxKeptTextBytes - 2);
}

TEST_CASE("display width: Korean is two columns, accents none") {
    CHECK(display_width("abc") == 3);
    CHECK(display_width("민아") == 4);
    CHECK(display_width("e\u0301") == 1);
    CHECK(display_width("🍉") == 2);
}
