#include "bench/skip/edited_coursework.h"

#include "worker/contract.h"

#include <fstream>
#include <iterator>
#include <system_error>

namespace pathmark::bench {

namespace fs = std::filesystem;

std::unique_ptr<EditedCoursework> EditedCoursework::make(const Coursework& from, const Edit& edit) {
  std::ifstream in(from.folder / edit.file);
  std::string text(std::istreambuf_iterator<char>(in), {});
  const std::size_t at = text.find(edit.passage);
  if (at == std::string::npos) return nullptr;
  text.replace(at, edit.passage.size(), edit.replacement);

  std::unique_ptr<EditedCoursework> result(new EditedCoursework);
  std::string name = (fs::temp_directory_path() / "pathmark-bench.XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw std::system_error(errno, std::generic_category(), "making a folder");
  result->folder_ = name;
  for (const PartContract& part : parts())
    fs::copy_file(from.folder / part.file, result->folder_ / part.file);
  std::ofstream(result->folder_ / edit.file, std::ios::trunc) << text;
  result->coursework_ = prepareCoursework(result->folder_.string());
  return result;
}

EditedCoursework::~EditedCoursework() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

}  // namespace pathmark::bench
