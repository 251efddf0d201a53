# An OpenMesh 8.1, as far as the check of its version looks.
add_library(OpenMeshCore INTERFACE IMPORTED)
add_library(OpenMeshTools INTERFACE IMPORTED)
set_target_properties(OpenMeshCore PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/include)
