#include "rubric/mark_part.h"

#include "diagnosis/diagnosis.h"
#include "rubric/consequence.h"
#include "rubric/lost_file.h"
#include "rubric/verdict_credit.h"
#include "worker/contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pathmark::rubric {

namespace {

using record::CheckRecord;
using record::FunctionRecord;
using record::Verdict;

struct PartMarker {
  const record::SubmissionRecord& record;
  const record::PartRecord& part;
  const PartRubric& worth;
  const Rubric& rubric;
  std::vector<std::string>& toReview;
  std::optional<Consequence> consequence = worstPicture(part.pictures, rubric);

  MarkLine markFunction(const FunctionContract& contract, double outOf) const;
  MarkLine markEfficiency(const std::vector<MarkLine>& functions) const;
  void markWrong(const FunctionRecord& function, MarkLine& line) const;
  void byConsequence(const std::string& what, double unseen, MarkLine& line) const;
  void markBlocked(const FunctionRecord& function, MarkLine& line) const;
  bool onlyPricesAreLost() const;
  std::string whyThereIsNoFile() const;
  double pricesOf(const FunctionRecord& function) const;
  bool allHavePrices(const FunctionRecord& function) const;
};

// Of these no points are lost.
bool isRightOrSpared(Verdict verdict) {
  return verdict == Verdict::kOk || verdict == Verdict::kUndecided ||
         verdict == Verdict::kInternalError;
}

std::string pointsInWords(double points) {
  return fmt::format("{:.3g} point{}", points, points == 1.0 ? "" : "s");
}

bool isWrong(const CheckRecord& check) { return check.verdict == Verdict::kWrong; }

std::string idsOfWrong(const FunctionRecord& function) {
  std::vector<std::string> ids;
  for (const CheckRecord& check : function.checks)
    if (isWrong(check)) ids.push_back(check.id);
  return ids.empty() ? "it is wrong" : fmt::format("wrong in {}", fmt::join(ids, ", "));
}

std::string blockerOf(const FunctionRecord& function) {
  for (const CheckRecord& check : function.checks)
    if (check.verdict == Verdict::kBlocked && !check.cause.empty()) return check.cause;
  return "what it relies on must be right first";
}

// What the part says where it has no record of the function.
FunctionRecord recordOf(const record::PartRecord& part, const FunctionContract& contract) {
  for (const FunctionRecord& function : part.functions)
    if (function.section == contract.section) return function;
  FunctionRecord function;
  function.section = contract.section;
  function.name = contract.name;
  // A part that was found right without its functions having been looked at is the grader's fault.
  const bool says = part.verdict != Verdict::kOk && part.verdict != Verdict::kUndecided;
  function.verdict = says ? part.verdict : Verdict::kInternalError;
  return function;
}

// What the wrong checks cost that have a price.
double PartMarker::pricesOf(const FunctionRecord& function) const {
  double sum = 0.0;
  for (const CheckRecord& check : function.checks)
    if (isWrong(check) && worth.checks.contains(check.id)) sum += worth.checks.at(check.id);
  return sum;
}

bool PartMarker::allHavePrices(const FunctionRecord& function) const {
  bool anyWrong = false;
  for (const CheckRecord& check : function.checks) {
    if (isWrong(check) && !worth.checks.contains(check.id)) return false;
    anyWrong = anyWrong || isWrong(check);
  }
  return anyWrong;
}

// Whether all that is wrong in the part has a price, which says what it costs.
bool PartMarker::onlyPricesAreLost() const {
  bool any = false;
  for (const FunctionRecord& function : part.functions) {
    if (function.verdict == Verdict::kBlocked || isRightOrSpared(function.verdict)) continue;
    if (function.verdict != Verdict::kWrong || !allHavePrices(function)) return false;
    any = true;
  }
  return any;
}

void PartMarker::markWrong(const FunctionRecord& function, MarkLine& line) const {
  const double left = std::max(line.outOf - pricesOf(function), 0.0);
  if (allHavePrices(function)) {
    line.points = left;
    line.reason = sentence(
        fmt::format("{}, which costs {}", idsOfWrong(function), pointsInWords(line.outOf - left)));
    return;
  }
  byConsequence(idsOfWrong(function), rubric.withoutPicture, line);
  if (line.points <= left) return;
  line.points = left;
  line.reason +=
      fmt::format(" But what has a price of its own costs {}.", pointsInWords(line.outOf - left));
}

void PartMarker::markBlocked(const FunctionRecord& function, MarkLine& line) const {
  if (onlyPricesAreLost())
    line.points = line.outOf;
  else
    byConsequence(fmt::format("it could not be checked: {}", blockerOf(function)), 0.0, line);
}

void PartMarker::byConsequence(const std::string& what, double unseen, MarkLine& line) const {
  const double earned = consequence ? consequence->credit : unseen,
               credit = std::min(earned, rubric.wrongAtMost);
  line.points = credit * line.outOf;
  line.reason =
      fmt::format("{} {} That earns {} of the points{}.", sentence(what),
                  sentence(consequence ? consequence->words : "no picture shows what that does"),
                  percent(credit),
                  credit < earned ? ", the most that what is not known to be right can earn" : "");
}

std::string PartMarker::whyThereIsNoFile() const {
  const std::string became = whatBecameOf(record, part.part);
  return became.empty()
             ? fmt::format("There is no {} in the submission.", partNumbered(part.part).file)
             : became;
}

MarkLine PartMarker::markFunction(const FunctionContract& contract, double outOf) const {
  const FunctionRecord function = recordOf(part, contract);
  MarkLine line{fmt::format("{} {}", contract.section, contract.name), 0.0, outOf, {}};
  reviewVerdict(function.verdict, line.what, toReview);
  if (function.mistake == diagnosis::kStub) {
    line.reason = sentence(creditOf(Verdict::kNotWritten, rubric)->reason +
                           ": it answers as the empty stub does, whatever it is asked");
  } else if (const std::optional<VerdictCredit> known = creditOf(function.verdict, rubric)) {
    line.points = known->credit * outOf;
    line.reason = part.hasFile() ? sentence(known->reason) : whyThereIsNoFile();
  } else if (function.verdict == Verdict::kBlocked) {
    markBlocked(function, line);
  } else {
    markWrong(function, line);
  }
  if (line.points == line.outOf) line.reason = {};
  return line;
}

std::string whyThereIsNoPicture(const record::PartRecord& part) {
  for (const record::PictureRecord& picture : part.pictures)
    if (!picture.failure.empty())
      return fmt::format(" (no picture of {}: {})", picture.scene, picture.failure);
  return {};
}

// An estimator of something else may well be less noisy: efficiency counts as far as the part is
// right.
MarkLine PartMarker::markEfficiency(const std::vector<MarkLine>& functions) const {
  MarkLine line{kEfficiencyLine, 0.0, worth.efficiency, {}};
  double points = 0.0, outOf = 0.0;
  for (const MarkLine& function : functions) points += function.points, outOf += function.outOf;
  const double right = points == outOf ? 1.0 : points / outOf;
  const std::optional<Economy> economy = worstEfficiency(part.pictures, rubric);
  if (!economy && right > 0.0)
    toReview.push_back(
        fmt::format("Part {}: its efficiency was not measured{}, which costs no points.", part.part,
                    whyThereIsNoPicture(part)));
  line.points = right * (economy ? economy->credit : 1.0) * line.outOf;
  if (line.points == line.outOf) return line;
  if (economy) line.reason = sentence(economy->words);
  if (right < 1.0) {
    if (!line.reason.empty()) line.reason += ' ';
    line.reason += fmt::format("Efficiency counts as far as the functions are right, which is {}.",
                               percent(right));
  }
  return line;
}

// What something else takes says nothing: only of a picture that is right is it hard to believe.
void reviewEfficiency(const record::PartRecord& part, const Rubric& rubric,
                      std::vector<std::string>& toReview) {
  for (const record::PictureRecord& picture : part.pictures)
    if (picture.efficiency && picture.efficiency->low > rubric.reviewAbove &&
        isRight(picture, rubric))
      toReview.push_back(fmt::format(
          "Part {}: in {} it is {:.2g} ({:.2g} to {:.2g}) times as efficient as the solutions, "
          "which is hard to believe; where does it have its values from?",
          part.part, picture.scene, picture.efficiency->value, picture.efficiency->low,
          picture.efficiency->high));
}

// Whether all parts were looked at, so that what is not there was not handed in.
bool isComplete(const record::SubmissionRecord& record) {
  if (!record.hasMarks()) return false;
  return std::all_of(parts().begin(), parts().end(), [&](const PartContract& part) {
    return part.bonus || std::any_of(record.parts.begin(), record.parts.end(),
                                     [&](const auto& seen) { return seen.part == part.part; });
  });
}

}  // namespace

std::vector<MarkLine> markPart(const record::SubmissionRecord& record,
                               const record::PartRecord& part, const PartRubric& worth,
                               const Rubric& rubric, std::vector<std::string>& toReview) {
  const PartMarker marker{record, part, worth, rubric, toReview};
  std::vector<std::pair<const FunctionContract*, double>> functions;
  double sum = 0.0;
  for (const FunctionContract& function : contract()) {
    if (function.part != worth.part) continue;
    const auto weight = worth.weights.find(std::string(function.section));
    functions.emplace_back(&function, weight == worth.weights.end() ? 1.0 : weight->second);
    sum += functions.back().second;
  }
  // Where efficiency has all the points, the functions still say how far it counts.
  const double left = worth.points - worth.efficiency, share = left > 0.0 ? left : worth.points;
  std::vector<MarkLine> lines;
  lines.reserve(functions.size() + 1);
  for (const auto& [function, weight] : functions)
    lines.push_back(marker.markFunction(*function, share * weight / sum));
  if (worth.efficiency > 0.0) {
    MarkLine efficiency = marker.markEfficiency(lines);
    if (left == 0.0)
      for (MarkLine& line : lines) line.points = line.outOf = 0.0;
    lines.push_back(std::move(efficiency));
  }
  reviewEfficiency(part, rubric, toReview);
  return lines;
}

namespace {

std::string whyThereIsNoScene(const record::SubmissionRecord& record) {
  if (!record.refusedScenes.empty()) return record.refusedScenes.front();
  return record.outOfTime ? "There is no scene in scenes/, or the time for the whole submission "
                            "was up before it was looked at."
                          : "There is no scene in scenes/.";
}

}  // namespace

std::vector<MarkLine> markScenes(const record::SubmissionRecord& record, const PartRubric& worth,
                                 const Rubric& rubric, std::vector<std::string>& toReview) {
  if (record.scenes.empty() && !isComplete(record)) return {};
  if (record.scenes.empty() && !record.refusedScenes.empty())
    toReview.push_back(fmt::format("Part {} counts as not written, but something was handed in: {}",
                                   kScenesPart, record.refusedScenes.front()));
  MarkLine best{"a scene", -1.0, worth.points, whyThereIsNoScene(record)};
  for (const record::SceneRecord& scene : record.scenes) {
    // A scene of which only the rendering was blocked is as good as it can be without the parts.
    const bool blocked = scene.verdict == Verdict::kBlocked;
    const VerdictCredit credit = creditOf(blocked ? Verdict::kOk : scene.verdict, rubric)
                                     .value_or(VerdictCredit{0.0, "it cannot be rendered"});
    reviewVerdict(scene.verdict, scene.file, toReview);
    MarkLine line{scene.file, credit.credit * worth.points, worth.points, {}};
    if (credit.credit < 1.0)
      line.reason = fmt::format("{}: {}", scene.file,
                                sentence(scene.message.empty() ? credit.reason : scene.message));
    else if (blocked)
      line.reason =
          fmt::format("{} was not rendered, blocked by {}; as far as it was read it is right.",
                      scene.file, scene.message);
    if (line.points > best.points) best = line;
  }
  best.points = std::max(best.points, 0.0);
  return {best};
}

std::vector<MarkLine> markWhole(const record::SubmissionRecord& record, const PartRubric& worth,
                                const Rubric& rubric, std::vector<std::string>& toReview) {
  if (record.pictures.empty() && record.images.empty() && !isComplete(record)) return {};
  MarkLine line{"pictures of all parts together", 0.0, worth.points, {}};
  const std::optional<Consequence> seen = worstPicture(record.pictures, rubric);
  Consequence worst =
      seen.value_or(Consequence{record.images.empty() ? 0.0 : 1.0, "there are no pictures"});
  const auto lower = [&](double credit, const std::string& words) {
    if (credit < worst.credit) worst = {credit, words};
  };
  for (const CheckRecord& check : record.images) {
    reviewVerdict(check.verdict, check.id, toReview);
    const std::optional<VerdictCredit> known = creditOf(check.verdict, rubric);
    if (known) {
      lower(known->credit, known->reason);
    } else if (seen && check.verdict == Verdict::kBlocked) {
      continue;  // it says nothing that the picture does not show
    } else if (seen) {
      lower(rubric.wrongAtMost, fmt::format("{}; wrong in {}", seen->words, check.id));
    } else if (check.verdict == Verdict::kBlocked) {
      lower(0.0, check.cause);
    } else {
      lower(std::min(rubric.withoutPicture, rubric.wrongAtMost),
            fmt::format("wrong in {}", check.id));
    }
  }
  const bool failed = std::any_of(record.images.begin(), record.images.end(), [](const auto& c) {
    return c.verdict == Verdict::kInternalError;
  });
  line.points = failed ? line.outOf : worst.credit * line.outOf;
  if (line.points < line.outOf)
    line.reason = fmt::format("{} That earns {} of the points.", sentence(worst.words),
                              percent(worst.credit));
  return {line};
}

}  // namespace pathmark::rubric
