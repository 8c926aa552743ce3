#include "sample_class/pack.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct Free {
  void operator()(archive* a) const { archive_write_free(a); }
  void operator()(archive_entry* e) const { archive_entry_free(e); }
};

class Writer {
 public:
  Writer(const fs::path& file, bool asZip) : file_(file), archive_(archive_write_new()) {
    if (asZip) {
      require(archive_write_set_format_zip(archive_.get()));
    } else {
      require(archive_write_set_format_pax_restricted(archive_.get()));
      require(archive_write_add_filter_gzip(archive_.get()));
    }
    require(archive_write_open_filename(archive_.get(), file.c_str()));
  }

  void add(const std::string& name, const std::string& bytes) {
    const std::unique_ptr<archive_entry, Free> entry(archive_entry_new());
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    require(archive_write_header(archive_.get(), entry.get()));
    if (archive_write_data(archive_.get(), bytes.data(), bytes.size()) !=
        static_cast<la_ssize_t>(bytes.size()))
      require(ARCHIVE_FATAL);
  }

  void close() { require(archive_write_close(archive_.get())); }

 private:
  void require(int result) const {
    if (result >= ARCHIVE_WARN) return;
    const char* why = archive_error_string(archive_.get());
    throw std::runtime_error(fmt::format("{}: cannot be written ({}).", file_.string(),
                                         why != nullptr ? why : "no details are known"));
  }

  fs::path file_;
  std::unique_ptr<archive, Free> archive_;
};

}  // namespace

void packFolder(const fs::path& folder, const fs::path& archive, bool asZip) {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(entry.path());
  Writer writer(archive, asZip);
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    writer.add((folder.filename() / file.lexically_relative(folder)).string(),
               std::string(std::istreambuf_iterator<char>(in), {}));
  }
  writer.close();
}

}  // namespace pathmark
