# Functions that the scripts of this folder share; they source this file.
# Sets `root`, the package's folder, and puts Debian's Python first in PATH, because catkin requires it.

root=$(cd -P "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$root/build-ros  # not build/, because rosrun skips a folder of this name
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH
unset PYTHONHOME PYTHONPATH

say() { echo "== $*"; }

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# Durations of the stages on two cores if nothing is built yet, measured with `scripts/benchmark_start --build`.
declare -A takes=(
  [install]="a minute plus the download"
  [configure]="10 s"
  [demo]="4 min"
  [all]="8 min"
  [tests]="10 min"
  [all-tests]="12 min"
  [input]="2 min"
  [address]="20 min"
  [thread]="4 min"
  [run-tests]="5 min"
  [run-all-tests]="25 min"
)

# Runs a stage of some minutes, and prints its expected and its actual duration.
# stage WHAT KEY_OF_TAKES COMMAND [ARGUMENT...]
stage() {
  local what=$1 begin=$SECONDS time=${takes[$2]}
  shift 2
  say "$what ($time on two cores)"
  "$@"
  say "$what: done in $(duration $((SECONDS - begin)))"
}

duration() {
  if [ "$1" -lt 60 ]; then echo "$1 s"; else echo "$(($1 / 60)) min $(($1 % 60)) s"; fi
}

# Builds with progress in one line on a terminal, as ninja shows it, and otherwise in one line every 15 s, with all
# messages of the compiler.
build() {
  if [ -t 1 ]; then
    cmake --build "$@" --parallel "$(nproc)"
  else
    cmake --build "$@" --parallel "$(nproc)" | thin_out
  fi
}

# Prints only one of the lines `[3/533] Building ...` (ninja) or `[  3%] Building ...` (make) every 15 s, and the last.
thin_out() {
  local line next=0 step='^\[ *([0-9]+)(/([0-9]+)|%)\] '
  while IFS= read -r line || [ -n "$line" ]; do
    if [[ $line =~ $step ]] && [ "${BASH_REMATCH[1]}" != "${BASH_REMATCH[3]:-100}" ]; then
      [ $SECONDS -ge $next ] || continue
      next=$((SECONDS + 15))
    fi
    printf '%s\n' "$line"
  done
}

# Makes a temporary file, or with -d a folder, outside of the package.
scratch() { mktemp "$@" "${TMPDIR:-/tmp}/rubber_suspension.XXXXXX"; }

# Sets `launcher` to options that make CMake call the compiler through ccache, if it is installed. ccache only caches
# code with precompiled headers if it may ignore macros and times in them. It has to hash comments: a precompiled header
# of which only a comment differs from its file does not count as included, so that its file is compiled twice.
use_ccache() {
  launcher=()
  command -v ccache >/dev/null || return 0
  local sloppiness
  sloppiness=$(ccache --get-config sloppiness)
  local command="env;CCACHE_COMMENTS=1;CCACHE_SLOPPINESS=pch_defines,time_macros${sloppiness:+,${sloppiness// /}};ccache"
  launcher=("-DCMAKE_C_COMPILER_LAUNCHER=$command" "-DCMAKE_CXX_COMPILER_LAUNCHER=$command")
}

# Prints `debian`, `ubuntu`, or `other` if these scripts cannot install packages.
distribution() {
  local ID=other VERSION_ID=
  [ -r /etc/os-release ] && . /etc/os-release
  case $ID-$VERSION_ID in
    debian-12 | debian-13) echo debian ;;
    ubuntu-20.04) echo ubuntu ;;
    *) echo other ;;
  esac
}
