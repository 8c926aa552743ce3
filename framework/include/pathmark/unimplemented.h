// PATHMARK_UNIMPLEMENTED(file, function): the marker of a function that is not written yet.
//
// It leaves a record in a section of the worker program, so that `status`, `check` and the
// preview know an unwritten function by this marker and not by the value that it returns. Take
// the line away when the function is written. Both names are literals of at most 63 characters;
// `function` is as the contract has it, "LitScene::tracePath".
#pragma once

namespace pathmark {

struct StubRecord {
  char file[64];
  char function[64];
};

}  // namespace pathmark

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the record must be placed at the point of use.
#define PATHMARK_UNIMPLEMENTED(file, function)                                               \
  do {                                                                                       \
    [[gnu::section("pathmark_stubs"),                                                        \
      gnu::used]] static const ::pathmark::StubRecord pathmarkStubRecord = {file, function}; \
  } while (false)
