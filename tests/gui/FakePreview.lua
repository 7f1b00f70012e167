-- A stand-in for lodsmith.preview that remembers what it was told.

local FakePreview = {}
FakePreview.__index = FakePreview

function FakePreview.new(api)
    return setmetatable({api = api, viewMode = api.ViewMode.Shaded, orbits = {}, pans = {}, zooms = 0}, FakePreview)
end

function FakePreview:show(mesh) self.shownMesh = mesh return true end
function FakePreview:clear() self.shownMesh = nil end
function FakePreview:mesh() return self.shownMesh end
function FakePreview:setLevel(level) self.level = level return true end
function FakePreview:shownLevel() return self.level or 0 end
function FakePreview:triangles() return 321 end
function FakePreview:setMode(mode)
    if self.refusal then
        return nil, self.refusal
    end
    self.viewMode = mode
    return true
end
function FakePreview:mode() return self.viewMode end
function FakePreview:compare(mode, a, b, share)
    self.compared = {mode = mode, a = a, b = b, share = share}
    return true
end
function FakePreview:orbit(dx, dy) table.insert(self.orbits, {dx, dy}) end
function FakePreview:pan(dx, dy) table.insert(self.pans, {dx, dy}) end
function FakePreview:zoom(steps) self.zooms = self.zooms + steps end
function FakePreview:resetCamera() self.resets = (self.resets or 0) + 1 end
function FakePreview:distance() return 42 end
function FakePreview:viewAt(strategy, value) self.viewedAt = {strategy, value} return true end
function FakePreview:resize(width, height) self.width, self.height = width, height end
function FakePreview:image() return "" end
function FakePreview:legend() return "" end
function FakePreview:note() return self.remark or "" end
function FakePreview:animations() return {"walk", "run"} end
function FakePreview:play(name) self.played = name return true end
function FakePreview:animation() return self.played end
function FakePreview:setSpeed() end
function FakePreview:deviationScale() return self.scale end

-- A stand-in for lodsmith.newGraph(name).
function FakePreview.newGraph()
    local graph = {draws = 0}
    function graph:image() return "" end
    function graph:margin() return 7 end
    function graph:setTicks(upright, level) self.upright, self.level = upright, level end
    function graph:resize(width, height) self.width, self.height = width, height end
    function graph:setCurve(points) self.curve = points end
    function graph:setMarkers(markers) self.markers = markers end
    function graph:draw() self.draws = self.draws + 1 end
    return graph
end

return FakePreview
