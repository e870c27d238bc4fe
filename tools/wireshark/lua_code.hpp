// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the script for Wireshark does with the tables: it runs behind Wireshark's own dissectors, on captures in UDP.
#pragma once

namespace wireshark {

inline constexpr char lua_head[] =
    R"lua(-- Registers of drives in Wireshark. Made by rtuwire from its tables: do not edit.
local drives, known = {}, {}
)lua";

inline constexpr char lua_code[] = R"lua(
local UNIT_PORT, LONGEST_LIST = 1502, 8
local protocol = Proto("rtuwire", "Registers of drives")
local shown = ProtoField.string("rtuwire.registers", "Registers")
local request_frame = ProtoField.framenum("rtuwire.request_frame", "Request", base.NONE, frametype.REQUEST)
local response_time = ProtoField.relative_time("rtuwire.response_time", "Time from request")
protocol.fields = {shown, request_frame, response_time}

local choices = {{1, "none", 0}}
for i, name in ipairs(known) do choices[#choices + 1] = {i + 1, name, i} end
protocol.prefs.drive = Pref.enum("Drive", 0, "The drive of every unit that is not listed below", choices, false)
protocol.prefs.units = Pref.string("Drives of units", "", "7=atv320,3=atv12")

local payload, comment, crc = Field.new("udp.payload"), Field.new("frame.comment"), Field.new("mbrtu.crc16.status")
local last, request_of = {}, {}
function protocol.init() last, request_of = {}, {} end

local functions = {[7] = "Read Exception Status", [11] = "Get Comm. Event Counters", [12] = "Get Comm. Event Log",
                   [17] = "Report Slave ID"}
local exceptions = {"illegal function", "illegal data address", "illegal data value", "server device failure",
                    "acknowledge", "server device busy"}

local function registers_of(unit)
  for number, name in string.gmatch(protocol.prefs.units, "(%d+)%s*=%s*([%w_]+)") do
    if tonumber(number) == unit then return drives[name] end
  end
  return drives[known[protocol.prefs.drive]]
end

-- One register of a unit with its value: "RFR 50.0 Hz".
local function value_text(registers, address, word)
  local register = registers[address]
  if not register then return address .. " " .. word end
  local text
  if register.bits then
    text = string.format("0x%04X", word)
  elseif register.names then
    text = register.names[word] or "#" .. word
  else
    local raw = register.signed and word > 32767 and word - 65536 or word
    text = string.format(register.format, raw * register.step)
  end
  return register.code .. " " .. text
end

local function list(count, text_of)
  local texts = {}
  for i = 0, math.min(count, LONGEST_LIST) - 1 do texts[#texts + 1] = text_of(i) end
  if count > LONGEST_LIST then texts[#texts + 1] = "..." end
  return table.concat(texts, ", ")
end

local function names(registers, start, count)
  return list(count, function(i)
    local register = registers[start + i]
    return register and register.code or tostring(start + i)
  end)
end

-- The values of `count` registers in the bytes from `offset` on; none where there are fewer bytes.
local function values(registers, start, count, bytes, offset)
  if bytes:len() < offset + 2 * count + 2 then return nil end
  return list(count, function(i) return value_text(registers, start + i, bytes:uint(offset + 2 * i, 2)) end)
end

-- What a request asks for, by function: all sizes were looked at by the caller.
local function request_text(registers, code, bytes)
  local start, count = bytes:uint(2, 2), bytes:uint(4, 2)
  if code == 3 then return "read " .. names(registers, start, count) end
  if code == 6 then return "write " .. value_text(registers, start, count) end
  local written
  if code == 16 then
    written = values(registers, start, count, bytes, 7)
    return written and "write " .. written
  end
  if code == 23 and bytes:len() >= 13 then
    written = values(registers, bytes:uint(6, 2), bytes:uint(8, 2), bytes, 11)
    return written and "write " .. written .. "; read " .. names(registers, start, count)
  end
end

-- What a response says, as an answer to its request.
local function response_text(registers, code, bytes, request)
  if code > 128 then return "refused: " .. (exceptions[bytes:uint(2, 1)] or "exception " .. bytes:uint(2, 1)) end
  if code == 6 and bytes:len() == 8 then return value_text(registers, bytes:uint(2, 2), bytes:uint(4, 2)) end
  if code == 16 and bytes:len() == 8 then return "written " .. names(registers, bytes:uint(2, 2), bytes:uint(4, 2)) end
  if (code == 3 or code == 23) and request and request.code == code and bytes:uint(2, 1) == 2 * request.count then
    return values(registers, request.start, request.count, bytes, 3)
  end
end

-- Remembers requests, and returns the one that a response answers.
local function pair(is_request, pinfo, unit, code, bytes)
  if pinfo.visited then return request_of[pinfo.number] end
  if is_request then
    local is_long = bytes:len() >= 8
    last[unit] = unit ~= 0 and {frame = pinfo.number, time = pinfo.abs_ts, code = code,
                                start = is_long and bytes:uint(2, 2), count = is_long and bytes:uint(4, 2)} or nil
  elseif last[unit] and last[unit].code == code % 128 then
    request_of[pinfo.number], last[unit] = last[unit], nil
  end
  return request_of[pinfo.number]
end

local Bytes = {}
Bytes.__index = Bytes
function Bytes:len() return self.data:len() end
function Bytes:uint(offset, size)
  if offset + size > self.data:len() then return 0 end
  local number = 0
  for i = offset, offset + size - 1 do number = number * 256 + self.data:get_index(i) end
  return number
end

local function is_damaged()
  for _, each in ipairs({comment()}) do if tostring(each) == "damaged" then return true end end
  local status = crc()
  return status ~= nil and status.value == 0
end

function protocol.dissector(buffer, pinfo, tree)
  local data = payload()
  local is_request = pinfo.dst_port == UNIT_PORT
  if not data or is_request == (pinfo.src_port == UNIT_PORT) then return end
  local bytes = setmetatable({data = data.value}, Bytes)
  if bytes:len() < 4 or is_damaged() then return end
  local unit, code = bytes:uint(0, 1), bytes:uint(1, 1)
  -- Wireshark leaves out requests of four bytes, which some functions have.
  if is_request and bytes:len() == 4 and functions[code] then
    pinfo.cols.protocol = "Modbus RTU"
    pinfo.cols.info = string.format("   Query: Unit: %3d, Func: %3d: %s", unit, code, functions[code])
  end
  local request = pair(is_request, pinfo, unit, code, bytes)
  local registers, text = registers_of(unit), nil
  if registers and is_request and bytes:len() >= 8 then
    text = request_text(registers, code, bytes)
  elseif registers and not is_request and bytes:len() >= 5 then
    text = response_text(registers, code, bytes, request)
  end
  if not text and not request then return end
  local branch = tree:add(protocol)
  if text then
    branch:add(shown, text)
    pinfo.cols.info:append(" | " .. text)
  end
  if request then
    branch:add(request_frame, request.frame):set_generated()
    local gone = pinfo.abs_ts - request.time
    branch:add(response_time, NSTime(math.floor(gone), math.floor((gone % 1) * 1000000 + 0.5) * 1000)):set_generated()
  end
end

register_postdissector(protocol, true)
)lua";

} // namespace wireshark
