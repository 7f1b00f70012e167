# shellcheck shell=bash
# Shared by the tests of the batch samples: $work, a directory that is gone at the end, with meshes in $work/in and what one
# machine makes of them in $work/clean; $samples; lodsmith on the PATH. To be sourced with LODSMITH and the source directory.
work=$(mktemp -d)
# shellcheck disable=SC2034 # for those that source this
samples=$2/src/samples/batch
servers=()

finish() {
    [ ${#servers[@]} -eq 0 ] || kill "${servers[@]}" 2>/dev/null || true
    wait
    rm -rf "$work"
}
trap finish EXIT

fail() {
    echo "failed: $*" >&2
    find "$work" -name '*.log' -exec tail -n 5 {} + | cut -c1-200 >&2
    exit 1
}

skip() {
    echo "skipped: $*"
    exit 77
}

# need PROGRAM...: skips the test when one of them is missing.
need() {
    local program
    for program; do
        command -v "$program" >/dev/null || skip "there is no $program"
    done
}

# until_true SECONDS COMMAND...: waits until the command succeeds.
until_true() {
    local end=$((SECONDS + $1))
    shift
    until "$@" >/dev/null 2>&1; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.05
    done
}

# kill_shards PATTERN: kills, all at once, what works on shards that match (an extended regular expression).
kill_shards() {
    local process
    for process in $(pgrep --full -- "lodsmith generate in -o out --shard $1 " || true); do
        [ "$(readlink "/proc/$process/cwd")" != "$work" ] || kill -9 "$process" 2>/dev/null || true
    done
}

# The directories in each other's place: bytes alike, records too, and nothing besides but what a killed process left.
same_as_clean() {
    diff -r --exclude='.lodsmith-*.tmp' "$work/clean" "$work/out" >&2 || fail "the outputs differ from those of one machine"
}

mkdir "$work/bin" "$work/in"
ln -s "$(realpath "$1")" "$work/bin/lodsmith"
PATH=$work/bin:$PATH
for number in $(seq 24); do
    mkdir "$work/in/$number"
    cp "$2"/media/*/*.mesh "$2"/media/*/*.skeleton "$work/in/$number/" 2>/dev/null || true
done
cd "$work" || exit 1
lodsmith generate in -o clean >/dev/null 2>&1 || fail "one machine cannot make them"
