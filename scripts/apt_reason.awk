# Reads the output of apt-get `update` and `install`, and prints why it failed: errors of dpkg with the package, missing
# or conflicting packages, or the network; otherwise the errors of apt.
# Used by scripts/build: awk -f apt_reason.awk LOG

function add(line) {
  if (!(line in seen) && count < 12) {
    seen[line]
    reason[++count] = line
  }
}

# The line after `dpkg: error processing` states the error; the line before may be output of the package's script.
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

# Excludes errors of apt that only follow from others.
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
