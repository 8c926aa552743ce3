#include "grading/write_reports.h"

#include "film/atomic_file.h"
#include "report/class_html.h"
#include "report/class_table.h"
#include "report/gradescope.h"
#include "report/junit.h"
#include "report/marks_csv.h"
#include "report/submission_html.h"
#include "submission/names.h"

#include <algorithm>

namespace pathmark::grading {

namespace {

std::vector<report::Graded> gradedOf(const std::vector<record::SubmissionRecord>& records,
                                     const std::vector<rubric::Marks>& marks,
                                     const ClassFolder* folder) {
  std::vector<report::Graded> graded;
  for (std::size_t k = 0; k < records.size(); ++k) {
    const std::string& name = records[k].name;
    report::PictureSource pictures;
    if (folder != nullptr)
      pictures = [folder, name](const std::string& file) { return folder->picture(name, file); };
    graded.push_back({&records[k], &marks[k], "submissions/" + name, pictures});
  }
  return graded;
}

record::SubmissionRecord withoutMarks(const std::string& name, std::uint64_t seed,
                                      const char* reason) {
  record::SubmissionRecord record;
  record.name = name;
  record.seed = seed;
  record.leftOut = reason;
  return record;
}

}  // namespace

std::string ClassReports::table(bool colour) const {
  return report::classTable(gradedOf(records_, marks_, nullptr), colour);
}

bool ClassReports::anyFailed() const {
  return !unreadable_.empty() ||
         std::any_of(records_.begin(), records_.end(),
                     [](const record::SubmissionRecord& record) { return record.internalError(); });
}

ClassReports writeReports(const ClassFolder& folder, const rubric::Rubric& rubric,
                          const std::vector<std::string>& notYet) {
  std::vector<record::SubmissionRecord> records;
  std::vector<rubric::Marks> marks;
  std::vector<std::string> unreadable;
  for (const std::string& name : folder.names()) {
    auto record = folder.find(name);
    if (!record) {
      unreadable.push_back(name);
      record = withoutMarks(name, folder.seed(),
                            "Its record is damaged, or of another version: grade it again.");
    }
    records.push_back(std::move(*record));
  }
  for (const std::string& name : notYet)
    records.push_back(
        withoutMarks(name, folder.seed(),
                     "The run was interrupted before it; grading the class again goes on."));
  std::sort(records.begin(), records.end(),
            [](const auto& a, const auto& b) { return submission::naturalLess(a.name, b.name); });
  for (const record::SubmissionRecord& record : records)
    marks.push_back(rubric::markSubmission(record, rubric));
  const std::vector<report::Graded> graded = gradedOf(records, marks, &folder);
  for (const report::Graded& g : graded) {
    const std::filesystem::path place = folder.folderOf(g.record->name);
    std::filesystem::create_directories(place);
    writeFileAtomically(place / "report.html",
                        report::submissionHtml(*g.record, *g.marks, g.pictures));
    writeFileAtomically(place / "results.json", report::gradescopeJson(*g.record, *g.marks));
    writeFileAtomically(place / "junit.xml", report::junitXml(*g.record));
  }
  writeFileAtomically(folder.path() / "marks.csv", report::marksCsv(graded));
  writeFileAtomically(folder.path() / "junit.xml", report::junitXml(graded));
  writeFileAtomically(folder.path() / "report.html", report::classHtml(graded));
  return {std::move(records), std::move(marks), std::move(unreadable)};
}

}  // namespace pathmark::grading
