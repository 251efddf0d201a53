/// \file
/// The statements of OBJ that are not read.
#pragma once

#include <string_view>

#include "files/Fault.hh"

namespace whittle::files {

struct ObjStatement {
  std::string_view keyword;
  const char* meaning;
};

constexpr ObjStatement unread_obj_statements[] = {
    {"usemap", "texture maps"},
    {"maplib", "texture maps"},
    {"mg", "merging groups"},
    {"l", "lines"},
    {"p", "points"},
    {"vp", "free-form geometry"},
    {"deg", "free-form geometry"},
    {"bmat", "free-form geometry"},
    {"step", "free-form geometry"},
    {"cstype", "free-form geometry"},
    {"curv", "free-form geometry"},
    {"curv2", "free-form geometry"},
    {"surf", "free-form geometry"},
    {"parm", "free-form geometry"},
    {"trim", "free-form geometry"},
    {"hole", "free-form geometry"},
    {"scrv", "free-form geometry"},
    {"sp", "free-form geometry"},
    {"con", "free-form geometry"},
    {"end", "free-form geometry"},
    {"ctech", "free-form geometry"},
    {"stech", "free-form geometry"},
    {"bevel", "display settings"},
    {"c_interp", "display settings"},
    {"d_interp", "display settings"},
    {"lod", "display settings"},
    {"shadow_obj", "display settings"},
    {"trace_obj", "display settings"},
};

/// What a statement that is not read is about.
/// \throw Fault  OBJ has no such statement
inline const char* unread_statement(std::string_view keyword) {
  for (const ObjStatement& statement : unread_obj_statements)
    if (statement.keyword == keyword) return statement.meaning;
  throw Fault("unknown statement " + in_quotes(keyword));
}

inline bool is_obj_keyword(std::string_view keyword) {
  for (const std::string_view read : {"v", "vt", "vn", "f", "usemtl", "mtllib", "o", "g", "s"})
    if (keyword == read) return true;
  for (const ObjStatement& statement : unread_obj_statements)
    if (statement.keyword == keyword) return true;
  return false;
}

}  // namespace whittle::files
