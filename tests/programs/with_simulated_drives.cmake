# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The programs against drives that the command line tool simulates.
set(simulate "$<TARGET_FILE:rtuwire_tool>")
set(demo "$<TARGET_FILE:example_demo>")

function(add_program_test name script)
    add_test(NAME "${name}"
        COMMAND "${RTUWIRE_PYTHON}" -B "${CMAKE_CURRENT_SOURCE_DIR}/${script}" ${ARGN})
endfunction()

foreach(way HUP INT QUIT TERM USR1 ABRT SEGV)
    add_program_test("motion law: S25 the demo stops the motor of atv320 before it ends by ${way}"
        ways_out.py "${simulate}" "${demo}" atv320 ${way})
endforeach()
foreach(drive atv28 atv310_2026)
    add_program_test("motion law: S25 the demo stops the motor of ${drive} before it ends by HUP"
        ways_out.py "${simulate}" "${demo}" ${drive} HUP)
endforeach()
foreach(drive atv28 atv320)
    add_program_test("motion law: S25 the demo stops the motor of ${drive} when its reader goes away"
        ways_out.py "${simulate}" "${demo}" ${drive} head)
endforeach()
add_program_test("motion law: S25 the demo stops the motor when the disk is full"
    ways_out.py "${simulate}" "${demo}" atv320 full)
add_program_test("motion law: S25 the demo stops the motor when its terminal is closed"
    ways_out.py "${simulate}" "${demo}" atv320 terminal)
add_program_test("motion law: S25 the demo starts no motor where nobody can read of it"
    ways_out.py "${simulate}" "${demo}" atv320 nobody)
add_program_test("motion law: S25 the demo leaves the motor without power at the second Ctrl-C"
    ways_out.py "${simulate}" "${demo}" atv320 twice)
add_program_test("motion law: S25 the demo stops its motor when it is interrupted while the simulated cable is cut"
    messages.py "${simulate}" "${demo}" cut_cable)

# A program that uses the same parts, and breaks while its motor turns.
add_executable(breaks breaks.cpp)
target_link_libraries(breaks PRIVATE rtuwire::rtuwire rtuwire_warnings Threads::Threads)
foreach(way throw missing deep)
    add_program_test("motion law: S25 the demo stops the motor when it breaks: ${way}"
        ways_out.py "${simulate}" "$<TARGET_FILE:breaks>" atv320 ${way})
endforeach()

foreach(program demo simulate)
    add_program_test("motion law: S26 the ${program} program with closed descriptors writes frames to its line, nothing else"
        closed_descriptors.py "${simulate}" "${demo}" ${program})
endforeach()

add_program_test("motion law: S37 the demo stops the motor before Ctrl-Z suspends it"
    ways_out.py "${simulate}" "${demo}" atv320 TSTP)
add_program_test("motion law: S37 the demo goes on behind a pipe that nobody reads, and counts what it drops"
    no_time_for_output.py "${simulate}" "${demo}" atv320 pipe)
add_program_test("motion law: S37 the demo goes on while Ctrl-S holds its terminal"
    no_time_for_output.py "${simulate}" "${demo}" atv320 ctrl-s)
add_program_test("motion law: S37 the demo takes the order back after it was stopped"
    no_time_for_output.py "${simulate}" "${demo}" atv320 stopped)
add_program_test("motion law: S37 the demo takes the order back after its machine slept"
    no_time_for_output.py "${simulate}" "${demo}" atv320 asleep)
add_program_test("motion law: S37 the simulate program answers while its output blocks"
    no_time_for_output.py "${simulate}" "${demo}" atv320 simulate)

add_program_test("examples: messages name what is wrong, and no output is lost without a word"
    messages.py "${simulate}" "${demo}" messages)
add_program_test("defect: D40 the demo tells what it leaves, and looks for a fault before it runs a motor"
    messages.py "${simulate}" "${demo}" leaving)
