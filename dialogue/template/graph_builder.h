// Walks a parsed template and writes its graph.
//
// Thread: one.  Cost: linear in what is written; every part writes an arc, so the budget of arcs bounds the steps too.
#pragma once

#include "dialogue/result.h"
#include "dialogue/template/arc_writer.h"
#include "dialogue/template/phrases.h"
#include "dialogue/template/syntax.h"

#include <map>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// A part of a graph under construction.
struct Built {
    int to = 0;                  ///< the node after it
    std::uint32_t slots = 0;     ///< those it can fill
    std::uint32_t required = 0;  ///< those it always fills
    std::uint32_t definite = 0;  ///< those that stand behind "the"
};

/// Slots that forms of grammar fill.
struct FormSlots {
    std::vector<int> adjectives;  ///< <adjective:{…}>
    int things = kNone;           ///< the last list before <made_of:{…}>: what is made
    int material = kNone;         ///< <made_of:{…}>
    SubjectNumber subject = SubjectNumber::unknown;  ///< of plain words before <made_of:…>
};

/// The rules of a question, parsed.
using ParsedRules = std::map<std::string, Syntax, std::less<>>;

/// Builds one graph.
class GraphBuilder {
  public:
    /// `pronoun` is the number of what <it> stands for.
    GraphBuilder(TemplateSet& set, ArcWriter& writer, const ParsedRules& rules,
                 SubjectNumber pronoun = SubjectNumber::unknown)
        : set_(set), writer_(writer), rules_(rules), pronoun_(pronoun) {}

    /// Writes `syntax` from `from` on.
    [[nodiscard]] Expected<Built> build(const Syntax& syntax, int from);

    /// The slots of grammar that were written, in the order of the template.
    [[nodiscard]] const FormSlots& form_slots() const { return form_slots_; }

  private:
    Expected<Built> node(const Syntax& syntax, int index, int from, Neighbours neighbours);
    Expected<Built> sequence(const Syntax& syntax, const SyntaxNode& part, int from,
                             Neighbours neighbours);
    /// What may be said behind the parts [first, last] of a sequence though the author doesn't say it: "of all", "than the egg *is*"; the
    /// node behind it.
    int add_tail(const Syntax& syntax, const SyntaxNode& sequence, std::size_t first,
                 std::size_t last, bool closes, int from);
    Expected<Built> alternatives(const Syntax& syntax, const SyntaxNode& part, bool optional,
                                 int from, Neighbours neighbours);
    Expected<Built> permutation(const Syntax& syntax, const SyntaxNode& part, int from);
    Expected<Built> list(const SyntaxNode& part, ArticlePolicy policy, int from, bool behind_is);
    Expected<Built> rule(const Syntax& syntax, const SyntaxNode& part, int from,
                         Neighbours neighbours);
    Expected<Built> form(const Syntax& syntax, const SyntaxNode& part, int from,
                         Neighbours neighbours);
    Expected<Built> degree(const Syntax& syntax, const SyntaxNode& part, Degree degree, int from,
                           Neighbours neighbours);
    Expected<Built> made_of(const Syntax& syntax, const SyntaxNode& part, int from,
                            Neighbours neighbours);
    struct Words;
    Expected<Words> words_of_form(const Syntax& syntax, const SyntaxNode& part);
    [[nodiscard]] Expected<std::size_t> list_number(const SyntaxNode& part) const;
    Expected<int> slot_number(const SyntaxNode& part, int list);
    Expected<bool> step(const SyntaxNode& part);

    TemplateSet& set_;
    ArcWriter& writer_;
    const ParsedRules& rules_;
    SubjectNumber pronoun_;
    FormSlots form_slots_;
    std::vector<std::string> open_rules_;
};

}  // namespace fulcrum::dialogue
