# OpenMesh installs no version file, so find_package() cannot ask for a version: it is read from OpenMesh's config.h.

# whittle_check_openmesh(variable): sets it to why the target OpenMeshCore cannot be used, or to "" if it can. Where
# config.h is not found the answer is "": the headers check the version again when they are compiled.
function(whittle_check_openmesh variable)
  set(reason "")
  get_target_property(folders OpenMeshCore INTERFACE_INCLUDE_DIRECTORIES)
  string(REGEX REPLACE "\\$<(BUILD_INTERFACE|INSTALL_INTERFACE):([^>]*)>" "\\2" folders "${folders}")
  find_file(config OpenMesh/Core/System/config.h PATHS ${folders} NO_DEFAULT_PATH NO_CACHE)
  if(NOT config)
    find_file(config OpenMesh/Core/System/config.h NO_CACHE)
  endif()
  if(config)
    file(STRINGS "${config}" line REGEX "^[ \t]*#define[ \t]+OM_VERSION[ \t]+0x[0-9a-fA-F]+")
    if(line MATCHES "0x[0-9a-fA-F]+")
      math(EXPR version "${CMAKE_MATCH_0}")
      if(version LESS 589824)  # 0x90000
        math(EXPR major "${version} >> 16")
        math(EXPR minor "${version} >> 8 & 255")
        set(reason "Whittle needs OpenMesh 9 or newer; ${config} is version ${major}.${minor}. \
Set OpenMesh_DIR to the folder of a newer OpenMeshConfig.cmake.")
      endif()
    endif()
  endif()
  set(${variable} "${reason}" PARENT_SCOPE)
endfunction()
