#include "csv_file.h"

#include <cerrno>
#include <cstring>

namespace ping_pong
{
CsvFile::CsvFile() : file_(stdout), name_("standard output") {}

CsvFile::CsvFile(const std::string& path) : file_(std::fopen(path.c_str(), "w")), name_(path)
{
  if (file_ == nullptr) fail();
}

CsvFile::~CsvFile()
{
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
}

void CsvFile::fail() const
{
  throw OutputError(name_ + ": " + std::strerror(errno));
}

void CsvFile::separate()
{
  if (row_begun_) std::fputc(',', file_);
  row_begun_ = true;
}

void CsvFile::text(const char* text)
{
  separate();
  std::fputs(text, file_);
}

void CsvFile::number(double value)
{
  separate();
  std::fprintf(file_, "%.17g", value);
}

void CsvFile::integer(std::uint64_t value)
{
  separate();
  std::fprintf(file_, "%llu", static_cast<unsigned long long>(value));
}

void CsvFile::vector(const Vector3d& value)
{
  for (int axis = 0; axis < 3; ++axis) number(value[axis]);
}

void CsvFile::endRow()
{
  std::fputc('\n', file_);
  row_begun_ = false;
  if (std::ferror(file_)) fail();
}

void CsvFile::close()
{
  const bool written = std::fflush(file_) == 0 && !std::ferror(file_);
  if (!written) fail();
  std::FILE* file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail();  // some file systems tell of a full disk only here
}
}  // namespace ping_pong
