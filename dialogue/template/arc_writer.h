// Collects the nodes and arcs of one graph while it is built, within a budget, and puts them in order at the end.
//
// Thread: one.  Cost: linear in the arcs.
#pragma once

#include "dialogue/template/graph.h"

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// What costs how much; a path with the least sum is how an utterance is understood. A slip is 10.
inline constexpr int kSlipCost = 10;
inline constexpr int kPatternCost = 20;
inline constexpr int kOtherDegreeCost = 30;
inline constexpr int kOrderCost = 30;  ///< a missing or a wrong word explains a sentence better
inline constexpr int kKindCost =
    30;  ///< "apples" for "the apple", before it is known whether that is right

/// What an arc says and means, before it is stored.
struct ArcText {
    std::string_view said;   ///< words apart by spaces; empty when nothing is said
    std::string_view right;  ///< what belongs here; empty when nothing does
    ErrorCode code = ErrorCode::none;
    int cost = 0;
    bool canonical = false;
    int item = kNone;
    Number number = Number::singular;
};

/// Builds one graph of `set`.
class ArcWriter {
  public:
    /// `budget` is how many more arcs the whole set may have.
    ArcWriter(TemplateSet& set, std::size_t budget) : set_(set), budget_(budget) {}

    int add_node() { return nodes_++; }
    int add_element(Element element);
    void add_arc(int from, int to, int element, const ArcText& text);
    /// An arc that stands for nothing.
    void join(int from, int to);
    /// The same as `arc` between other nodes.
    void add_copy(Arc arc, int from, int to);
    /// True once the budget is spent; arcs are no longer taken.
    [[nodiscard]] bool full() const { return graph_.arcs.size() >= budget_; }
    /// How many more arcs are taken.
    [[nodiscard]] std::size_t room() const { return full() ? 0 : budget_ - graph_.arcs.size(); }
    /// What was written so far, with the nodes as they were added.
    [[nodiscard]] const std::vector<Arc>& arcs() const { return graph_.arcs; }
    [[nodiscard]] const Element& element(int number) const {
        return graph_.elements[static_cast<std::size_t>(number)];
    }
    /// The words of `arc`, and what belongs there.
    [[nodiscard]] std::string said_by(const Arc& arc) const;
    [[nodiscard]] std::string right_of(const Arc& arc) const;
    /// Numbers the nodes upwards from `start` to `end` and hands the graph over.
    [[nodiscard]] Graph finish(int start, int end);

  private:
    [[nodiscard]] std::vector<int> upward_order(int start, int end) const;

    TemplateSet& set_;
    std::size_t budget_;
    Graph graph_;
    int nodes_ = 0;
};

}  // namespace fulcrum::dialogue
