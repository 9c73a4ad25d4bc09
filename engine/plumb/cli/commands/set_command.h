// What `plumb plane ...` and `plumb solid ...` have in common: the commands on sets, as templates
// over the kind of sets (concept SetKind).
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/restarted_jobs.h"
#include "plumb/base/marks.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/text/files.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

/// The options of a command that reads sets. load() returns a set with the notes of its file;
/// several threads may call it at once.
template <class Input>
concept SetInput = std::default_initializable<Input> &&
    requires(Input options, const Input& input, CLI::App& app, const std::string& file,
             const CommonOptions& common, Context& context) {
  options.declare(app);
  input.load(file, common, context).set;
  input.load(file, common, context).notes;
};

/// A kind of sets: Nef2 or Nef3, and the facts about it that the commands need. A kind whose files
/// show how a set was made has, besides, `canonical(set, context)`: the same set in a form that
/// does not (--canonical). If files of a kind may contain shapes of doubles, the kind also has
/// `kHasGrid` (--raw, --grid). If they may be meshes, it also has `kWritesMeshes` (--triangles). If
/// files of a kind may contain features, the kind also has `Features`, which collects the features
/// of all operands: `add(read)` is called for each operand in order, and `ready(set, features,
/// output, session)` makes the file.
template <class Kind>
concept SetKind = SetInput<typename Kind::Input> &&
    requires(const typename Kind::Set& set, const SetOutput& output, Context& context,
             const std::array<Rational, Kind::kAxes.size()>& point) {
  // The first operand in the help, and the names of the coordinates.
  { Kind::kHelp } -> std::convertible_to<const char*>;
  { Kind::kAxes[0] } -> std::convertible_to<const char*>;
  // The table of formats that can be written (outputs.h).
  Kind::formats();
  // The stages of progress (progress.h): a file is read; an operation; facts(); locate(); ready()
  // with the file written.
  { Kind::reading() } -> std::same_as<ProgressStage>;
  { Kind::combining() } -> std::same_as<ProgressStage>;
  { Kind::measuring() } -> std::same_as<ProgressStage>;
  { Kind::locating() } -> std::same_as<ProgressStage>;
  { Kind::writing(output) } -> std::same_as<ProgressStages>;
  // Whether the output's format holds marks, and not just the closure of a set.
  { Kind::keeps_marks(output) } -> std::same_as<bool>;
  // The set as a file of the output's format.
  { Kind::ready(set, output, context) } -> std::same_as<ReadyFile>;
  // What is known of the set.
  Kind::facts(set, context).json();
  // What the point lies on, and whether it belongs to the set.
  { Kind::locate(set, point) } -> std::same_as<std::pair<const char*, bool>>;
};

inline void require_one_stdin(const std::vector<std::string>& files) {
  if (std::count(files.begin(), files.end(), "-") > 1) {
    throw Error(ErrorCode::Usage, "only one of the sets can come from standard input");
  }
}

/// Returns the sets of some files, read in parallel if there are threads for that. Notes and
/// warnings come in the order of the files. `visit` is called for the contents of each file, in
/// this order.
template <SetInput Input, class Visit>
auto read_sets(const Input& input, const std::vector<std::string>& files, Session& session,
               const Visit& visit) {
  using Read = decltype(input.load(files[0], session.options(), session.context()));
  std::vector<Read> reads(files.size());
  const auto read = [&](std::size_t i, Context& own) {
    const bool is_alone = &own == &session.context();
    if (is_alone || i == 0) session.begin("read");  // All files read in parallel are one stage.
    reads[i] = input.load(files[i], session.options(), own);
  };
  // Standard input can be read only once.
  const bool has_stdin = std::find(files.begin(), files.end(), "-") != files.end();
  (has_stdin ? run_jobs : run_restarted_jobs)(session.context(), files.size(), read);
  std::vector<decltype(Read::set)> sets;
  for (std::size_t i = 0; i < files.size(); ++i) {
    print_notes(files[i], reads[i], session);
    visit(reads[i]);
    sets.push_back(std::move(reads[i].set));
  }
  return sets;
}

/// Returns the sets of some files.
template <SetInput Input>
auto read_sets(const Input& input, const std::vector<std::string>& files, Session& session) {
  return read_sets(input, files, session, [](const auto&) {});
}

/// The features of operands of a kind without features.
struct NoFeatures {
  template <class Read>
  void add(const Read&) {}
};
template <class Kind>
struct FeaturesOfKind {
  using Type = NoFeatures;
};
template <class Kind>
requires requires { typename Kind::Features; }
struct FeaturesOfKind<Kind> {
  using Type = typename Kind::Features;
};

/// Returns the stages of some sets read and combined.
template <SetKind Kind>
ProgressStages stages_of_sets(std::size_t operands, std::size_t operations) {
  ProgressStages stages(operands, Kind::reading());
  stages.insert(stages.end(), operations, Kind::combining());
  return stages;
}

template <SetKind Kind>
void declare_first(CLI::App& app, std::string& a) {
  app.add_option("A", a, Kind::kHelp)->required()->type_name("");
}

inline void declare_second(CLI::App& app, std::string& b) {
  app.add_option("B", b, "The other set")->required()->type_name("");
}

/// A command whose answer is a set.
template <SetKind Kind>
class SetOperation : public CommandBody {
 public:
  using Set = typename Kind::Set;

  void declare(CLI::App& app) override {
    declare_operands(app);
    if (reads_sets()) {
      input_.declare(app);
      if constexpr (requires { input_.declare_keep(app); }) {
        if (may_keep()) input_.declare_keep(app);
      }
      if constexpr (requires { input_.declare_keep_faces(app); }) {
        if (may_keep()) input_.declare_keep_faces(app);
      }
    }
    app.add_flag("--strict", strict_, "Exit 2 if the file would differ from the result");
    rounding_.declare(app, kHasGrid);
    if constexpr (kWritesMeshes) {
      app.add_flag("--triangles", triangles_, "Write triangles instead of polygons");
    }
    if constexpr (kHasCanonical) {
      app.add_flag("--canonical", canonical_, "Write equal .nef files for equal sets");
    }
  }

  ExitCode run(Session& session) override {
    open_output(session);
    if constexpr (requires { input_.keeps_faces(); }) output_.set_keeps_faces(input_.keeps_faces());
    session.expect(all_stages(session.options()));
    const Set result = numbered(compute(session), session);
    if constexpr (requires { result.sources(); }) {
      if (has_attributes_ && result.sources().empty() && !result.is_empty()) {
        session.note("the operation keeps no colours, ids and other attributes of faces");
      }
    }
    const auto facts = [&] {
      session.begin("measure");
      return Kind::facts(result, session.context()).json();
    };
    const auto file = [&] {
      session.begin("result");
      if constexpr (requires { Kind::ready(result, features_, output_, session); }) {
        return Kind::ready(result, features_, output_, session);
      } else {
        return Kind::ready(result, output_, session.context());
      }
    };
    output_.prepare(facts, file, strict_, session);
    output_.deliver(session);
    return ExitCode::Yes;
  }

 protected:
  const typename Kind::Input& input() const { return input_; }
  typename Kind::Input& input() { return input_; }
  virtual void declare_operands(CLI::App& app) = 0;
  /// Whether the command reads sets, so that the options of their readers have an effect.
  virtual bool reads_sets() const { return true; }
  /// Whether parts of the result are parts of operands, so that --keep has an effect.
  virtual bool may_keep() const { return true; }
  /// Returns the stages up to the result.
  virtual ProgressStages stages() const { return stages_of_sets<Kind>(1, 1); }
  /// Returns the result. Begins a stage "combine" for each operation.
  virtual Set compute(Session& session) = 0;
  std::vector<Set> read_all(const std::vector<std::string>& files, Session& session) {
    std::vector<Set> sets =
        read_sets(input_, files, session, [this](auto& read) { features_.add(read); });
    if constexpr (requires { sets[0].sources(); }) {
      for (const Set& set : sets) has_attributes_ = has_attributes_ || !set.sources().empty();
    }
    return sets;
  }
  Set read(const std::string& file, Session& session) {
    return std::move(read_all({file}, session).front());
  }
  /// Whether nothing but the closure of the result is asked for.
  bool needs_closure_only(Session& session) const {
    return !strict_ && !session.options().json && !Kind::keeps_marks(output_);
  }
  /// Opens the output before the work, and returns it.
  SetOutput& open_output(Session& session) {
    output_.open(Kind::formats(), session);
    output_.set_rounding(rounding_.read(session));
    output_.set_writes_triangles(triangles_);
    return output_;
  }
  bool is_strict() const { return strict_; }

 private:
  static constexpr bool kHasCanonical = requires(const Set& set, Context& context) {
    Kind::canonical(set, context);
  };

  static constexpr bool kHasGrid = requires { Kind::kHasGrid; };
  static constexpr bool kWritesMeshes = requires { Kind::kWritesMeshes; };

  ProgressStages all_stages(const CommonOptions& common) const {
    ProgressStages all = stages();
    if constexpr (kHasCanonical) {
      if (canonical_) all.push_back(numbering_solid());
    }
    if (common.json) all.push_back(Kind::measuring());
    for (const ProgressStage& stage : Kind::writing(output_)) all.push_back(stage);
    return all;
  }
  Set numbered(Set set, Session& session) const {
    if constexpr (kHasCanonical) {
      if (!canonical_) return set;
      session.begin("number");
      return Kind::canonical(set, session.context());
    }
    return set;
  }

  typename Kind::Input input_;
  RoundingOptions rounding_;
  bool strict_ = false;
  bool canonical_ = false;
  bool triangles_ = false;
  bool has_attributes_ = false;  // Whether an operand has attributes.
  typename FeaturesOfKind<Kind>::Type features_;
  SetOutput output_;
};

/// A command that combines two sets by a function of marks.
template <SetKind Kind>
class BinaryOperation : public SetOperation<Kind> {
 public:
  explicit BinaryOperation(MarkFunction function) : function_(function) {}

 private:
  void declare_operands(CLI::App& app) override {
    declare_first<Kind>(app, a_);
    declare_second(app, b_);
  }
  ProgressStages stages() const override { return stages_of_sets<Kind>(2, 1); }
  typename Kind::Set compute(Session& session) override {
    require_one_stdin({a_, b_});
    auto sets = this->read_all({a_, b_}, session);
    session.begin("combine");
    return boolean_op(std::move(sets[0]), std::move(sets[1]), function_, session.context());
  }

  MarkFunction function_;
  std::string a_;
  std::string b_;
};

enum class NaryFunction : std::uint8_t { Union, Intersection };

/// A command that unites or intersects two or more sets.
template <SetKind Kind>
class NaryOperation : public SetOperation<Kind> {
 public:
  using Set = typename Kind::Set;
  explicit NaryOperation(NaryFunction function) : function_(function) {}

 private:
  void declare_operands(CLI::App& app) override {
    declare_first<Kind>(app, a_);
    app.add_option("B", others_, "The other sets")->required()->type_name("");
  }
  ProgressStages stages() const override { return stages_of_sets<Kind>(1 + others_.size(), 1); }
  Set compute(Session& session) override {
    std::vector<std::string> files{a_};
    files.insert(files.end(), others_.begin(), others_.end());
    require_one_stdin(files);
    std::vector<Set> sets = this->read_all(files, session);
    session.begin("combine");
    Context& context = session.context();
    const bool is_union = function_ == NaryFunction::Union;
    if (sets.size() == 2) {  // Without copies of the operands.
      return boolean_op(std::move(sets[0]), std::move(sets[1]), is_union ? kUnion : kIntersection,
                        context);
    }
    return is_union ? union_of(sets, context) : intersection_of(sets, context);
  }

  NaryFunction function_;
  std::string a_;
  std::vector<std::string> others_;
};

/// A command that applies a member function to a set.
template <SetKind Kind>
class UnaryOperation : public SetOperation<Kind> {
 public:
  using Function = typename Kind::Set (Kind::Set::*)(Context&) const;
  explicit UnaryOperation(Function function) : function_(function) {}

 private:
  void declare_operands(CLI::App& app) override { declare_first<Kind>(app, a_); }
  typename Kind::Set compute(Session& session) override {
    const typename Kind::Set set = this->read(a_, session);
    session.begin("combine");
    return (set.*function_)(session.context());
  }

  Function function_;
  std::string a_;
};

/// A command that prints the facts of a set.
template <SetKind Kind>
class SetInfo : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    declare_first<Kind>(app, a_);
    input_.declare(app);
  }
  ExitCode run(Session& session) override {
    session.expect({Kind::reading(), Kind::measuring(), writing()});
    const auto set = std::move(read_sets(input_, {a_}, session).front());
    session.begin("measure");
    prepare(set, a_, session);
    const auto facts = Kind::facts(set, session.context());
    session.answer(facts.json().dump(), [&](std::ostream& out) { facts.write(out); });
    return ExitCode::Yes;
  }

 protected:
  /// Adds further outputs.
  virtual void prepare(const typename Kind::Set&, const std::string&, Session&) {}

 private:
  std::string a_;
  typename Kind::Input input_;
};

/// A command that locates a point.
template <SetKind Kind>
class SetLocate : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    declare_first<Kind>(app, a_);
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      app.add_option(Kind::kAxes[i], texts_[i], i == 0 ? "The point: 3, -1/7, 2.5" : "")
          ->required()
          ->type_name("");
    }
    input_.declare(app);
  }
  ExitCode run(Session& session) override {
    std::array<Rational, Kind::kAxes.size()> point;
    for (std::size_t i = 0; i < point.size(); ++i) {
      point[i] = read_number_argument(texts_[i], Kind::kAxes[i], session);
    }
    session.expect({Kind::reading(), Kind::locating(), writing()});
    const auto set = std::move(read_sets(input_, {a_}, session).front());
    session.begin("locate");
    const auto [on, is_marked] = Kind::locate(set, point);
    const nlohmann::ordered_json json{{"on", on}, {"marked", is_marked}};
    session.answer(json.dump(), [&, on = on, is_marked = is_marked](std::ostream& out) {
      out << on << (is_marked ? ", in the set\n" : ", not in the set\n");
    });
    return ExitCode::Yes;
  }

 private:
  std::string a_;
  std::array<std::string, Kind::kAxes.size()> texts_;
  typename Kind::Input input_;
};

}  // namespace plumb::cli
