-- Where deviation against triangles lies in the graph: both axes logarithmic, 0 to 1, y upwards. No CEGUI in here.

local GraphScale = {}
GraphScale.__index = GraphScale

-- Deviations smaller than the greatest by more than this are on the lower edge: none of them is seen.
local DEVIATION_SPAN = 1e4

local function widen(range, value)
    if value > 0 then
        range.least = math.min(range.least or value, value)
        range.most = math.max(range.most or value, value)
    end
end

local function place(range, value)
    if not range.least or range.most <= range.least then
        return 0.5
    end
    local share = math.log(math.max(value, range.least) / range.least) / math.log(range.most / range.least)
    return math.min(share, 1)
end

-- points: lists of {triangles, deviation}. Without deviation a point lies on the lower edge.
function GraphScale.new(points)
    local self = setmetatable({triangles = {}, deviation = {}}, GraphScale)
    for _, point in ipairs(points) do
        widen(self.triangles, point.triangles)
        widen(self.deviation, point.deviation)
    end
    if self.deviation.least then
        self.deviation.least = math.max(self.deviation.least, self.deviation.most / DEVIATION_SPAN)
    end
    return self
end

function GraphScale:isEmpty()
    return self.triangles.least == nil
end

function GraphScale:x(triangles)
    return place(self.triangles, triangles)
end

function GraphScale:y(deviation)
    return deviation > 0 and place(self.deviation, deviation) or 0
end

local function decades(range)
    local places = {}
    if range.least and range.most > range.least then
        for power = math.ceil(math.log10(range.least)), math.floor(math.log10(range.most)) do
            table.insert(places, place(range, 10 ^ power))
        end
    end
    return places
end

-- Where powers of ten lie: lists of x and of y.
function GraphScale:ticks()
    return decades(self.triangles), decades(self.deviation)
end

-- The nearest of places {x, y}, in a picture of this size, to a place in it; nil when none is within `reach` pixels.
function GraphScale.nearest(places, x, y, width, height, reach)
    local best, bestDistance
    for key, place in pairs(places) do
        local distance = math.sqrt(((place.x - x) * width) ^ 2 + ((place.y - y) * height) ^ 2)
        if distance <= reach and (not bestDistance or distance < bestDistance) then
            best, bestDistance = key, distance
        end
    end
    return best
end

return GraphScale
