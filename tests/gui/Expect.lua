-- What tests assert.

local Expect = {}

function Expect.equal(actual, expected)
    if actual ~= expected then
        error(("expected %s, got %s"):format(tostring(expected), tostring(actual)), 2)
    end
end

function Expect.near(actual, expected, tolerance)
    if math.abs(actual - expected) > tolerance then
        error(("expected %g to within %g, got %g"):format(expected, tolerance, actual), 2)
    end
end

function Expect.yes(condition, ...)
    if not condition then
        error("expected something true; " .. tostring((...)), 2)
    end
end

function Expect.no(condition)
    if condition then
        error("expected nil or false, got " .. tostring(condition), 2)
    end
end

-- What a function returned is nil and a reason that holds the text.
function Expect.refused(text, result, message)
    if result or not message or not message:find(text, 1, true) then
        error(("expected nil and '%s', got %s and %s"):format(text, tostring(result), tostring(message)), 2)
    end
end

return Expect
