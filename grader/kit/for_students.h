// forStudents: a chapter as it stands in a kit, without what it tells instructors alone, such as
// commands that need the solutions.
//
//   Instructors: `./pathmark ...`    a paragraph that begins so is left out
//   ... text (instructors: ...).     so is a remark like this, wherever it stands in a paragraph
#pragma once

#include <string>
#include <string_view>

namespace pathmark::kit {

std::string forStudents(std::string_view markdown);

}  // namespace pathmark::kit
