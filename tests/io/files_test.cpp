#include "plumb/io/text/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "plumb/predicates/error.h"

namespace plumb::files_test {
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

TEST_F(OutputFileTest, waits_for_no_reader_of_a_named_pipe) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  try {
    const OutputFile file(path("pipe"));
    ADD_FAILURE() << "opened a pipe that nobody reads";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::CannotWrite);
  }
}

TEST_F(OutputFileTest, waits_for_the_writer_of_a_named_pipe_within_limits) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  Limits limits;
  limits.max_seconds = 0.3;
  Context impatient(limits);
  EXPECT_THROW(read_input(path("pipe"), impatient), Error);
  std::thread writer([this] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    std::ofstream(path("pipe")) << std::string(100'000, 'x');
  });
  Context context;
  EXPECT_EQ(read_input(path("pipe"), context).size(), 100'000U);
  writer.join();
}

TEST_F(OutputFileTest, tells_files_below_a_folder_from_others) {
  fs::create_directories(directory_ / "in" / "deeper");
  std::ofstream(path("out")) << "x";
  std::ofstream(path("in/deeper/file")) << "x";
  fs::create_symlink(path("out"), directory_ / "in" / "link");
  fs::create_symlink(path("in/deeper"), directory_ / "in" / "folder");
  const std::string folder = path("in");
  EXPECT_TRUE(lies_below(folder, path("in/deeper/file")));
  EXPECT_TRUE(lies_below(folder, path("in/folder/file")));
  EXPECT_TRUE(lies_below(folder, path("in/deeper/../gone")));
  EXPECT_FALSE(lies_below(folder, path("out")));
  EXPECT_FALSE(lies_below(folder, path("in/link")));
  EXPECT_FALSE(lies_below(folder, path("in/../out")));
  EXPECT_FALSE(lies_below(folder, path("inside")));
  EXPECT_FALSE(lies_below(path("gone"), path("gone/file")));
}

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

TEST_F(OutputFileTest, follows_links_to_files_that_do_not_exist_yet) {
  fs::create_directory(path("folder"));
  fs::create_symlink("folder/second", path("first"));
  fs::create_symlink("../real", path("folder/second"));
  OutputFile file(path("first"));
  file.stream() << "new";
  file.finish();
  file.commit();
  EXPECT_TRUE(fs::is_symlink(path("first")));
  EXPECT_TRUE(fs::is_symlink(path("folder/second")));
  EXPECT_FALSE(fs::is_symlink(path("real")));
  EXPECT_EQ(content(path("real")), "new");
}

TEST_F(OutputFileTest, refuses_links_in_a_circle) {
  fs::create_symlink("b", path("a"));
  fs::create_symlink("a", path("b"));
  EXPECT_THROW(
      {
        OutputFile file(path("a"));
        file.finish();
        file.commit();
      },
      Error);
  EXPECT_TRUE(fs::is_symlink(path("a")));
  EXPECT_TRUE(fs::is_symlink(path("b")));
}

TEST_F(OutputFileTest, takes_the_longest_names) {
  const std::string name(255, 'n');
  OutputFile file(path(name));
  file.stream() << "new";
  file.finish();
  file.commit();
  EXPECT_EQ(content(path(name)), "new");
  EXPECT_EQ(file_count(), 1U);
  EXPECT_THROW(OutputFile(path(name + "n")), Error);
  EXPECT_EQ(file_count(), 1U);
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

// ---------------------------------------------------------------- what goes wrong on the way

/// Runs `work` in a process of its own, which ends with 0 unless something stops it; returns how it
/// ended.
template <class Work>
int status_of(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

constexpr std::size_t kLarge = 300'000;

TEST_F(OutputFileTest, leaves_the_old_file_when_killed_before_the_rename) {
  std::ofstream(path("a")) << "old";
  for (const bool is_finished : {false, true}) {
    const int status = status_of([&] {
      OutputFile file(path("a"));
      file.stream() << std::string(kLarge, 'x');
      if (is_finished) file.finish();
      std::raise(SIGKILL);
    });
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(content(path("a")), "old");
  }
}

// Whoever looks, and whenever the writer is killed, sees one of the two texts, whole.
TEST_F(OutputFileTest, is_whole_whenever_the_writer_is_killed) {
  const std::string texts[] = {std::string(kLarge, 'a'), std::string(2 * kLarge, 'b')};
  for (int killed = 0; killed < 5; ++killed) {
    std::ofstream(path("a")) << texts[0];
    const pid_t child = ::fork();
    if (child == 0) {
      for (std::size_t i = 0;; ++i) {
        OutputFile file(path("a"));
        file.stream() << texts[i % 2];
        file.finish();
        file.commit();
      }
    }
    for (int look = 0; look < 20; ++look) {
      std::this_thread::sleep_for(std::chrono::microseconds(700 + 130 * killed));
      const std::string seen = content(path("a"));
      EXPECT_TRUE(seen == texts[0] || seen == texts[1]) << seen.size() << " bytes";
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string left = content(path("a"));
    EXPECT_TRUE(left == texts[0] || left == texts[1]) << left.size() << " bytes";
  }
}

// The file system takes the first part of a write and refuses the rest.
TEST_F(OutputFileTest, says_so_when_a_file_grows_too_large) {
  std::ofstream(path("a")) << "old";
  const int status = status_of([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{kLarge / 2, kLarge / 2};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      OutputFile file(path("a"));
      file.stream() << std::string(kLarge, 'x');
      file.finish();
    } catch (const Error& error) {
      const bool is_told = error.code() == ErrorCode::CannotWrite &&
                           std::string(error.what()) == path("a") + ": File too large";
      ::_exit(is_told ? 7 : 8);
    }
  });
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(file_count(), 1U);
}

// A pipe takes what it has room for; signals cut writes short.
TEST(DescriptorStream, goes_on_after_short_and_interrupted_writes) {
  struct sigaction ignore {
  }, before{};
  ignore.sa_handler = [](int) {};  // no SA_RESTART: a write that waits ends early
  ::sigaction(SIGUSR1, &ignore, &before);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  std::string expected;
  for (std::size_t i = 0; expected.size() < 10 * kLarge; ++i) expected += std::to_string(i) + ' ';

  std::thread writer([&] {
    DescriptorStream stream(ends[1], "pipe");
    stream << expected << std::flush;
    ::close(ends[1]);
  });
  std::string got;
  std::string block(10'007, ' ');
  for (ssize_t size = 1; size > 0;) {
    if (got.size() < 5 * kLarge) {  // the writer is there: this much is more than the pipe holds
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      ::pthread_kill(writer.native_handle(), SIGUSR1);
    }
    size = ::read(ends[0], block.data(), block.size());
    if (size > 0) got.append(block, 0, static_cast<std::size_t>(size));
  }
  writer.join();
  ::close(ends[0]);
  ::sigaction(SIGUSR1, &before, nullptr);
  EXPECT_EQ(got, expected);
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

TEST_F(OutputFileTest, leaves_no_empty_directory_that_it_made) {
  const fs::path inner = directory_ / "outer" / "inner";
  { const OutputDirectory made(inner); }
  EXPECT_EQ(file_count(), 0U);
  { const OutputDirectory slash(inner / ""); }
  EXPECT_EQ(file_count(), 0U);
  {
    OutputDirectory made(inner);
    made.keep();
  }
  EXPECT_TRUE(fs::is_directory(inner));
  { const OutputDirectory was_there(inner); }
  EXPECT_TRUE(fs::is_directory(inner));
  {
    const OutputDirectory made(inner / "more" / "still");
    OutputFile file((inner / "more" / "file").string());
    file.finish();
    file.commit();
  }
  EXPECT_FALSE(fs::exists(inner / "more" / "still"));
  EXPECT_TRUE(fs::exists(inner / "more" / "file"));
  EXPECT_THROW(OutputDirectory(inner / "more" / "file"), Error);
  { const OutputDirectory around(directory_ / "new" / ".." / "." / "other"); }
  EXPECT_THROW(
      OutputDirectory(directory_ / "new" / ".." / "outer" / "inner" / "more" / "file" / "x"),
      Error);
  EXPECT_EQ(file_count(), 1U);
}

}  // namespace
}  // namespace plumb::files_test
