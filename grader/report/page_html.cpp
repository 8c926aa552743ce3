#include "report/page_html.h"

#include "pictures_css.h"
#include "report/base64.h"
#include "report_css.h"

namespace pathmark::report {

namespace {

using record::Verdict;

std::string bytesOfHex(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
  return bytes;
}

std::string source(std::string_view sha256) {
  return fmt::format("'sha256-{}'", base64(bytesOfHex(sha256)));
}

// A sign for each kind, for those who see no colours.
std::string_view signOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return "\u2713";  // check mark
    case Verdict::kUndecided:
      return "?";
    case Verdict::kBlocked:
      return "\u2013";  // dash
    case Verdict::kNotWritten:
      return "\u25CB";  // circle
    case Verdict::kInternalError:
      return "!";
    default:
      return "\u2717";  // ballot x
  }
}

}  // namespace

std::string page(std::string_view title, const Markup& body, const Script& script) {
  // Styles and scripts are our own, and must be the very bytes that were hashed.
  return markup(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<meta name=\"color-scheme\" content=\"light dark\">\n"
             "<meta name=\"referrer\" content=\"no-referrer\">\n"
             "<title>{}</title>\n<style>{}</style>\n<style>{}</style>\n</"
             "head>\n<body>\n{}\n<script>{}</script>\n"
             "</body>\n</html>\n",
             Markup{
                 fmt::format("default-src 'none'; img-src data:; style-src {} {}; script-src {}; "
                             "base-uri 'none'; form-action 'none'",
                             source(assets::kReportCssSha256), source(assets::kPicturesCssSha256),
                             source(script.sha256))},
             title, Markup{std::string(assets::kReportCss)},
             Markup{std::string(assets::kPicturesCss)}, body, Markup{std::string(script.text)})
      .html;
}

std::string_view kindOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return "good";
    case Verdict::kUndecided:
      return "doubt";
    case Verdict::kBlocked:
    case Verdict::kNotWritten:
      return "none";
    default:
      return "bad";
  }
}

Markup verdictChip(Verdict verdict) {
  return markup("<span class=\"verdict {}\"><span aria-hidden=\"true\">{}</span> {}</span>",
                kindOf(verdict), signOf(verdict), nameOf(verdict));
}

Markup pngImage(std::string_view png, std::string_view alt) {
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  if (!png.starts_with(kSignature)) return {};
  return markup("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", alt, base64(png));
}

Markup term(std::string_view name, std::string_view text) {
  if (text.empty()) return {};
  return markup("<div><dt>{}</dt><dd>{}</dd></div>\n", name, text);
}

}  // namespace pathmark::report
