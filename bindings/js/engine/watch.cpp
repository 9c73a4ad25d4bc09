// What the JavaScript of the package needs beside the C interface: progress callbacks of C that
// call JavaScript. The function in JavaScript (lib/memory.js) never throws; if an operation shall
// stop, it calls plumb_context_cancel().
#include <emscripten.h>
#include <plumb.h>

#include <cstdint>

EM_JS(void, plumb_js_report, (const char* phase, double done, double total),
      { Module.onProgress(UTF8ToString(phase), done, total); });

namespace {

void report(const char* phase, std::uint64_t done, std::uint64_t total, void*) {
  plumb_js_report(phase, static_cast<double>(done), static_cast<double>(total));
}

}  // namespace

/// Makes the operations of a context report to JavaScript.
extern "C" EMSCRIPTEN_KEEPALIVE void plumb_js_watch(plumb_context* context) {
  plumb_context_set_progress(context, &report, nullptr, nullptr);
}
