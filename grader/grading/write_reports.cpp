#include "grading/write_reports.h"

#include "film/atomic_file.h"
#include "report/class_html.h"
#include "report/class_table.h"
#include "report/gradescope.h"
#include "report/junit.h"
#include "report/marks_csv.h"
#include "report/submission_html.h"

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

}  // namespace

std::string ClassReports::table(bool colour) const {
  return report::classTable(gradedOf(records_, marks_, nullptr), colour);
}

ClassReports writeReports(const ClassFolder& folder, const rubric::Rubric& rubric) {
  std::vector<record::SubmissionRecord> records;
  std::vector<rubric::Marks> marks;
  std::vector<std::string> unreadable;
  for (const std::string& name : folder.names()) {
    auto record = folder.find(name);
    if (!record) {
      unreadable.push_back(name);
      record.emplace();
      record->name = name;
      record->seed = folder.seed();
      record->leftOut = "Its record is damaged, or of another version: grade it again.";
    }
    marks.push_back(rubric::markSubmission(*record, rubric));
    records.push_back(std::move(*record));
  }
  const std::vector<report::Graded> graded = gradedOf(records, marks, &folder);
  for (const report::Graded& g : graded) {
    const std::filesystem::path place = folder.folderOf(g.record->name);
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
