#!/usr/bin/env bash
# Installs what is missing, builds everything in the release preset and runs the tests. Arguments go to ctest.
# The last line of the output is "N passed, N failed".
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# Further meshes, where a checkout has them beside it.
extra_media=$(cd "$root/../shared/media" 2>/dev/null && pwd) || extra_media=

install_packages build
configure release "-DLODSMITH_EXTRA_MEDIA=$extra_media"
build release

status=0
run_tests release "$@" || status=1
if [ "$skipped" -gt 0 ]; then
    echo "$skipped skipped"
fi
echo "$passed passed, $failed failed"
exit "$status"
