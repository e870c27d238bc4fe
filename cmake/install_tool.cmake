# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs the tool with its page and its completions, which it prints itself: the component `rtuwire_tool`. Who configures
# and installs, without a build between, gets the headers, and is told so; who asks for this component has to build it.
include(GNUInstallDirs)

set(rtuwire_tool_texts)
function(rtuwire_print file)
    set(text "${CMAKE_CURRENT_BINARY_DIR}/texts/${file}")
    add_custom_command(OUTPUT "${text}"
        COMMAND rtuwire_tool ${ARGN} > "${text}"
        DEPENDS rtuwire_tool VERBATIM)
    set(rtuwire_tool_texts ${rtuwire_tool_texts} "${text}" PARENT_SCOPE)
endfunction()
file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/texts/zsh")
rtuwire_print(rtuwire.1 man)
rtuwire_print(rtuwire completion bash)
rtuwire_print(zsh/_rtuwire completion zsh)
add_custom_target(rtuwire_tool_texts ALL DEPENDS ${rtuwire_tool_texts})

install(CODE "if(NOT EXISTS \"$<TARGET_FILE:rtuwire_tool>\")
    set(level STATUS)
    if(CMAKE_INSTALL_COMPONENT STREQUAL \"rtuwire_tool\")
        set(level FATAL_ERROR)
    endif()
    message(\${level} \"The tool is not installed: it was not built (cmake --build)\")
endif()" COMPONENT rtuwire_tool)
install(TARGETS rtuwire_tool RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT rtuwire_tool OPTIONAL)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/texts/rtuwire.1"
    DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT rtuwire_tool OPTIONAL)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/texts/rtuwire"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT rtuwire_tool OPTIONAL)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/texts/zsh/_rtuwire"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions" COMPONENT rtuwire_tool OPTIONAL)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/tools/devices" DESTINATION "${CMAKE_INSTALL_DATADIR}/rtuwire" COMPONENT rtuwire_tool)
