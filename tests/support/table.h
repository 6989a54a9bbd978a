// Tables of what goes in and what comes out: NAME_table.txt beside the tests of a folder, a case a line. A line is
//
//   IN => OUT        what comes out is OUT
//   IN =~ OUT        the same, where " … " in OUT stands for anything
//   IN               what comes out is that of the last @give
//   @each IN / IN    several of these
//   @law NAME        what the lines below it show
//   @try PROBE WITH  what is done with what goes in; the test of the folder has the probes
//   @give OUT
//   # …              says why
//
// A text in quotes may have \n, \t, \r, \\, \" and \xHH in it.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace fulcrum {

/// How the lines of one table are read.
struct TableReader {
    /// What comes out, of what stands behind the probe's name and what goes in.
    using Probe = std::function<std::string(const std::string& with, const std::string& in)>;
    std::map<std::string, Probe> probes{};
    /// Takes what stands behind @law, and lines with any other word; empty where there are none.
    std::function<void(const std::string& word, const std::string& rest)> direct{};
};

/// Holds each table of a folder of the source tree, a section each. A table without a line, a line without an outcome, an
/// unknown probe and an unknown word fail.
void hold_tables(const std::filesystem::path& folder,
                 const std::function<TableReader()>& make_reader);

/// What a field of a line says: as it stands, or what its quotes hold.
[[nodiscard]] std::string table_field(const std::string& written);

/// The parts of "a, b, c"; none of "".
[[nodiscard]] std::vector<std::string> listed(const std::string& text,
                                              const std::string& between = ", ");

/// Each with a blank behind the one before.
template <class Range>
[[nodiscard]] std::string spaced(const Range& texts, const char* between = " ") {
    std::string all;
    bool first = true;
    for (const auto& text : texts) {
        all += first ? "" : between;
        all += text;
        first = false;
    }
    return all;
}

[[nodiscard]] inline std::string yes_or_no(bool is) {
    return is ? "yes" : "no";
}

}  // namespace fulcrum
