// The list of benchmarks. A new one is one file under tests/bench/curves that registers itself:
//
//   Report run_wall(Run& run) { ...; run.progress(0.5); ...; return {curve}; }
//   const Registration kWall{{"wall", "what a stiff wall costs", run_wall}};
#pragma once

#include "tests/bench/harness/report.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace fulcrum::bench {

/// What a running benchmark is told and may ask.
class Run {
  public:
    /// `say` gets the share done, 0 to 1, and a few words.
    using Say = std::function<void(double, const std::string&)>;
    Run(bool quick, Say say, std::string mesh_file = {}, std::string tool_file = {},
        std::string text_file = {})
        : quick_(quick),
          say_(std::move(say)),
          mesh_file_(std::move(mesh_file)),
          tool_file_(std::move(tool_file)),
          text_file_(std::move(text_file)) {}

    /// True when a rough answer within a few seconds is wanted: fewer settings, fewer repetitions, the same figures.
    [[nodiscard]] bool quick() const { return quick_; }
    /// The mesh that a person wants to see measured; empty when none was named.
    [[nodiscard]] const std::string& mesh_file() const { return mesh_file_; }
    /// The same for what touches it.
    [[nodiscard]] const std::string& tool_file() const { return tool_file_; }
    /// A table of learners' sentences that a person has; empty when none was named.
    [[nodiscard]] const std::string& text_file() const { return text_file_; }
    /// Tells the person who waits how far it has come: `share` 0 to 1.
    void progress(double share, const std::string& what = {}) const { say_(share, what); }
    /// The same: so many of so many are done.
    void progress(std::size_t done, std::size_t all, const std::string& what) const {
        say_(static_cast<double>(done) / static_cast<double>(all), what);
    }
    /// `full` or, in a quick run, `rough`.
    template <class T>
    [[nodiscard]] T pick(T full, T rough) const {
        return quick_ ? rough : full;
    }

  private:
    bool quick_;
    Say say_;
    std::string mesh_file_;
    std::string tool_file_;
    std::string text_file_;
};

struct Bench {
    std::string name;  ///< what `fulcrum bench NAME` asks for: "integrators"
    std::string what;  ///< one line for the list
    std::function<Report(Run&)> run;
};

/// Adds to the list while the program starts.
struct Registration {
    explicit Registration(Bench bench);
};

/// All of them, by name.
[[nodiscard]] const std::vector<Bench>& all_benches();

/// Another library's points for one of our curves, or rows for one of our sheets, measured in the same run. Peers live under
/// tests/bench/peers and are built only where their packages are installed.
struct Peer {
    std::string name;   ///< "ODE 0.16.2"
    std::string curve;  ///< name of the CostCurve or Sheet that it joins
    std::function<std::vector<CostPoint>(Run&)> points;  ///< of a curve
    /// What a reader must know to compare, joined to the curve's `work` once; empty: nothing.
    std::string note{};
    std::function<std::vector<std::vector<std::string>>(Run&)> rows{};  ///< of a sheet
};

/// Adds to the list while the program starts.
struct PeerRegistration {
    explicit PeerRegistration(Peer peer);
};

/// All that were built, by name.
[[nodiscard]] const std::vector<Peer>& all_peers();

}  // namespace fulcrum::bench
