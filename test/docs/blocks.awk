# Takes the code out of pages and of header comments, so that the tests compile and run what a reader sees.
#
#   awk -v dir=OUT -f blocks.awk PAGE.md HEADER.hh ...
#
# A fenced block of a page, and what stands between \code and \endcode in a header, is a block. The line
# `<!-- test: NAME -->` above it gives it a name. A C++ block becomes OUT/NAME.inc, with a #line back to its page;
# a block of another language L becomes OUT/NAME.L. OUT/index has a line for each block: NAME LANGUAGE PAGE:LINE,
# with "-" for a missing name. OUT/commands has a line for each indented one of the pages: PAGE:LINE, a tab, the text.
# Files that would stay the same are not touched.

function put(path, text, old, line, status) {
  old = ""
  while ((status = (getline line < path)) > 0) old = old line "\n"
  close(path)
  if (status == 0 && old == text) return
  printf "%s", text > path
  close(path)
}

function finish() {
  if (name != "-") {
    if (name in seen) {
      print "blocks.awk: two blocks have the name " name > "/dev/stderr"
      failed = 1
    }
    seen[name] = 1
    if (language == "cpp")
      put(dir "/" name ".inc", "#line " (start + 1) " \"" FILENAME "\"\n" body)
    else
      put(dir "/" name "." language, body)
  }
  blocks = blocks name " " language " " FILENAME ":" start "\n"
  name = "-"
  inside = 0
}

FNR == 1 {
  is_header = FILENAME ~ /\.hh$/
  inside = 0
  name = "-"
  blank = 1
  indented = 0
}

is_header {
  if ($0 !~ /^ *\/\/\//) next
  sub(/^ *\/\/\/ ?/, "")
}

inside {
  if ($0 ~ (is_header ? "^\\\\endcode" : "^```")) finish()
  else body = body $0 "\n"
  next
}

/^<!-- test: [a-z0-9_]+ -->$/ { name = $3; next }

is_header && /^\\code/ || !is_header && /^```/ {
  language = is_header ? "cpp" : substr($0, 4)
  if (language == "") language = "none"
  start = FNR
  body = ""
  inside = 1
  next
}

!is_header {
  indented = /^    [^ ]/ && (blank || indented) || indented && /^    /
  blank = /^$/
  if (indented) commands = commands FILENAME ":" FNR "\t" substr($0, 5) "\n"
}

# A name belongs to the block right below it.
{ name = "-" }

END {
  put(dir "/index", blocks)
  put(dir "/commands", commands)
  exit failed
}
