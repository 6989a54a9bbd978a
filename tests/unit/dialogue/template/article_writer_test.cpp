#include "dialogue/template/article_writer.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum::dialogue;

namespace {

/// The articles of a branch, each with what belongs there where that is another: "a the:the …".
std::string articles(Branch branch, ArticlePolicy policy) {
    TemplateSet set;
    ArcWriter writer(set, kLargestGraph_arcs);
    const int from = writer.add_node();
    const int to = writer.add_node();
    const int determiner = writer.add_element({Role::determiner});
    ArticleWriter(writer, policy, false, determiner, from, to).write(branch);
    std::string text;
    for (const Arc& arc : writer.arcs()) {
        const std::string said = writer.said_by(arc);
        const std::string right = writer.right_of(arc);
        text += (text.empty() ? "" : " ") + (said.empty() ? "-" : said);
        text += arc.code == ErrorCode::none ? "" : ":" + (right.empty() ? "-" : right);
    }
    return text;
}

}  // namespace

TEST_CASE("article writer: behind no there is none, whatever the noun") {
    for (const Branch branch : {Branch::with_a, Branch::bare_or_the, Branch::name}) {
        CHECK(articles(branch, ArticlePolicy::after_no) ==
              "- a:- an:- the:- this:- that:- these:- those:- some:- its:-");
    }
}

TEST_CASE("article writer: what is around everybody has its the") {
    CHECK(articles(Branch::the_stuff, ArticlePolicy::definite) ==
          "the this that -:the a:the an:the");
}
