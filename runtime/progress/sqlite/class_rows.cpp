// Classes, what is set for them, and their pupils' pictures, in and out of their tables.
#include "runtime/progress/sqlite/queries.h"
#include "runtime/progress/sqlite/repeats.h"
#include "runtime/progress/sqlite/rows.h"
#include "runtime/progress/text_rules.h"

namespace fulcrum::runtime::sqlite {
namespace {

constexpr const char* kSelectClass = "SELECT id, name, made_utc_ms FROM class";
constexpr const char* kSelectClassSetting =
    "SELECT id, class, name, value, kept_utc_ms FROM class_setting";
constexpr const char* kSelectClassCard =
    "SELECT id, class, learner, card_1, card_2, secret, kept_utc_ms FROM class_card";

void read_row(Statement& row, ClassRecord& record) {
    record.id = row.text();
    record.name = row.text();
    record.made_utc_ms = row.number();
}

void read_row(Statement& row, ClassSetting& setting) {
    setting.id = row.text();
    setting.class_id = row.text();
    setting.name = row.text();
    setting.value = row.text();
    setting.kept_utc_ms = row.number();
}

void read_row(Statement& row, ClassCard& card) {
    card.id = row.text();
    card.class_id = row.text();
    card.learner = row.text();
    for (std::string* picture :
         {&card.pictures.card[0], &card.pictures.card[1], &card.pictures.secret}) {
        *picture = row.text();
    }
    card.kept_utc_ms = row.number();
}

template <class Record>
std::vector<Record> read_all(Database& database, const char* select) {
    std::vector<Record> records;
    Statement row(database, (std::string(select) + " ORDER BY row").c_str());
    while (row.step()) {
        read_row(row, records.emplace_back());
    }
    return records;
}

template <class Record>
bool is_there(Database& database, const char* select, const Record& record, const char* what) {
    Statement row(database, (std::string(select) + " WHERE id = ?").c_str());
    std::optional<Record> kept;
    if (row.bind(record.id).step()) {
        read_row(row, kept.emplace());
    }
    return is_repeat(database, kept, record, what);
}

constexpr const char* kOneClass = "SELECT 1 FROM class WHERE id = ?";

void keep_one(Database& database, const ClassRecord& record) {
    if (is_there(database, kSelectClass, record, "class")) {
        return;
    }
    Statement taken(database, "SELECT 1 FROM class WHERE name = ?");
    if (taken.bind(record.name).step()) {
        throw Refused({"another class is called \"" + record.name + "\"", database.path(),
                       "choose another name"});
    }
    Statement(database, "INSERT INTO class(id, name, made_utc_ms) VALUES(?, ?, ?)")
        .bind(record.id)
        .bind(record.name)
        .bind(record.made_utc_ms)
        .run();
}

void keep_one(Database& database, const ClassSetting& given) {
    ClassSetting setting = given;
    setting.name = kept_text(given.name);
    setting.value = kept_text(given.value);
    if (is_there(database, kSelectClassSetting, setting, "setting of a class")) {
        return;
    }
    require(database, kOneClass, setting.class_id, "class");
    Statement(database,
              "INSERT INTO class_setting(id, class, name, value, kept_utc_ms)"
              " VALUES(?, ?, ?, ?, ?)")
        .bind(setting.id)
        .bind(setting.class_id)
        .bind(setting.name)
        .bind(setting.value)
        .bind(setting.kept_utc_ms)
        .run();
}

void keep_one(Database& database, const ClassCard& card) {
    if (is_there(database, kSelectClassCard, card, "card of a class")) {
        return;
    }
    require(database, kOneClass, card.class_id, "class");
    require(database, "SELECT 1 FROM learner WHERE id = ?", card.learner, "learner");
    Statement(database,
              "INSERT INTO class_card(id, class, learner, card_1, card_2, secret, kept_utc_ms)"
              " VALUES(?, ?, ?, ?, ?, ?, ?)")
        .bind(card.id)
        .bind(card.class_id)
        .bind(card.learner)
        .bind(card.pictures.card[0])
        .bind(card.pictures.card[1])
        .bind(card.pictures.secret)
        .bind(card.kept_utc_ms)
        .run();
}

}  // namespace

void keep(Database& database, const ClassRows& rows) {
    const auto keep_each = [&](const auto& records) {
        for (const auto& record : records) {
            keep_one(database, record);
        }
    };
    keep_each(rows.classes);
    keep_each(rows.settings);
    keep_each(rows.cards);
}

ClassRows read_classes(Database& database) {
    ClassRows rows{read_all<ClassRecord>(database, kSelectClass),
                   read_all<ClassSetting>(database, kSelectClassSetting),
                   read_all<ClassCard>(database, kSelectClassCard),
                   {}};
    Statement row(database, (std::string(kSelectLearner) +
                             " WHERE learner.id IN (SELECT learner FROM class_card) ORDER BY row")
                                .c_str());
    while (row.step()) {
        rows.pupils.push_back(learner_of(row));
    }
    return rows;
}

}  // namespace fulcrum::runtime::sqlite
