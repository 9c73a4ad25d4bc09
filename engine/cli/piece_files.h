// Many results as numbered files of one folder: DIR/piece_0001.off, piece_0002.off, ...
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/io/output_file.h"
#include "session.h"

namespace plumb::cli {

class PieceFiles {
 public:
  /// Makes the folder; without a name nothing is written. Errors: Usage, CannotWrite.
  explicit PieceFiles(std::string directory);

  bool is_wanted() const { return !directory_.empty(); }
  /// The next piece. Closed at once: a set may have more pieces than files may be open. `losses`: what the file does
  /// not say.
  void add(std::string_view extension, const std::vector<std::string>& losses,
           const std::function<void(std::ostream&)>& write);
  /// A picture of the pieces, opened now, which becomes visible with them. Errors: Usage where it has the name of a piece in
  /// one of the extensions, CannotWrite.
  void open_picture(const std::string& path, const std::vector<std::string_view>& extensions);
  /// Requires open_picture().
  void finish_picture(std::string_view bytes);
  /// How many of the files leave something out, what that with the most does, and which format would not.
  void note_losses(std::string_view better, Session& session) const;
  /// The files become visible. Those of an earlier run that made more pieces, of one of the extensions, are removed; never
  /// the input.
  void commit(const std::vector<std::string_view>& extensions, const std::string& input);

 private:
  std::string directory_;
  std::optional<OutputDirectory> made_;  // outlives the files in it
  std::vector<std::unique_ptr<OutputFile>> files_;
  std::unique_ptr<OutputFile> picture_;
  std::size_t changed_ = 0;
  std::string worst_;  // a file's name
  std::vector<std::string> worst_losses_;
};

}  // namespace plumb::cli
