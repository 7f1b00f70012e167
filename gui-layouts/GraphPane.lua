-- The graph of deviation against triangles in the definition's pane, with the levels as marks.

local GraphScale = require("lodsmith.gui.GraphScale")
local LevelFigures = require("lodsmith.gui.LevelFigures")
local Numbers = require("lodsmith.gui.Numbers")

local GraphPane = {}
GraphPane.__index = GraphPane

local REACH = 12

-- Graphs have names of their own: that of a closed panel lives until its garbage is collected.
local graphs = 0

-- parts: windows of the definition's pane
function GraphPane.new(panel, parts)
    local self = setmetatable({panel = panel, kit = panel.kit, state = panel.state, parts = parts}, GraphPane)
    self.isStale, self.marks = true, {}
    if panel.api.newGraph then
        self:makeGraph()
    end
    self.kit:on(parts.Graph, "MouseButtonDown", function(arguments)
        local mouse = CEGUI.toMouseEventArgs(arguments)
        return self:click(mouse.position.x, mouse.position.y)
    end)
    for _, event in ipairs({"mesh", "definition", "figures", "curve"}) do
        self.state:on(event, function()
            self.isStale = true
        end)
    end
    return self
end

function GraphPane:makeGraph()
    graphs = graphs + 1
    local graph, message = self.panel.api.newGraph("LodsmithPanelGraph" .. graphs)
    if graph then
        self.graph = graph
    else
        self.state:say("error", "There is no graph: " .. message)
    end
end

function GraphPane:click(x, y)
    if not self.graph then
        return
    end
    local area, margin = self.parts.Graph:getUnclippedOuterRect():get(), self.graph:margin()
    local width, height = area:getWidth() - 2 * margin, area:getHeight() - 2 * margin
    local shareX, shareY = (x - area:left() - margin) / width, 1 - (y - area:top() - margin) / height
    local index = GraphScale.nearest(self.marks, shareX, shareY, width, height, REACH)
    if index then
        self.state:select(index)
    end
end

function GraphPane:update()
    if not self.graph then
        return
    end
    local size = self.parts.Graph:getPixelSize()
    local width, height = math.floor(size.width), math.floor(size.height)
    if width ~= self.width or height ~= self.height then
        self.width, self.height = width, height
        self.graph:resize(math.max(width, 1), math.max(height, 1))
        self.isStale = true
    end
    if self.isStale then
        self.isStale = false
        self:refresh()
    end
end

function GraphPane:refresh()
    local points = {}
    for _, point in ipairs(self.state.curve or {}) do
        table.insert(points, point)
    end
    local levels = {}
    for _, row in ipairs(self.state:rows()) do
        local deviation = LevelFigures.deviationOf(row)
        if row.triangles and deviation then
            levels[row.index] = {triangles = row.triangles, deviation = deviation}
            table.insert(points, levels[row.index])
        end
    end
    local scale = GraphScale.new(points)
    self:draw(scale, levels)
    self:label(scale)
end

function GraphPane:draw(scale, levels)
    local curve, markers = {}, {}
    for _, point in ipairs(self.state.curve or {}) do
        if point.deviation > 0 then
            table.insert(curve, {scale:x(point.triangles), scale:y(point.deviation)})
        end
    end
    self.marks = {}
    for index, level in pairs(levels) do
        local x, y = scale:x(level.triangles), scale:y(level.deviation)
        self.marks[index] = {x = x, y = y}
        table.insert(markers, {x, y, selected = index == self.state.selected})
    end
    self.graph:setCurve(curve)
    self.graph:setMarkers(markers)
    self.graph:setTicks(scale:ticks())
    self.graph:draw()
    local image = self.graph:image()
    if self.parts.Graph:getProperty("Image") ~= image then
        self.parts.Graph:setProperty("Image", image)
    else
        self.parts.Graph:invalidate()
    end
end

function GraphPane:label(scale)
    local text = ""
    if self.state.mesh and self.state.curveJob then
        text = "Computing the curve ..."
    elseif not scale:isEmpty() and scale.deviation.least then
        text = ("%d to %d triangles, %s to %s"):format(scale.triangles.least, scale.triangles.most,
            Numbers.short(scale.deviation.least), Numbers.short(scale.deviation.most))
    end
    self.kit:setText(self.parts.GraphAxis, text)
end

return GraphPane
