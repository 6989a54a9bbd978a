#include "tests/support/csv_reader.h"

namespace fulcrum {
namespace {

// Reads a quoted cell whose opening quote is at `at`; false when it never closes.
bool read_quoted(const std::string& text, std::size_t& at, std::string& cell) {
    for (++at; at < text.size(); ++at) {
        if (text[at] != '"') {
            cell += text[at];
        } else if (at + 1 < text.size() && text[at + 1] == '"') {
            cell += text[++at];
        } else {
            ++at;
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<std::vector<std::vector<std::string>>> parse_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::size_t at = 0;
    while (at < text.size()) {
        std::vector<std::string> row;
        while (true) {
            std::string cell;
            if (text[at] == '"') {
                if (!read_quoted(text, at, cell)) {
                    return std::nullopt;
                }
            } else {
                const std::size_t end = text.find_first_of(",\"\r\n", at);
                cell = text.substr(at, end - at);
                at = end;
            }
            row.push_back(cell);
            if (at >= text.size() || (text[at] != ',' && text.compare(at, 2, "\r\n") != 0)) {
                return std::nullopt;
            }
            at += text[at] == ',' ? 1 : 2;
            if (text[at - 1] == '\n') {
                break;
            }
        }
        rows.push_back(row);
    }
    return rows;
}

}  // namespace fulcrum
