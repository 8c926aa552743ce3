// pageOf: an HTML page with charts, light, dark and on paper, that loads nothing.
#pragma once

#include <string>
#include <string_view>

namespace pathmark::bench {

// `body` is HTML.
std::string pageOf(std::string_view title, std::string_view body);

}  // namespace pathmark::bench
