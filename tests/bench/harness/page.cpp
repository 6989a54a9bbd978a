#include "tests/bench/harness/page.h"

#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/pareto.h"
#include "tests/bench/harness/svg.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::bench {
namespace {

constexpr const char* kStyle = R"(<style>
body{font:16px/1.5 Andika,sans-serif;color:#222;max-width:960px;margin:2em auto;padding:0 1em}
h2{margin-top:2.5em;border-top:1px solid #ccc;padding-top:.8em}
svg{width:100%;height:auto}
table{border-collapse:collapse;font-size:14px;margin:.6em 0}
td,th{padding:.15em .8em;text-align:right;border-bottom:1px solid #e3e3e3}
td:first-child,th:first-child{text-align:left}
.advice{background:#eef5fb;border-left:5px solid #0072B2;padding:.5em 1em}
.small{font-size:14px;color:#555}
tr.default td{font-weight:bold}
</style>
)";

std::string paragraph(std::string_view label, const std::string& text, std::string_view type = {}) {
    if (text.empty()) {
        return {};
    }
    return "<p" + (type.empty() ? "" : " class=\"" + std::string(type) + "\"") + ">" +
           (label.empty() ? "" : "<b>" + std::string(label) + "</b> ") + escape_xml(text) +
           "</p>\n";
}

std::string row(const std::vector<std::string>& cells, std::string_view cell = "td",
                bool stands_out = false) {
    const std::string tag(cell);
    std::string text = stands_out ? "<tr class=\"default\">" : "<tr>";
    for (const std::string& c : cells) {
        text += "<" + tag + ">" + escape_xml(c) + "</" + tag + ">";
    }
    return text + "</tr>\n";
}

std::string head_of(const Axis& axis) {
    return axis.unit.empty() ? axis.name : axis.name + ", " + axis.unit;
}

std::string table_of(const CostCurve& curve, const std::vector<std::size_t>& which) {
    std::vector<std::string> columns{"method",    head_of(curve.knob), head_of(curve.error),
                                     "median µs", "99 % µs",           "bytes"};
    for (const Axis& extra : curve.extras) {
        columns.push_back(head_of(extra));
    }
    const std::size_t chosen = find_default(curve);
    std::string text = "<table>\n" + row(columns, "th");
    for (const std::size_t i : which) {
        const CostPoint& p = curve.points[i];
        std::vector<std::string> cells{p.series,
                                       to_text(p.knob),
                                       std::isfinite(p.error) ? to_text(p.error) : "unstable",
                                       to_text(p.cost.median_us),
                                       to_text(p.cost.p99_us),
                                       p.cost.bytes > 0 ? std::to_string(p.cost.bytes) : "–"};
        for (const double extra : p.extras) {
            cells.push_back(to_text(extra));
        }
        text += row(cells, "td", i == chosen);
    }
    return text + "</table>\n";
}

std::string place_of_default(const CostCurve& curve) {
    const std::size_t chosen = find_default(curve);
    if (chosen == curve.points.size()) {
        return {};
    }
    const auto front = find_pareto_front(curve.points);
    const CostPoint& p = curve.points[chosen];
    if (std::ranges::find(front, chosen) != front.end()) {
        return "The default (" + p.series + ", " + to_text(p.knob) + " " + curve.knob.unit +
               ") lies on the Pareto front.";
    }
    const auto better = std::ranges::count_if(curve.points, [&](const CostPoint& q) {
        return q.error <= p.error && q.cost.median_us < p.cost.median_us;
    });
    return "The default (" + p.series + ", " + to_text(p.knob) + " " + curve.knob.unit +
           ") is not on the Pareto front: " + std::to_string(better) +
           (better == 1 ? " setting is" : " settings are") + " at least as exact and faster.";
}

std::string section(const CostCurve& curve) {
    std::vector<std::size_t> all(curve.points.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = i;
    }
    return paragraph("Work.", curve.work) + paragraph("Reference.", curve.reference) +
           "<p><b>Pareto front</b>, from the fastest to the most exact; the default is "
           "bold.</p>\n" +
           table_of(curve, find_pareto_front(curve.points)) +
           paragraph("", place_of_default(curve)) + paragraph("Choose.", curve.advice, "advice") +
           "<details><summary>all settings</summary>\n" + table_of(curve, all) + "</details>\n";
}

std::string section(const LineChart& chart) {
    return paragraph("Work.", chart.work) + paragraph("Beside it.", chart.reference) +
           paragraph("Choose.", chart.advice, "advice");
}

std::string section(const Sheet& sheet) {
    std::string text = paragraph("Work.", sheet.work) + "<table>\n" + row(sheet.columns, "th");
    for (const auto& cells : sheet.rows) {
        text += row(cells);
    }
    return text + "</table>\n" + paragraph("Choose.", sheet.advice, "advice");
}

std::string link_to(const Exhibit& exhibit) {
    return "<li><a href=\"#" + escape_xml(name_of(exhibit)) + "\">" +
           escape_xml(title_of(exhibit)) + "</a></li>\n";
}

std::string whole_section(const Exhibit& exhibit) {
    return "<h2 id=\"" + escape_xml(name_of(exhibit)) + "\">" + escape_xml(title_of(exhibit)) +
           "</h2>\n" + draw_svg(exhibit) +
           std::visit([](const auto& e) { return section(e); }, exhibit);
}

}  // namespace

std::string make_page(const Report& exhibits, const Environment& environment,
                      const std::vector<std::string>& peers) {
    std::string page =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\">\n"
        "<title>What accuracy costs in time</title>\n" +
        std::string(kStyle) + "</head><body>\n<h1>What accuracy costs in time</h1>\n";
    page += paragraph("",
                      environment.command + " at " + environment.commit + ", " + environment.date +
                          "; " + environment.cpu + "; " + environment.compiler +
                          ". Machines are noisy: medians and ratios within one run count.",
                      "small");
    for (const std::string& peer : peers) {
        page += paragraph("", peer, "small");
    }
    page += "<ul>\n";
    for (const Exhibit& exhibit : exhibits) {
        page += link_to(exhibit);
    }
    page += "</ul>\n";
    for (const Exhibit& exhibit : exhibits) {
        page += whole_section(exhibit);
    }
    return page + "</body></html>\n";
}

}  // namespace fulcrum::bench
