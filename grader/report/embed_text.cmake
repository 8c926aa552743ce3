# Turns a file into a header with its text and the SHA-256 of its bytes:
#   cmake -DIN=report.css -DOUT=report_css.h -DNAME=ReportCss -P embed_text.cmake
cmake_minimum_required(VERSION 3.22)
file(READ ${IN} text)
file(SIZE ${IN} bytes)
file(SHA256 ${IN} hash)
get_filename_component(file_name ${IN} NAME)
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT "// Made from @file_name@.
#pragma once

#include <string_view>

namespace pathmark::report::assets {

inline constexpr std::string_view k@NAME@ = R\"pathmark(@text@)pathmark\";
inline constexpr std::string_view k@NAME@Sha256 = \"@hash@\";
static_assert(k@NAME@.size() == @bytes@, \"the hash would not be that of the text\");

}  // namespace pathmark::report::assets
")
