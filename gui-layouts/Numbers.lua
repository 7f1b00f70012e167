-- Numbers as people write and read them. No CEGUI in here.

local Numbers = {}

local function trimmed(text)
    return (text:gsub("^%s+", ""):gsub("%s+$", ""))
end

-- A finite decimal number, or nil and what is wrong with the text.
function Numbers.parse(text)
    local plain = trimmed(text)
    if plain == "" then
        return nil, "a number is needed"
    end
    local mantissa = plain:match("^[+-]?([%d.]+)[eE][+-]?%d+$") or plain:match("^[+-]?([%d.]+)$")
    local number = mantissa and tonumber(plain)
    if not number or number ~= number or math.abs(number) == math.huge then
        return nil, "'" .. plain .. "' is not a number"
    end
    return number
end

-- What a 32 bit float holds, without the digits that it does not.
function Numbers.format(number)
    return (("%.7g"):format(number):gsub("e%+0*", "e"))
end

function Numbers.rounded(number, digits)
    return tonumber(("%." .. digits .. "g"):format(number))
end

-- A figure to look at: three digits are enough to compare by.
function Numbers.short(number)
    if number ~= 0 and (math.abs(number) < 1e-4 or math.abs(number) >= 1e6) then
        return ("%.2e"):format(number)
    end
    return ("%.3g"):format(number)
end

-- For a narrow column: whole numbers of up to seven digits, and three or four digits of others.
function Numbers.cell(number)
    local size = math.abs(number)
    if size >= 1000 and size < 9999999.5 then
        return ("%.0f"):format(number)
    end
    return Numbers.format(Numbers.rounded(number, (size < 0.01 or size >= 1000) and 3 or 4))
end

-- A length of a mesh with this radius: what is far below what its coordinates can hold is none.
function Numbers.length(length, radius)
    return length < radius * 1e-6 and "0" or Numbers.short(length)
end

function Numbers.bytes(count)
    if count < 1024 then
        return ("%d B"):format(count)
    elseif count < 1024 * 1024 then
        return ("%.1f KiB"):format(count / 1024)
    end
    return ("%.1f MiB"):format(count / (1024 * 1024))
end

-- Whether two values are the same one, through 32 bit floats and texts.
function Numbers.isSame(a, b)
    return math.abs(a - b) <= 1e-5 * math.max(math.abs(a), math.abs(b))
end

-- Counted nouns: count(1, "level") is "1 level", count(2, "vertex", "vertices") is "2 vertices".
function Numbers.count(number, noun, plural)
    return ("%d %s"):format(number, number == 1 and noun or plural or noun .. "s")
end

return Numbers
