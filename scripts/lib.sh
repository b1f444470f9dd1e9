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

# In a newly made file or folder, not in the package's own.
scratch() { mktemp "$@" "${TMPDIR:-/tmp}/rubber_suspension.XXXXXX"; }

# `debian` or `ubuntu`, `other` where nothing can be installed by these scripts.
distribution() {
  local ID=other VERSION_ID=
  [ -r /etc/os-release ] && . /etc/os-release
  case $ID-$VERSION_ID in
    debian-12) echo debian ;;
    ubuntu-20.04) echo ubuntu ;;
    *) echo other ;;
  esac
}
