local Expect = require("Expect")
local Numbers = require("lodsmith.gui.Numbers")

local Tests = {}

function Tests.parsesDecimals()
    local numbers = {["1"] = 1, [" 2.5 "] = 2.5, ["-3"] = -3, ["1e3"] = 1000, [".5"] = 0.5, ["+4E-1"] = 0.4}
    for text, number in pairs(numbers) do
        Expect.equal(Numbers.parse(text), number)
    end
end

function Tests.refusesWhatIsNoNumber()
    for _, text in ipairs({"abc", "1,5", "0x10", "nan", "inf", "-inf", "1e999", "1.2.3", "1 2", "e5", "."}) do
        Expect.refused("is not a number", Numbers.parse(text))
    end
    Expect.refused("a number is needed", Numbers.parse("  "))
end

function Tests.formatsFloatsWithoutTheirNoise()
    Expect.equal(Numbers.format(0.10000000149011612), "0.1")
    Expect.equal(Numbers.format(8000000), "8000000")
    Expect.equal(Numbers.format(1e18), "1e18")
    Expect.equal(Numbers.parse(Numbers.format(1e18)), 1e18)
end

function Tests.shortFiguresAndBytes()
    Expect.equal(Numbers.short(0), "0")
    Expect.equal(Numbers.short(0.012345), "0.0123")
    Expect.equal(Numbers.short(0.0000123), "1.23e-05")
    Expect.equal(Numbers.bytes(1023), "1023 B")
    Expect.equal(Numbers.bytes(1536), "1.5 KiB")
    Expect.equal(Numbers.bytes(3 * 1024 * 1024), "3.0 MiB")
end

function Tests.countsHavePlurals()
    Expect.equal(Numbers.count(1, "triangle"), "1 triangle")
    Expect.equal(Numbers.count(0, "vertex", "vertices"), "0 vertices")
end

function Tests.narrowColumnsHaveFewDigits()
    for number, text in pairs({
        [0.000720397] = "0.00072", [0.0000720397] = "7.2e-05", [0.96875] = "0.9688", [20.12345] = "20.12", [0] = "0",
        [1234.56] = "1235", [200000] = "200000", [1234567] = "1234567", [12345678] = "1.23e7", [1] = "1",
    }) do
        Expect.equal(Numbers.cell(number), text)
    end
end

return Tests
