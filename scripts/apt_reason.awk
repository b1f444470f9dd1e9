# Reads what apt-get wrote, of `update` and then of `install`, and prints why it failed: what dpkg says of which package,
# packages that there are none of or that do not go together, the network where it was that; else apt's own errors.
# Used by scripts/build: awk -f apt_reason.awk LOG

function add(line) {
  if (!(line in seen) && count < 12) {
    seen[line]
    reason[++count] = line
  }
}

# The line after `dpkg: error processing` says what happened; the line before may be from the package's own script.
about != "" {
  if ($0 ~ /dependency problems/) {  # follows from another error
    follows = about
  } else {
    if (before !~ /^(Setting up|Unpacking|Preparing to|Removing|Processing|$)/) add(before)
    add(about)
    add($0)
  }
  about = ""
}
/^dpkg: error processing / { about = $0; before = previous }
/^dpkg: (unrecoverable |fatal )?error: / { add($0) }

/have unmet dependencies:$/ { unmet = 1; next }
!/^ / { unmet = 0 }
unmet { add($0) }

/^E: (Unable to locate package|Package .* has no installation candidate)/ { add(substr($0, 4)); missing = 1 }

/Temporary failure resolving|Could not (resolve|connect)|onnection (timed out|failed|refused)|is unreachable/ {
  said = $0
  sub(/^([EW]: )?(Failed to fetch [^ ]+)? */, "", said)
  if (/^E: /) no_package = said
  network = said
  next
}

# What apt says in any case, or after an error that is told already.
/^E: / && !/Can not write log|Sub-process .*dpkg returned|Unable to fetch some archives/ { others = others substr($0, 4) "\n" }
NF { previous = $0 }

END {
  if (count == 0 && follows != "") add(follows)
  for (i = 1; i <= count; ++i) print reason[i]
  if (no_package != "" || missing && network != "") {
    print "no connection to the archive: " network "; is there a network?"
  } else if (count == 0) {
    printf "%s", others != "" ? others : previous "\n"
  }
}
