#!/usr/bin/env bash
# src/samples/batch/gnu-parallel.sh, killed half-way with all that it has started, and begun again: the bytes of one machine.
set -euo pipefail
# shellcheck source=tests/batch/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

need parallel setsid
export HOME=$work # GNU parallel keeps its own files there

has_begun() { compgen -G "out/*/*.mesh"; }

setsid "$samples/gnu-parallel.sh" 8 in out >/dev/null 2>&1 &
group=$!
until_true 60 has_begun || fail "no part begins"
kill -9 -- "-$group" 2>/dev/null || true
wait "$group" 2>/dev/null || true
kill_shards '[0-9]+/8' # GNU parallel gives each part a process group of its own
diff -r clean out >/dev/null 2>&1 && fail "it was too fast to be disturbed"

"$samples/gnu-parallel.sh" 8 in out >/dev/null 2>log || fail "it does not come to its end: $(tail -n 5 log)"
grep -qE '^0 made, [1-9][0-9]* up to date, 0 failed$' log || fail "the parts have left something undone"
same_as_clean
