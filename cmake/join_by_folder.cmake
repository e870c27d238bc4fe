# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# rtuwire_join_by_folder(NAME ROOT): the sources in the list of that NAME, all below ROOT, as one file a folder, which includes
# them: what their headers take to compile is taken once. Names of one folder must not clash.
function(rtuwire_join_by_folder sources_name root)
    list(TRANSFORM ${sources_name} REPLACE "^${root}/" "" OUTPUT_VARIABLE names)
    foreach(name IN LISTS names)
        get_filename_component(folder "${name}" DIRECTORY)
        string(MAKE_C_IDENTIFIER "joined${folder}" folder)
        string(APPEND ${folder} "#include <${name}>\n")
        list(APPEND folders ${folder})
    endforeach()
    list(REMOVE_DUPLICATES folders)
    foreach(folder IN LISTS folders)
        file(CONFIGURE OUTPUT ${folder}.cpp CONTENT "${${folder}}")
        list(APPEND paths "${CMAKE_CURRENT_BINARY_DIR}/${folder}.cpp")
    endforeach()
    set(${sources_name} "${paths}" PARENT_SCOPE)
endfunction()
