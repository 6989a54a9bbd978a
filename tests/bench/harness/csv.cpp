#include "tests/bench/harness/csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace fulcrum::bench {
namespace {

constexpr std::array<std::string_view, 3> kStyles{"measured", "theory", "dots"};

// ---- writing

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r#") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + "\"";
}

std::string row_of(const std::vector<std::string>& cells) {
    std::string row;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        row += (i > 0 ? "," : "") + quoted(cells[i]);
    }
    return row + "\n";
}

// A head line holds one line of text.
std::string head(std::string_view key, std::string value) {
    for (char& c : value) {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    return "# " + std::string(key) + ": " + value + "\n";
}

std::string axis_text(const Axis& axis) {
    return axis.name + " [" + axis.unit + "]" + (axis.logarithmic ? " log" : "");
}

std::string with_unit(const Axis& axis) {
    return axis.unit.empty() ? axis.name : axis.name + " [" + axis.unit + "]";
}

template <class E>
std::string common_head(std::string_view kind, const E& exhibit) {
    return head("kind", std::string(kind)) + head("name", exhibit.name) +
           head("title", exhibit.title) + head("work", exhibit.work) +
           head("advice", exhibit.advice);
}

std::string body_of(const CostCurve& curve) {
    std::string text = common_head("cost", curve) + head("reference", curve.reference) +
                       head("knob", axis_text(curve.knob)) + head("error", axis_text(curve.error));
    std::vector<std::string> columns{
        "series",   with_unit(curve.knob), with_unit(curve.error), "median [us]",
        "p99 [us]", "memory [bytes]"};
    for (const Axis& extra : curve.extras) {
        text += head("extra", axis_text(extra));
        columns.push_back(with_unit(extra));
    }
    text += head("default series", curve.default_series) +
            head("default knob", to_text(curve.default_knob)) +
            head("time is per", curve.time_is_per) + row_of(columns);
    for (const CostPoint& p : curve.points) {
        std::vector<std::string> cells{p.series,
                                       to_text(p.knob),
                                       to_text(p.error),
                                       to_text(p.cost.median_us),
                                       to_text(p.cost.p99_us),
                                       std::to_string(p.cost.bytes)};
        for (std::size_t i = 0; i < curve.extras.size(); ++i) {
            cells.push_back(to_text(i < p.extras.size() ? p.extras[i] : kNone));
        }
        text += row_of(cells);
    }
    return text;
}

std::string body_of(const LineChart& chart) {
    std::string text = common_head("lines", chart) + head("reference", chart.reference) +
                       head("x", axis_text(chart.x)) + head("y", axis_text(chart.y));
    for (const Line& line : chart.lines) {
        text += head("line",
                     std::string(kStyles[static_cast<std::size_t>(line.style)]) + " " + line.name);
    }
    text += row_of({"line", with_unit(chart.x), with_unit(chart.y)});
    for (const Line& line : chart.lines) {
        for (std::size_t i = 0; i < line.x.size() && i < line.y.size(); ++i) {
            text += row_of({line.name, to_text(line.x[i]), to_text(line.y[i])});
        }
    }
    return text;
}

std::string body_of(const Sheet& sheet) {
    std::string text = common_head("sheet", sheet) + row_of(sheet.columns);
    for (const auto& row : sheet.rows) {
        text += row_of(row);
    }
    return text;
}

// ---- reading

struct Table {
    std::vector<std::pair<std::string, std::string>> heads;
    std::vector<std::vector<std::string>> rows;  // the first one names the columns

    [[nodiscard]] std::string first(std::string_view key) const {
        for (const auto& [k, value] : heads) {
            if (k == key) {
                return value;
            }
        }
        return {};
    }
    [[nodiscard]] std::vector<std::string> all(std::string_view key) const {
        std::vector<std::string> values;
        for (const auto& [k, value] : heads) {
            if (k == key) {
                values.push_back(value);
            }
        }
        return values;
    }
};

// One record from `text` on, which is shortened by it.
std::vector<std::string> take_record(std::string_view& text) {
    std::vector<std::string> cells(1);
    bool inside = false;
    while (!text.empty()) {
        const char c = text.front();
        text.remove_prefix(1);
        if (inside && c == '"' && text.starts_with('"')) {
            cells.back() += '"';
            text.remove_prefix(1);
        } else if (c == '"') {
            inside = !inside;
        } else if (inside) {
            cells.back() += c;
        } else if (c == ',') {
            cells.emplace_back();
        } else if (c == '\n') {
            break;
        } else if (c != '\r') {
            cells.back() += c;
        }
    }
    return cells;
}

Table split(std::string_view text) {
    Table table;
    while (text.starts_with("# ")) {
        std::string_view line = text.substr(2, text.find('\n') - 2);
        text.remove_prefix(std::min(text.size(), line.size() + 3));
        line.remove_suffix(line.ends_with('\r') ? 1 : 0);
        const std::size_t colon = line.find(": ");
        if (colon != std::string_view::npos) {
            table.heads.emplace_back(line.substr(0, colon), line.substr(colon + 2));
        }
    }
    while (!text.empty()) {
        table.rows.push_back(take_record(text));
    }
    return table;
}

double to_number(const std::string& cell) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return cell.empty() || *end != '\0' ? kNone : value;
}

std::size_t to_bytes(const std::string& cell) {
    constexpr double kMost = 1e18;  // beyond it the number is a mistake
    const double value = to_number(cell);
    return value >= 0.0 && value <= kMost ? static_cast<std::size_t>(value) : 0;
}

// "name [unit] log"
Axis read_axis(const std::string& text) {
    const std::size_t open = text.rfind(" [");
    const std::size_t close = text.rfind(']');
    if (open == std::string::npos || close == std::string::npos || close < open) {
        return {text, {}, false};
    }
    return {text.substr(0, open), text.substr(open + 2, close - open - 2),
            text.find(" log", close) != std::string::npos};
}

template <class E>
E read_common(const Table& table) {
    E exhibit;
    exhibit.name = table.first("name");
    exhibit.title = table.first("title");
    exhibit.work = table.first("work");
    exhibit.advice = table.first("advice");
    return exhibit;
}

Exhibit read_cost(const Table& table) {
    auto curve = read_common<CostCurve>(table);
    curve.reference = table.first("reference");
    curve.knob = read_axis(table.first("knob"));
    curve.error = read_axis(table.first("error"));
    for (const std::string& extra : table.all("extra")) {
        curve.extras.push_back(read_axis(extra));
    }
    curve.default_series = table.first("default series");
    curve.default_knob = to_number(table.first("default knob"));
    curve.time_is_per = table.first("time is per");
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        const auto& cells = table.rows[i];
        CostPoint p;
        p.series = cells[0];
        p.knob = to_number(cells[1]);
        p.error = to_number(cells[2]);
        p.cost.median_us = to_number(cells[3]);
        p.cost.p99_us = to_number(cells[4]);
        p.cost.bytes = to_bytes(cells[5]);
        for (std::size_t k = 6; k < cells.size(); ++k) {
            p.extras.push_back(to_number(cells[k]));
        }
        curve.points.push_back(std::move(p));
    }
    return curve;
}

Exhibit read_lines(const Table& table) {
    auto chart = read_common<LineChart>(table);
    chart.reference = table.first("reference");
    chart.x = read_axis(table.first("x"));
    chart.y = read_axis(table.first("y"));
    for (const std::string& text : table.all("line")) {
        const std::size_t blank = text.find(' ');
        const auto style = std::ranges::find(kStyles, std::string_view(text).substr(0, blank));
        Line line;
        line.style = style == kStyles.end() ? LineStyle::measured
                                            : static_cast<LineStyle>(style - kStyles.begin());
        line.name = blank == std::string::npos ? std::string{} : text.substr(blank + 1);
        for (std::size_t i = 1; i < table.rows.size(); ++i) {
            if (table.rows[i][0] == line.name) {
                line.x.push_back(to_number(table.rows[i][1]));
                line.y.push_back(to_number(table.rows[i][2]));
            }
        }
        chart.lines.push_back(std::move(line));
    }
    return chart;
}

Exhibit read_sheet(const Table& table) {
    auto sheet = read_common<Sheet>(table);
    sheet.columns = table.rows.front();
    sheet.rows.assign(table.rows.begin() + 1, table.rows.end());
    return sheet;
}

}  // namespace

std::string to_text(double value) {
    if (!std::isfinite(value)) {
        return {};
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

std::string to_csv(const Exhibit& exhibit, const Environment& environment) {
    const std::string origin = head("commit", environment.commit) +
                               head("compiler", environment.compiler) +
                               head("cpu", environment.cpu) + head("command", environment.command) +
                               head("date", environment.date);
    return origin + std::visit([](const auto& e) { return body_of(e); }, exhibit);
}

Expected<Exhibit> read_csv(std::string_view text, const std::string& file) {
    const Table table = split(text);
    struct Kind {
        std::string_view name;
        std::size_t least_columns;
        Exhibit (*read)(const Table&);
    };
    constexpr std::array<Kind, 3> kKinds{
        {{"cost", 6, read_cost}, {"lines", 3, read_lines}, {"sheet", 1, read_sheet}}};
    const auto kind = std::ranges::find(kKinds, std::string_view(table.first("kind")), &Kind::name);
    if (kind == kKinds.end()) {
        return fail("this is no figure's CSV", file, "give a file that fulcrum bench wrote");
    }
    if (table.rows.empty() || table.rows.front().size() < kind->least_columns) {
        return fail("the line that names the columns is missing", file,
                    "make the file again with fulcrum bench");
    }
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        if (table.rows[i].size() != table.rows.front().size()) {
            return fail("data row " + std::to_string(i) + " has " +
                            std::to_string(table.rows[i].size()) + " cells, not " +
                            std::to_string(table.rows.front().size()),
                        file, "make the file again with fulcrum bench");
        }
    }
    return kind->read(table);
}

const std::string& name_of(const Exhibit& exhibit) {
    return std::visit([](const auto& e) -> const std::string& { return e.name; }, exhibit);
}

const std::string& title_of(const Exhibit& exhibit) {
    return std::visit([](const auto& e) -> const std::string& { return e.title; }, exhibit);
}

}  // namespace fulcrum::bench
