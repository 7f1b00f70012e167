# Shared by the scripts beside it. To be sourced by bash, with `set -euo pipefail` in force.
# shellcheck shell=bash

unset CDPATH
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly root

say() { printf '%s\n' "$*" >&2; }

# Runs a command as root: as it is for root, else through sudo, which asks for a password only at a terminal.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif [ -t 0 ]; then
        sudo "$@"
    else
        sudo -n "$@"
    fi
}

# install_packages GROUP...: installs the packages of these groups in packages.txt that are missing.
install_packages() {
    local wanted missing
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "No apt here: install what scripts/packages.txt names by hand."
        return 0
    fi
    wanted=$(awk -v groups=" $* " 'index(groups, " " $1 " ") { print $2 }' "$root/scripts/packages.txt")
    missing=$(comm -23 <(sort -u <<<"$wanted") \
        <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2>/dev/null | awk '$1 == "installed" { print $2 }' | sort -u))
    if [ -z "$missing" ]; then
        return 0
    fi
    local -a packages
    mapfile -t packages <<<"$missing"
    say "Installing: ${packages[*]}"
    if ! { apt_get update && apt_get -y --no-install-recommends install "${packages[@]}"; }; then
        say "This did not work. As root, run: apt-get update && apt-get install ${packages[*]}"
        return 1
    fi
}

apt_get() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 "$@" >&2
}

# configure PRESET [CMAKE-ARGUMENT...]: only when there is no build tree yet, or with arguments. Ninja sees to the rest.
configure() {
    local preset=$1
    shift
    if [ $# -gt 0 ] || [ ! -f "$root/build/$preset/build.ninja" ]; then
        (cd "$root" && cmake --preset "$preset" "$@" >&2)
    fi
}

# build PRESET [TARGET...]: builds everything, or these targets, with at most as many jobs as the memory holds.
build() {
    local preset=$1 jobs memory
    local -a targets=("${@:2}")
    jobs=$(nproc 2>/dev/null || echo 1)
    memory=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo 2>/dev/null || echo 1)
    if [ "${memory:-1}" -lt "$jobs" ]; then
        jobs=$((memory > 1 ? memory : 1))
    fi
    (cd "$root" && cmake --build --preset "$preset" --parallel "$jobs" ${targets[@]+--target "${targets[@]}"} >&2)
}

# run_tests PRESET [CTEST-ARGUMENT...]: adds to `passed`, `failed` and `skipped`; 1 when a test failed.
passed=0
failed=0
skipped=0
run_tests() {
    local preset=$1 report status=0 all bad left
    shift
    report=$root/build/$preset/tests.xml
    rm -f "$report"
    (cd "$root" && ctest --preset "$preset" --parallel "$(nproc 2>/dev/null || echo 1)" --output-junit "$report" "$@") >&2 \
        || status=1
    all=$(junit_count tests "$report")
    bad=$(junit_count failures "$report")
    left=$(($(junit_count skipped "$report") + $(junit_count disabled "$report")))
    if [ "$all" -eq 0 ]; then
        say "No test was run in $preset."
        status=1
    fi
    # A test that could not start is not among the failures of the report.
    if [ "$status" -ne 0 ] && [ "$bad" -eq 0 ]; then
        bad=1
    fi
    passed=$((passed + all - bad - left))
    failed=$((failed + bad))
    skipped=$((skipped + left))
    return "$status"
}

# junit_count NAME FILE: a number from the head of ctest's report; 0 when it is not there.
junit_count() {
    local count
    count=$(grep -m 1 -oE "\\b$1=\"[0-9]+\"" "$2" 2>/dev/null | head -n 1 | tr -dc '0-9') || true
    printf '%s' "${count:-0}"
}
