-- Every handler of the panel runs in here: an error in one is told, and nothing else happens.

local Guard = {}
Guard.__index = Guard

-- tell: function(message), called for each error
function Guard.new(tell)
    return setmetatable({tell = tell}, Guard)
end

-- Calls handler(...); its first result, or nil after an error.
function Guard:call(what, handler, ...)
    local arguments, count = {...}, select("#", ...)
    local passed, result = xpcall(function()
        return handler(unpack(arguments, 1, count))
    end, function(message)
        return debug.traceback(tostring(message), 2)
    end)
    if passed then
        return result
    end
    -- Whoever is told may be broken too, and CEGUI must not hear of it.
    pcall(self.tell, what .. ": " .. result)
    return nil
end

function Guard:wrap(what, handler)
    return function(...)
        return self:call(what, handler, ...)
    end
end

return Guard
