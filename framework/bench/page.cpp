#include "bench/page.h"

#include "bench/log_chart.h"

#include <fmt/format.h>

namespace pathmark::bench {

namespace {

constexpr std::string_view kStyle = R"(
:root { --page: #f4f5f7; --paper: #fff; --ink: #1a1f25; --soft: #56616c; --edge: #d6dbe1; }
@media screen and (prefers-color-scheme: dark) {
  :root { --page: #121518; --paper: #1b1f24; --ink: #e7eaed; --soft: #a0abb6; --edge: #373e46; }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 1rem/1.5 system-ui, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif; }
main { max-width: 68rem; margin: 0 auto; padding: 1.5rem 1rem 3rem; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: 0 0 .6rem; }
h2 { font-size: 1.3rem; margin: 0 0 .5rem; }
section { background: var(--paper); border: 1px solid var(--edge); border-radius: 10px;
  padding: 1.1rem 1.2rem; margin: 1.2rem 0; }
figure { margin: 0; }
figure svg { display: block; width: 100%; max-width: 60rem; height: auto; }
.soft { color: var(--soft); font-size: .88rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: .88rem; }
th, td { text-align: left; font-weight: 400; padding: .25rem .8rem .25rem 0; white-space: nowrap;
  border-bottom: 1px solid var(--edge); }
thead th { color: var(--soft); white-space: normal; vertical-align: bottom; }
.n { text-align: right; font-variant-numeric: tabular-nums; }
@media print {
  :root { --page: #fff; --paper: #fff; }
  @page { margin: 14mm; }
  body { font-size: 9.5pt; }
  main { max-width: none; padding: 0; }
  section { border: 0; border-radius: 0; padding: 0; }
  .scroll { overflow: visible; }
  table { font-size: 7.5pt; }
  th, td { padding-right: .4rem; }
  figure, tr { break-inside: avoid; }
  h2, figure { break-after: avoid; }
  svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

}  // namespace

std::string pageOf(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'\">\n<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n<main>\n{}"
      "</main>\n</body>\n</html>\n",
      escaped(title), kStyle, chartStyle(), body);
}

}  // namespace pathmark::bench
