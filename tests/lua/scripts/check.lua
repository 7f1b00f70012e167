-- What tests of the bindings check with.
local check = {}

local function show(value)
    return type(value) == "string" and ("%q"):format(value) or tostring(value)
end

function check.same(expected, actual)
    if expected ~= actual then
        error("expected " .. show(expected) .. ", got " .. show(actual), 2)
    end
end

--- What a function that failed has returned: nil and one message that has `part` in it.
function check.fails(part, ...)
    local result, message = ...
    if result ~= nil or select("#", ...) ~= 2 or type(message) ~= "string" or message == "" then
        error("expected nil and a message, got " .. show(result) .. ", " .. show(message), 2)
    end
    if not message:find(part, 1, true) then
        error("expected " .. show(part) .. " in " .. show(message), 2)
    end
end

--- A call that is a Lua error.
function check.raises(part, call)
    local ok, message = pcall(call)
    if ok then
        error("expected a Lua error", 2)
    end
    if not tostring(message):find(part, 1, true) then
        error("expected " .. show(part) .. " in " .. show(message), 2)
    end
end

--- The mesh of a name.
function check.meshNamed(name)
    for _, mesh in ipairs(lodsmith.meshes()) do
        if mesh:name() == name then
            return mesh
        end
    end
    error("there is no mesh " .. name, 2)
end

--- A definition with levels that keep so many triangles, at 10, 20, 30 ...
function check.levels(...)
    local definition = lodsmith.newDefinition()
    assert(definition:setAutomatic(false))
    for index, triangles in ipairs({ ... }) do
        assert(assert(definition:addLevel(10 * index)):setTarget(lodsmith.Method.Triangles, triangles))
    end
    return definition
end

return check
