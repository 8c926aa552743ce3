// HTML in which nothing is forgotten to be escaped.
//
//   Markup      a piece of HTML or SVG; the only thing that is not escaped again
//   markup      a piece from a pattern: markup("<td class=\"{}\">{}</td>", class, text)
//   escaped     text for HTML and XML, for content and for attributes in quotes
//   escapedUrl  a relative path, for an attribute
//
// Everything that goes into a pattern is escaped unless it is Markup; patterns themselves are
// literals, which the compiler checks.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace pathmark::report {

struct Markup {
  std::string html;

  Markup& operator+=(const Markup& other) {
    html += other.html;
    return *this;
  }
};

// Clean, with &, <, > and both quotes as entities.
std::string escaped(std::string_view text);

// Percent-encoded but for unreserved characters (RFC 3986, section 2.3) and slashes. A first
// segment with a colon would be a scheme: "./" comes before everything.
std::string escapedUrl(std::string_view path);

namespace detail {

// Numbers keep their format specifications, such as {:.1f}.
template <typename T>
using Shown = std::conditional_t<std::is_arithmetic_v<T>, T, std::string>;

inline std::string shown(const Markup& piece) { return piece.html; }
inline std::string shown(std::string_view text) { return escaped(text); }
template <typename T>
requires std::is_arithmetic_v<T> T shown(T number) { return number; }

}  // namespace detail

template <typename... Args>
Markup markup(fmt::format_string<detail::Shown<std::remove_cvref_t<Args>>...> pattern,
              const Args&... args) {
  return {fmt::format(pattern, detail::Shown<std::remove_cvref_t<Args>>(detail::shown(args))...)};
}

}  // namespace pathmark::report
