// Reading all that a filter matches: one statement a table; lists are put to their owners by id.
#include "runtime/progress/sqlite/queries.h"
#include "runtime/progress/sqlite/rows.h"

#include <unordered_map>

namespace fulcrum::runtime::sqlite {
namespace {

// Every statement takes the nickname as ?1 and the lesson as ?2; an empty one takes all.
constexpr const char* kOfSession =
    " JOIN learner ON learner.id = session.learner"
    " WHERE (?1 = '' OR learner.nickname = ?1) AND (?2 = '' OR session.lesson = ?2)";

template <class Each>
void for_each_row(Database& database, const std::string& sql, const ProgressFilter& filter,
                  Each&& each) {
    Statement row(database, sql.c_str());
    row.bind(filter.nickname).bind(filter.lesson);
    while (row.step()) {
        each(row);
    }
}

template <class Record>
std::unordered_map<RecordId, std::size_t> places_by_id(const std::vector<Record>& records) {
    std::unordered_map<RecordId, std::size_t> places;
    for (std::size_t i = 0; i < records.size(); ++i) {
        places.emplace(records[i].id, i);
    }
    return places;
}

// The record that a list's row belongs to; without it the tables and their indexes disagree.
template <class Record>
Record& owner_of(const Database& database, std::vector<Record>& records,
                 const std::unordered_map<RecordId, std::size_t>& places, const RecordId& id) {
    const auto place = places.find(id);
    if (place == places.end()) {
        throw Refused(error_for(SQLITE_CORRUPT, database.path(), "a row without its owner"),
                      SQLITE_CORRUPT);
    }
    return records[place->second];
}

void read_sessions(Database& database, const ProgressFilter& filter, ProgressData& data) {
    for_each_row(database, std::string(kSelectSession) + kOfSession + " ORDER BY session.row",
                 filter, [&](Statement& row) { data.sessions.push_back(session_of(row)); });
    const auto places = places_by_id(data.sessions);
    for_each_row(database,
                 std::string(kSelectSetting) +
                     " JOIN session ON session.id = session_setting.session" + kOfSession +
                     " ORDER BY session.row, position",
                 filter, [&](Statement& row) {
                     SessionRecord& session = owner_of(database, data.sessions, places, row.text());
                     session.settings.push_back(setting_of(row));
                 });
}

void read_attempts(Database& database, const ProgressFilter& filter, ProgressData& data) {
    const std::string of_attempt =
        std::string(" JOIN session ON session.id = attempt.session") + kOfSession;
    for_each_row(database, kSelectAttempt + of_attempt + " ORDER BY attempt.row", filter,
                 [&](Statement& row) { data.attempts.push_back(attempt_of(row)); });
    const auto places = places_by_id(data.attempts);
    for_each_row(database,
                 std::string(kSelectError) + " JOIN attempt ON attempt.id = attempt_error.attempt" +
                     of_attempt + " ORDER BY attempt.row, position",
                 filter, [&](Statement& row) {
                     AttemptRecord& attempt = owner_of(database, data.attempts, places, row.text());
                     attempt.errors.push_back(error_of(row));
                 });
}

}  // namespace

ProgressData read(Database& database, const ProgressFilter& given) {
    ProgressFilter filter = given;
    if (const auto called =
            given.nickname.empty() ? std::nullopt : find_called(database, given.nickname)) {
        filter.nickname = called->nickname;
    }
    ProgressData data;
    for_each_row(
        database,
        std::string(kSelectLearner) + " WHERE (?1 = '' OR nickname = ?1) AND ?2 = ?2 ORDER BY row",
        filter, [&](Statement& row) { data.learners.push_back(learner_of(row)); });
    read_sessions(database, filter, data);
    for_each_row(database,
                 std::string(kSelectEnd) + " JOIN session ON session.id = session_end.session" +
                     kOfSession + " ORDER BY session_end.row",
                 filter, [&](Statement& row) { data.ends.push_back(end_of(row)); });
    if (filter.results_only) {
        return data;
    }
    read_attempts(database, filter, data);
    for_each_row(database,
                 std::string(kSelectHandSetting) +
                     " JOIN learner ON learner.id = hand_setting.learner"
                     " WHERE (?1 = '' OR learner.nickname = ?1) AND ?2 = ?2"
                     " ORDER BY hand_setting.row",
                 filter, [&](Statement& row) { data.hands.push_back(hand_setting_of(row)); });
    return data;
}

}  // namespace fulcrum::runtime::sqlite
