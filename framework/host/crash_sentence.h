// From a crash record to words: which signal, in which function, in which file and line.
//
// The addresses are looked up in the worker program, which holds whatever coursework put there: in
// a confinement, if there is one.
#pragma once

#include "host/confinement.h"

#include "worker/protocol.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace pathmark {

// "student/part5_path.cpp:31, in LitScene::tracePath", the innermost frame that lies in the
// coursework folder; empty if there is none. The functions of the coursework that led there follow,
// ", called from LitScene::renderPixel (student/part1_stratified.cpp, line 16)".
std::string crashPlace(const CrashRecord& record, const std::filesystem::path& program,
                       const std::filesystem::path& courseworkFolder,
                       Confinement* confinement = nullptr);

// The whole sentence, of a worker that may have so much memory.
std::string crashSentence(const CrashRecord& record, const std::filesystem::path& program,
                          const std::filesystem::path& courseworkFolder, std::size_t memoryBytes,
                          Confinement* confinement = nullptr);

// "a segmentation fault (SIGSEGV)".
std::string signalName(int signal);

}  // namespace pathmark
