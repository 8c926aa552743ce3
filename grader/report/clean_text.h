// Text that comes from outside, made fit to be shown: coursework, compilers and file names may hold
// any bytes.
//
//   cleanText     lines of text
//   cleanLine     one line
//   cutAfter      not more than so many bytes of it
//   columnsOf     how wide a terminal shows it
//   cutInMiddle   not wider than so many columns
//
// What is clean is UTF-8 that XML 1.0 allows (section 2.2), without anything that moves a cursor or
// turns the direction of writing round. Bytes that are no UTF-8 become U+FFFD; control characters
// become their pictures (U+2400 to U+2421), so that it can be seen that they were there.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pathmark::report {

// Keeps newlines and tabs; \r\n is a newline.
std::string cleanText(std::string_view bytes);

// Newlines and tabs become spaces.
std::string cleanLine(std::string_view bytes);

// Of clean text: the beginning, and how much is missing, if it is longer.
std::string cutAfter(std::string_view clean, std::size_t bytes);

std::size_t columnsOf(std::string_view clean);

// "anna_lena...winter.zip": both ends tell more than one.
std::string cutInMiddle(std::string_view clean, std::size_t columns);

}  // namespace pathmark::report
