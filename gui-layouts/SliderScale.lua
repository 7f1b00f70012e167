-- From a slider's position, 0 to 1, to the amount of a reduction method, and back. No CEGUI in here.

local Numbers = require("lodsmith.gui.Numbers")

local SliderScale = {}

-- Deviations that matter are far below the radius: an even scale would have them all in its first hundredth.
local LENGTH_POWER = 4

local function scale(maximum, power, digits)
    return {
        maximum = maximum,
        toAmount = function(position)
            local amount = maximum * math.min(math.max(position, 0), 1) ^ power
            return digits and Numbers.rounded(amount, digits) or math.floor(amount + 0.5)
        end,
        toPosition = function(amount)
            if maximum <= 0 then
                return 0
            end
            return (math.min(math.max(amount / maximum, 0), 1)) ^ (1 / power)
        end,
    }
end

-- The scale of a method (lodsmith.Method) for a mesh (what info() tells).
function SliderScale.of(method, methods, info)
    if method == methods.Proportional then
        return scale(1, 1, 3)
    elseif method == methods.Constant then
        return scale(info.uniqueVertices, 1)
    elseif method == methods.Triangles then
        return scale(info.triangles, 1)
    end
    return scale(info.radius, LENGTH_POWER, 3)
end

return SliderScale
