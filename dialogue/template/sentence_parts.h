// A template's text in its parts: where its verb stands, what is compared there, which slots it has. For sentences that are made of it.
//
// Thread: pure.  Cost: linear in the text.
#pragma once

#include "dialogue/template/graph.h"
#include "dialogue/template/graph_builder.h"
#include "dialogue/template/what_follows.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// The parts of one sentence, numbered from 0. All that is handed over outlives it.
class SentenceParts {
  public:
    SentenceParts(const TemplateSet& set, const ParsedRules& rules, const std::string& text,
                  const Syntax& syntax);

    /// None where several sentences stand side by side.
    [[nodiscard]] std::size_t size() const { return parts_.size(); }
    /// A part without brackets that hold nothing else.
    [[nodiscard]] const SyntaxNode& part(std::size_t i) const;
    /// The author's text of the parts [first, last).
    [[nodiscard]] std::string text(std::size_t first, std::size_t last) const;
    [[nodiscard]] bool is_word(std::size_t i, std::string_view word) const;
    /// "is", "are", "(is|feels)".
    [[nodiscard]] bool is_be(std::size_t i) const;
    /// "is" or "are" of such a part.
    [[nodiscard]] std::string be(std::size_t i) const;
    /// The name of a form of grammar; empty for another part.
    [[nodiscard]] std::string_view form(std::size_t i) const;
    /// Whether the part's first word is this.
    [[nodiscard]] bool begins_with(std::size_t i, std::string_view word) const;
    /// The plain adjectives of a part that is their `degree` and nothing else: "heavy".
    [[nodiscard]] std::vector<std::string> adjectives(std::size_t i, std::string_view degree) const;
    /// The slots of the lists in the parts [first, last); an author's rule is one without a name.
    [[nodiscard]] std::vector<std::string> slots(std::size_t first, std::size_t last) const;
    /// The first part from `first` on that begins with "than"; behind the last for none.
    [[nodiscard]] std::size_t than_at(std::size_t first) const;
    /// The list that fills the slot; null for none.
    [[nodiscard]] const WordList* list_of(const std::string& slot) const;
    /// Two slots may have the same words.
    [[nodiscard]] bool same_words(const std::string& one, const std::string& other) const;
    /// What all words of the slot are, "block" of red and blue blocks; empty for none.
    [[nodiscard]] std::string head_of(const std::string& slot) const;
    /// It asks, tells what there is, or says "not" or "yes" itself: nothing is made of it.
    [[nodiscard]] bool is_plain_statement() const;
    /// The whole with "not" behind the verb at byte `at`; of the brackets around that only the way that it is on stays.
    [[nodiscard]] std::string denied(std::size_t at) const;

  private:
    [[nodiscard]] std::size_t column(std::size_t i) const;
    [[nodiscard]] const SyntaxNode* be_of(const SyntaxNode& node) const;

    const TemplateSet& set_;
    const ParsedRules& rules_;
    const std::string& text_;
    const Syntax& syntax_;
    std::vector<int> parts_;
};

}  // namespace fulcrum::dialogue
