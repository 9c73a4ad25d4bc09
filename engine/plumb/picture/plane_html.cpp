#include "plumb/picture/plane_html.h"

#include <ostream>

#include "plumb/picture/svg/svg_text.h"

namespace plumb {
namespace {

constexpr std::string_view kStyle = R"(<style>
html,body{height:100%;margin:0;overflow:hidden;background:#fff}
#view{height:100%;touch-action:none;cursor:grab;overflow:hidden}
#page{transform-origin:0 0;width:max-content}
#hint{position:fixed;left:50%;bottom:12px;transform:translateX(-50%);margin:0;padding:6px 12px;
  width:max-content;max-width:calc(100vw - 56px);border-radius:6px;background:#1f2933e6;color:#fff;
  font:14px/1.4 system-ui,sans-serif;pointer-events:none}
</style>
)";

constexpr std::string_view kProgram = R"JS(<script>
'use strict';
const view = document.getElementById('view'), page = document.getElementById('page');
const svg = page.querySelector('svg'), size = svg.viewBox.baseVal;
let x, y, scale;
function place() { page.style.transform = `translate(${x}px,${y}px) scale(${scale})`; }
function reset() {
  scale = Math.min(view.clientWidth / size.width, view.clientHeight / size.height);
  if (view.clientWidth < view.clientHeight) scale = view.clientWidth / size.width;
  x = Math.max(0, (view.clientWidth - scale * size.width) / 2);
  y = 0;
  place();
}
function enlarge(by, at) {
  const next = Math.min(100, Math.max(.05, scale * by));
  x = at[0] + (x - at[0]) * next / scale;
  y = at[1] + (y - at[1]) * next / scale;
  scale = next;
  place();
}
const held = new Map();
view.addEventListener('pointerdown', e => {
  view.setPointerCapture(e.pointerId);
  held.set(e.pointerId, [e.clientX, e.clientY]);
});
for (const end of ['pointerup', 'pointercancel']) view.addEventListener(end, e => held.delete(e.pointerId));
view.addEventListener('pointermove', e => {
  const last = held.get(e.pointerId);
  if (!last) return;
  const now = [e.clientX, e.clientY];
  x += (now[0] - last[0]) / held.size;
  y += (now[1] - last[1]) / held.size;
  if (held.size > 1) {
    const [other] = [...held].filter(([id]) => id !== e.pointerId).map(([, at]) => at);
    const apart = at => Math.hypot(at[0] - other[0], at[1] - other[1]);
    if (apart(last) > 0) enlarge(apart(now) / apart(last), [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
  }
  held.set(e.pointerId, now);
  place();
});
view.addEventListener('wheel', e => {
  e.preventDefault();
  enlarge(Math.exp(-e.deltaY * (e.deltaMode ? .05 : .0015)), [e.clientX, e.clientY]);
}, {passive: false});
view.addEventListener('dblclick', reset);
view.addEventListener('keydown', e => {
  const steps = {ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40]};
  const middle = [view.clientWidth / 2, view.clientHeight / 2];
  if (e.key in steps) { x += steps[e.key][0]; y += steps[e.key][1]; place(); }
  else if (e.key === '+' || e.key === '=') enlarge(1.2, middle);
  else if (e.key === '-') enlarge(1 / 1.2, middle);
  else if (e.key === '0') reset();
  else return;
  e.preventDefault();
});
addEventListener('resize', reset);
for (const act of ['pointerdown', 'wheel', 'keydown'])
  addEventListener(act, () => document.getElementById('hint')?.remove());
reset();
</script>
)JS";

}  // namespace

void write_plane_html(std::ostream& out, std::string_view svg, const std::string& title) {
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>"
      << xml_escaped(title) << "</title>\n"
      << kStyle << "</head>\n<body>\n<div id=\"view\" tabindex=\"0\"><div id=\"page\">\n"
      << svg
      << "</div></div>\n<p id=\"hint\">Drag to move; pinch, or turn the wheel, to enlarge; "
         "double-click to see all.</p>\n"
      << kProgram << "</body>\n</html>\n";
}

}  // namespace plumb
