// The pictures of one part's mistakes on one sheet.
#pragma once

#include "gallery/make_gallery.h"

#include <string>
#include <vector>

namespace pathmark::gallery {

// Specimens of one scene at one number of rays, behind its correct picture. A specimen's number is
// its place among those of its part, from 1 on.
struct Group {
  const CorrectView* correct = nullptr;
  std::vector<const Specimen*> specimens;
  std::vector<int> numbers;
};

// Those of the part, in the order in which scenes were given to specimens; few rays come last.
std::vector<Group> groupsOf(const Gallery& gallery, int part);

// "cornell_box, 4 rays per pixel".
std::string titleOf(const CorrectView& view);

// A PNG: for each group the correct picture first and the others behind it, their numbers below.
// It has 256 colours, so that a sheet of small pictures stays a small file.
std::string sheetPng(const std::vector<Group>& groups);

}  // namespace pathmark::gallery
