// What the command line does with a record alone: no lesson is started.
#include "haptics/record/record.h"
#include "haptics/record/record_reader.h"
#include "runtime/app/commands.h"
#include "runtime/app/interrupt.h"
#include "runtime/evidence/force_account.h"
#include "runtime/evidence/record_csv.h"
#include "runtime/text/progress_line.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace fulcrum::runtime {
namespace {

namespace fs = std::filesystem;

// Of each hand.
Expected<std::vector<ForceAccount>> find_accounts(const Record& record, double time_s) {
    std::vector<ForceAccount> accounts;
    for (std::size_t hand = 0; hand <= record.more_hands.size(); ++hand) {
        auto account = hand == 0 ? find_account(record, time_s)
                                 : find_account(*find_hand(record, hand), time_s);
        if (!account) {
            return tl::unexpected(account.error());
        }
        account->hand = hand;
        accounts.push_back(std::move(*account));
    }
    return accounts;
}

Expected<Record> load_told(const std::string& path) {
    auto record = load_record(path);
    if (record && record->cut_off) {
        std::fprintf(stderr, "%s: %s; its first %zu rounds are whole.\n", path.c_str(),
                     record->fault.c_str(), record->samples.size());
    }
    return record;
}

// Beside the record, unless a place is named. A record must not be written over.
Expected<fs::path> choose_place(const Options& options) {
    fs::path place = options.out;
    if (place.empty()) {
        place = fs::path(options.lesson).replace_extension(".csv");
    }
    std::error_code error;
    if (fs::weakly_canonical(place, error) == fs::weakly_canonical(options.lesson, error)) {
        return fail("the table would take the record's own place", place.string(),
                    "give --out another file");
    }
    return place;
}

}  // namespace

int explain_force_command(const Options& options) {
    if (options.analyze || options.seconds || !options.hands.empty() || !options.say.empty()) {
        return complain({"--force is of a record, which is not played", {}, "leave the rest out"},
                        2);
    }
    const auto accounts = load_told(options.lesson).and_then([&](const Record& record) {
        return find_accounts(record, *options.force_at_s);
    });
    if (!accounts) {
        Error error = accounts.error();
        error.where = error.where.empty() ? options.lesson : error.where;
        return complain(error, 2);
    }
    if (options.json) {
        std::fputs(accounts_json(*accounts).c_str(), stdout);
        return 0;
    }
    for (std::size_t i = 0; i < accounts->size(); ++i) {
        if (accounts->size() > 1) {
            std::printf("%sHand %zu\n", i == 0 ? "" : "\n", i + 1);
        }
        std::fputs(account_text((*accounts)[i]).c_str(), stdout);
    }
    return 0;
}

int export_command(const Options& options) {
    const auto place = choose_place(options);
    if (!place) {
        return complain(place.error(), 2);
    }
    const auto record = load_told(options.lesson);
    if (!record) {
        return complain(record.error(), 2);
    }
    ProgressLine line("Writing " + place->string() + ":");
    const auto written = export_record(*record, *place, [&](double share) {
        line.say(share);
        return !interrupted();
    });
    line.clear();
    if (!written) {
        return interrupted() ? interrupt_exit_code() : complain(written.error(), 2);
    }
    std::printf("%s: %zu rounds, %zu events, %zu places of bodies.\n", place->string().c_str(),
                record->samples.size(), record->events.size(), record->bodies.size());
    return 0;
}

}  // namespace fulcrum::runtime
