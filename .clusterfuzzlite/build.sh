#!/bin/sh
# Called by the image; the work is shared with OSS-Fuzz and fuzz/check_oss_fuzz.
exec "$SRC/plumb/fuzz/build_for_oss_fuzz"
