// Certificates: files with which a small program of another hand checks a verdict
// (docs/certificates.md, tools/verify_certificate.py).
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "plumb/cli/files/operands.h"
#include "plumb/cli/session/session.h"
#include "plumb/plane/map_check.h"
#include "plumb/space/nef3.h"

namespace plumb::cli {

/// The option --certificate of a command, and its output.
class CertificateOption {
 public:
  void declare(CLI::App& app) {
    app.add_option("--certificate", file_, "Write a proof of the verdict (docs/certificates.md)")
        ->type_name("OUT");
  }
  /// Opens the output before the work, if there is one. Requires that the option outlives the
  /// session's outputs.
  void open(Session& session);
  /// Whether a certificate is asked for.
  bool is_given() const { return !file_.empty(); }
  /// Adds a claim with the members that prove it.
  void prove(const std::string& claim, nlohmann::ordered_json members);
  /// Sets the sentence that says why a verdict has no claim.
  void explain(const std::string& reason) { reason_ = reason; }

 private:
  std::string file_;
  nlohmann::ordered_json claims_ = nlohmann::ordered_json::array();
  std::string reason_;
};

/// Claims that a map is no planar subdivision, because of the first defect that has one.
/// `listed_cycles` is the number of cycles in the file.
void certify_map(const MapReport& report, const MapCheckOptions& options, std::size_t listed_cycles,
                 const CommonOptions& common, CertificateOption& certificate);

/// Claims with a point that "A lies in B" or "B lies in A" is false, and with a point or a plane
/// whether the sets meet.
void certify_comparison(const Nef3& a, const Nef3& b, const SolidInput& input, Session& session,
                        CertificateOption& certificate);

/// Claims with a segment that a set is not convex.
void certify_not_convex(const Nef3& set, const SolidInput& input, Session& session,
                        CertificateOption& certificate);

}  // namespace plumb::cli
