#include "plumb/io/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "plumb/base/error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "plumb-test-XXXXXX").string();
    directory_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }
  static std::string content(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path directory_;
};

TEST_F(OutputFileTest, appears_whole_on_commit) {
  OutputFile file(path("a"));
  file.stream() << "hello " << std::string(200'000, 'x');
  file.finish();
  EXPECT_FALSE(fs::exists(path("a")));
  file.commit();
  EXPECT_EQ(content(path("a")).size(), 200'006U);
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(OutputFileTest, leaves_nothing_without_commit) {
  std::ofstream(path("a")) << "old";
  { OutputFile(path("a")).stream() << "new"; }
  { OutputFile(path("b")).stream() << "new"; }
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(OutputFileTest, has_the_permissions_of_an_ordinary_file) {
  const mode_t before = ::umask(027);
  OutputFile file(path("a"));
  ::umask(before);
  file.finish();
  file.commit();
  EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms(0640));
}

TEST_F(OutputFileTest, follows_links) {
  std::ofstream(path("real")) << "old";
  fs::create_symlink("real", path("link"));
  OutputFile file(path("link"));
  file.stream() << "new";
  file.finish();
  file.commit();
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(content(path("real")), "new");
}

TEST_F(OutputFileTest, writes_devices_directly) {
  OutputFile file("/dev/null");
  file.stream() << "gone";
  file.finish();
  file.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(OutputFileTest, names_the_path_and_the_reason) {
  const auto message = [](const std::string& path) -> std::string {
    try {
      OutputFile file(path);
      file.stream() << std::string(300'000, 'x');
      file.finish();
      return "none";
    } catch (const Error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(message("/dev/full"), "/dev/full: No space left on device");
  EXPECT_EQ(message(path("no/file")), path("no/file") + ": No such file or directory");
  EXPECT_EQ(message(path("")), path("") + ": Is a directory");
  EXPECT_EQ(file_count(), 0U);
}

TEST_F(OutputFileTest, commits_all_or_none) {
  std::vector<std::unique_ptr<OutputFile>> files;
  files.push_back(std::make_unique<OutputFile>(path("a")));
  files.push_back(std::make_unique<OutputFile>(path("b")));
  for (const auto& file : files) file->finish();
  fs::create_directory(path("b"));  // in the way of the second
  EXPECT_THROW(commit_all(files), Error);
  files.clear();
  EXPECT_FALSE(fs::exists(path("a")));
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(OutputFileTest, lets_a_signal_handler_remove_temporary_files) {
  OutputFile file(path("a"));
  EXPECT_EQ(file_count(), 1U);
  remove_temporary_files();
  EXPECT_EQ(file_count(), 0U);
}

TEST(DescriptorStream, tells_a_closed_pipe_from_a_full_disk) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  DescriptorStream stream(ends[1], "pipe");
  try {
    stream << "x" << std::flush;
    ADD_FAILURE() << "was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ClosedPipe);
  }
  std::signal(SIGPIPE, before);
  ::close(ends[1]);
}

}  // namespace
}  // namespace plumb
