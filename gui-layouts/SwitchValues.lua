-- What a level's value becomes under another strategy, so that it is shown from about the same place on: as a camera
-- with an opening angle of 45 degrees sees it on a screen of 1920 x 1080 pixels. No CEGUI in here.

local SwitchValues = {}

local WIDTH, HEIGHT = 1920, 1080
local PIXELS_PER_TANGENT = HEIGHT / 2 / math.tan(math.rad(45) / 2)

local function isDistance(strategies, strategy)
    return strategy == strategies.DistanceSphere or strategy == strategies.DistanceBox
end

SwitchValues.isDistance = isDistance

local function toPixels(strategies, strategy, value, radius)
    if strategy == strategies.PixelCount then
        return value
    elseif strategy == strategies.ScreenRatioPixelCount then
        return value * WIDTH * HEIGHT
    end
    -- The value is the length of a tangent to the bounding sphere.
    return math.pi * (radius * PIXELS_PER_TANGENT) ^ 2 / (value ^ 2 + radius ^ 2)
end

local function fromPixels(strategies, strategy, pixels, radius)
    if strategy == strategies.PixelCount then
        return pixels
    elseif strategy == strategies.ScreenRatioPixelCount then
        return pixels / (WIDTH * HEIGHT)
    end
    local squared = math.pi * (radius * PIXELS_PER_TANGENT) ^ 2 / pixels - radius ^ 2
    -- More pixels than there are with the camera at the sphere: as near as can be.
    return math.sqrt(math.max(squared, (radius * 1e-3) ^ 2))
end

function SwitchValues.convert(strategies, from, to, value, radius)
    if from == to or (isDistance(strategies, from) and isDistance(strategies, to)) then
        return value
    end
    return fromPixels(strategies, to, toPixels(strategies, from, value, radius), radius)
end

-- A value for a level beyond the last one: there the mesh is half as large on screen.
function SwitchValues.beyond(strategies, strategy, last, radius)
    if last then
        return isDistance(strategies, strategy) and last * 2 or last / 4
    end
    local first = 100000
    if strategy == strategies.PixelCount then
        return first
    end
    return SwitchValues.convert(strategies, strategies.PixelCount, strategy, first, radius)
end

return SwitchValues
