// Records as JSON, as they are kept.
//
//   toJson            all of a record; the same record gives the same bytes
//   recordFromJson    back from it
//   writeRecord, readRecord   the same with files
#pragma once

#include "record/record.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace pathmark::record {

// A sentence about a file that is no record, or one of another format.
class RecordError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string toJson(const SubmissionRecord& record);

// `file` is for messages. Throws RecordError.
SubmissionRecord recordFromJson(const std::string& text, const std::filesystem::path& file);

// Replaces the file in one step. Throws ImageError.
void writeRecord(const SubmissionRecord& record, const std::filesystem::path& file);

// Throws RecordError.
SubmissionRecord readRecord(const std::filesystem::path& file);

}  // namespace pathmark::record
