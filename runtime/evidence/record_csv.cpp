#include "runtime/evidence/record_csv.h"

#include "runtime/evidence/record_words.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace fulcrum::runtime {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kRowsBetweenLooks = 1024;  // at whether somebody wants it to stop

struct CloseStream {
    void operator()(std::FILE* file) const noexcept { (void)std::fclose(file); }
};

std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

// What a learner said is no formula of the spreadsheet that opens it: a quote goes before a cell that begins like one.
std::string text_cell(const std::string& text) {
    constexpr std::string_view kStarts[] = {"=",      "+",      "-",      "@",
                                            "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
    const std::string_view from_word =
        std::string_view(text).substr(std::min(text.find_first_not_of(' '), text.size()));
    const bool looks_like_formula = std::ranges::any_of(
        kStarts, [&](std::string_view start) { return from_word.starts_with(start); });
    return cell(looks_like_formula ? "'" + text : text);
}

// One table on its way to its place; gone, if it never takes it.
class Table {
  public:
    explicit Table(fs::path place) : place_(std::move(place)), part_(place_.string() + ".part") {}
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;
    ~Table() {
        file_.reset();
        std::error_code ignored;
        if (is_begun_) {
            fs::remove(part_, ignored);
        }
    }

    Expected<void> begin() {
        if (std::error_code error; fs::is_directory(place_, error)) {
            return trouble("it is a folder");
        }
        file_.reset(std::fopen(part_.c_str(), "wb"));
        is_begun_ = file_ != nullptr;
        return is_begun_ ? Expected<void>{} : trouble(std::strerror(errno));
    }
    Expected<void> add(const std::string& row) {
        const std::string line = row + "\r\n";
        return std::fwrite(line.data(), 1, line.size(), file_.get()) == line.size()
                   ? Expected<void>{}
                   : trouble(std::strerror(errno));
    }
    Expected<void> close() {
        return std::fclose(file_.release()) == 0 ? Expected<void>{} : trouble(std::strerror(errno));
    }
    Expected<void> take_place() {
        std::error_code error;
        fs::rename(part_, place_, error);
        is_begun_ = static_cast<bool>(error);
        return error ? trouble(error.message()) : Expected<void>{};
    }

  private:
    [[nodiscard]] Expected<void> trouble(const std::string& why) const {
        return fail("the table cannot be written: " + why, place_.string(),
                    "give --out a file in a folder that has room and can be written to");
    }

    fs::path place_;
    fs::path part_;
    std::unique_ptr<std::FILE, CloseStream> file_;
    bool is_begun_ = false;
};

void add_numbers(std::string& row, std::initializer_list<double> numbers) {
    for (const double x : numbers) {
        row += (row.empty() ? "" : ",") + exact_text(x);
    }
}

void add_vector(std::string& row, const Vector3& v) {
    add_numbers(row, {v.x(), v.y(), v.z()});
}

void add_pose(std::string& row, const Pose& pose) {
    add_vector(row, pose.position);
    const Quaternion& q = pose.orientation;
    add_numbers(row, {q.w(), q.x(), q.y(), q.z()});
}

void add_wrench(std::string& row, const Wrench& wrench) {
    add_vector(row, wrench.force);
    add_vector(row, wrench.torque);
}

std::string wrench_columns(const std::string& name) {
    std::string columns;
    for (const char* part : {"_force_x_N", "_force_y_N", "_force_z_N", "_torque_x_Nm",
                             "_torque_y_Nm", "_torque_z_Nm"}) {
        columns += "," + cell(name + part);
    }
    return columns;
}

std::string name_of_body(const Record& record, std::int32_t body) {
    if (body == kNoBody) {
        return {};
    }
    const auto i = static_cast<std::size_t>(body);
    return i < record.header.bodies.size() ? record.header.bodies[i] : std::to_string(body);
}

fs::path beside(const fs::path& file, const char* what) {
    fs::path path = file;
    path.replace_extension(std::string(what) + ".csv");
    return path;
}

template <class Rows, class ToRow>
Expected<void> write_table(Table& table, const std::string& head, const Rows& rows,
                           const ToRow& to_row, const std::function<bool(std::size_t)>& go_on) {
    auto good = table.begin().and_then([&] { return table.add(head); });
    for (std::size_t i = 0; good && i < rows.size(); ++i) {
        if (i % kRowsBetweenLooks == 0 && !go_on(i)) {
            return fail("the export was stopped, and nothing was written", {}, "start it again");
        }
        good = table.add(to_row(i));
    }
    return good.and_then([&] { return table.close(); });
}

// A table of rounds for each hand beside the first.
Expected<void> export_more_hands(const Record& record, const fs::path& file,
                                 const std::function<bool(std::size_t)>& go_on) {
    Expected<void> good;
    for (std::size_t hand = 1; good && hand <= record.more_hands.size(); ++hand) {
        const std::string name = ".hand" + std::to_string(hand + 1);
        const Record alone = *find_hand(record, hand);
        Table rounds(beside(file, name.c_str()));
        good = write_table(
                   rounds, sample_header(alone), alone.samples,
                   [&](std::size_t i) { return sample_row(alone, i); }, go_on)
                   .and_then([&] { return rounds.take_place(); });
    }
    return good;
}

}  // namespace

std::string sample_header(const Record& record) {
    std::string head =
        "tick,time_s,stamp_s,device_x_m,device_y_m,device_z_m,device_qw,device_qx,device_qy,"
        "device_qz,velocity_x_m_per_s,velocity_y_m_per_s,velocity_z_m_per_s,spin_x_rad_per_s,"
        "spin_y_rad_per_s,spin_z_rad_per_s";
    head += wrench_columns("commanded") + wrench_columns("applied");
    head += ",buttons,gate,faults,touched";
    for (const std::string& effect : record.header.effects) {
        head += wrench_columns(effect);
    }
    return head;
}

std::string sample_row(const Record& record, std::size_t sample) {
    const RecordSample& s = record.samples[sample];
    std::string row = std::to_string(s.tick);
    add_numbers(row, {s.time_s, s.stamp_s});
    add_pose(row, s.pose_D);
    add_vector(row, s.twist_W.linear);
    add_vector(row, s.twist_W.angular);
    add_wrench(row, s.commanded_W);
    add_wrench(row, s.applied_W);
    row += "," + std::to_string(s.buttons) + "," + std::string(gate_word(s.gate)) + "," +
           cell(fault_words(s.faults)) + "," + text_cell(name_of_body(record, s.touched_body));
    for (const Wrench& share_W : record.shares_of(sample)) {
        add_wrench(row, share_W);
    }
    return row;
}

Expected<void> export_record(const Record& record, const fs::path& file,
                             const ExportProgress& progress) {
    Table samples(file);
    Table events(beside(file, ".events"));
    Table bodies(beside(file, ".bodies"));
    Table facts(beside(file, ".facts"));
    const auto all = static_cast<double>(std::max<std::size_t>(record.samples.size(), 1));
    const auto go_on = [&](std::size_t done) {
        return !progress || progress(static_cast<double>(done) / all);
    };
    const auto always = [](std::size_t) { return true; };
    const auto event_row = [&](std::size_t i) {
        const RecordEvent& event = record.events[i];
        return exact_text(event.time_s) + "," + std::string(event_word(event.kind)) + "," +
               text_cell(name_of_body(record, event.body)) + "," + text_cell(event.text);
    };
    const auto body_row = [&](std::size_t i) {
        const RecordBody& body = record.bodies[i];
        std::string row = exact_text(body.time_s) + "," +
                          text_cell(name_of_body(record, body.body)) + "," +
                          std::string(where_word(body.state.where));
        add_pose(row, body.state.pose_W);
        add_vector(row, body.state.velocity_W);
        return row;
    };
    const auto fact_row = [&](std::size_t i) {
        return text_cell(record.header.facts[i].name) + "," +
               text_cell(record.header.facts[i].value);
    };
    return write_table(
               samples, sample_header(record), record.samples,
               [&](std::size_t i) { return sample_row(record, i); }, go_on)
        .and_then([&] {
            return write_table(events, "time_s,kind,body,text", record.events, event_row, always);
        })
        .and_then([&] {
            return write_table(bodies,
                               "time_s,body,where,x_m,y_m,z_m,qw,qx,qy,qz,velocity_x_m_per_s,"
                               "velocity_y_m_per_s,velocity_z_m_per_s",
                               record.bodies, body_row, always);
        })
        .and_then(
            [&] { return write_table(facts, "name,value", record.header.facts, fact_row, always); })
        .and_then([&] { return facts.take_place(); })
        .and_then([&] { return bodies.take_place(); })
        .and_then([&] { return events.take_place(); })
        .and_then([&] { return samples.take_place(); })
        .and_then([&] { return export_more_hands(record, file, go_on); });
}

}  // namespace fulcrum::runtime
