# What the scripts of this folder share; sourced by them, run by nobody.
# Sets `root`, the package's folder, and puts Debian's own Python first: catkin runs on no other.

root=$(cd -P "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$root/build-ros  # not build/: rosrun skips whatever lies in a package's folder of that name
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH
unset PYTHONHOME PYTHONPATH

say() { echo "== $*"; }

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# How long stages take on two cores where nothing is built yet: `scripts/benchmark_start --build` measures it.
declare -A takes=(
  [install]="a minute, and the download"
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

# Runs a stage of some minutes: says what it does and how long that takes, at the end how long it took.
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

# A build with its progress: on a terminal in one line, as ninja shows it; elsewhere in a line every 15 s, with all that
# a compiler says.
build() {
  if [ -t 1 ]; then
    cmake --build "$@" --parallel "$(nproc)"
  else
    cmake --build "$@" --parallel "$(nproc)" | thin_out
  fi
}

# Of the lines `[3/533] Building ...` (ninja) and `[  3%] Building ...` (make) one every 15 s and the last.
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

# In a newly made file or folder, not in the package's own.
scratch() { mktemp "$@" "${TMPDIR:-/tmp}/rubber_suspension.XXXXXX"; }

# Sets `launcher`: what makes CMake put ccache before the compiler, where it is installed. ccache keeps nothing that was
# compiled with precompiled headers unless it is allowed to pass over macros and times in them.
use_ccache() {
  launcher=()
  command -v ccache >/dev/null || return 0
  local sloppiness
  sloppiness=$(ccache --get-config sloppiness)
  local command="env;CCACHE_SLOPPINESS=pch_defines,time_macros${sloppiness:+,${sloppiness// /}};ccache"
  launcher=("-DCMAKE_C_COMPILER_LAUNCHER=$command" "-DCMAKE_CXX_COMPILER_LAUNCHER=$command")
}

# `debian` or `ubuntu`, `other` where nothing can be installed by these scripts.
distribution() {
  local ID=other VERSION_ID=
  [ -r /etc/os-release ] && . /etc/os-release
  case $ID-$VERSION_ID in
    debian-12 | debian-13) echo debian ;;
    ubuntu-20.04) echo ubuntu ;;
    *) echo other ;;
  esac
}
