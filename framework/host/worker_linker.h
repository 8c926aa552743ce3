// Linking workers from objects.
//
//   LinkInputs     what a worker is made of
//   linkedFolder   where a worker that is made of these has its place
//   linkInto       links it there, unless it is there already
#pragma once

#include "host/coursework_builder.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark {

enum class Linking {
  kStrict,
  kLenient,    // functions that are nowhere defined get the address zero
  kRecording,  // calls of some functions are led to those that record them
};

struct LinkInputs {
  std::vector<std::string> framework;  // objects
  // Objects too; those of parts that do not compile are empty.
  std::vector<std::filesystem::path> coursework;
  Linking linking = Linking::kStrict;
  std::shared_ptr<Confinement> confinement;
};

// With the objects that every worker has.
LinkInputs linkInputs(const std::shared_ptr<Confinement>& confinement,
                      Linking linking = Linking::kStrict);

void addObject(LinkInputs& inputs, const PartBuild& part);

// `kind` keeps apart workers that are linked differently from the same.
std::filesystem::path linkedFolder(const LinkInputs& from, std::string_view kind = {});

// Returns the linker's words, if it fails.
std::string linkInto(const std::filesystem::path& folder, const LinkInputs& inputs);

}  // namespace pathmark
