-- The list of meshes, and what there is to know of the one that was chosen.

local Numbers = require("lodsmith.gui.Numbers")

local MeshPane = {}
MeshPane.__index = MeshPane

-- panel: {kit, keyboard, state, api, host}; dock: the window to fill
function MeshPane.new(panel, dock)
    local self = setmetatable({panel = panel, kit = panel.kit, state = panel.state, isStale = true}, MeshPane)
    local window, parts = self.kit:load("MeshPane")
    dock:addChild(window)
    self.parts, self.list = parts, CEGUI.toListbox(parts.MeshList)
    self:connect()
    return self
end

function MeshPane:connect()
    local kit, parts, keyboard, state = self.kit, self.parts, self.panel.keyboard, self.state
    parts.Open:setVisible(self.panel.host.canOpen == true)
    kit:on(parts.Open, "Clicked", function()
        self.panel:askForFile()
    end)
    kit:on(parts.MeshFilter, "TextChanged", function()
        self.isStale = true
    end)
    kit:on(self.list, "SelectionChanged", function()
        local index = kit.chosen(self.list)
        if index then
            self:chooseIndex(index)
        end
    end)
    keyboard:addButton(parts.Open, function()
        self.panel:askForFile()
    end)
    keyboard:addText(parts.MeshFilter)
    keyboard:addList(self.list, function(step)
        local count = #self.meshes
        if count > 0 then
            local index = (self:chosenIndex() or (step > 0 and 0 or count + 1)) + step
            self:chooseIndex(math.max(1, math.min(count, index)))
        end
    end)
    for _, event in ipairs({"mesh", "figures"}) do
        state:on(event, function()
            self.isStale = true
        end)
    end
end

function MeshPane:chooseIndex(index)
    local mesh = self.meshes[index]
    if mesh then
        self.state:told(self.state:chooseMesh(mesh))
    end
    -- Whatever became of it, the list shows the mesh that is edited.
    self.isStale = true
end

function MeshPane:chosenIndex()
    for index, mesh in ipairs(self.meshes) do
        if self.state.mesh and self.state.mesh:equals(mesh) then
            return index
        end
    end
    return nil
end

-- Meshes come and go in the program: looked at once a second.
function MeshPane:update(seconds)
    self.age = (self.age or 0) + seconds
    if self.isStale or self.age >= 1 then
        self.isStale, self.age = false, 0
        self:refresh()
    end
end

function MeshPane:refresh()
    self.meshes = self.state:meshes(self.parts.MeshFilter:getText())
    local names = {}
    for index, mesh in ipairs(self.meshes) do
        names[index] = mesh:name()
    end
    self.kit:setItems(self.list, names)
    self.kit:choose(self.list, self:chosenIndex())
    self.kit:setText(self.parts.Info, self.state.mesh and MeshPane.describe(self.state) or "No mesh is chosen.")
end

local function describeSubMesh(index, subMesh)
    local name = subMesh.name ~= "" and subMesh.name or "submesh " .. (index - 1)
    return ("%s: %s, %s, %s%s, %d bit indices"):format(name, subMesh.material,
        Numbers.count(subMesh.triangles, "triangle"), Numbers.count(subMesh.vertices, "vertex", "vertices"),
        subMesh.shared and " (shared)" or "", subMesh.indexBytes * 8)
end

function MeshPane.describe(state)
    local info = state.info
    local lines = {
        state.mesh:name(),
        "Group " .. state.mesh:group(),
        Numbers.count(info.triangles, "triangle") .. ", " .. Numbers.count(info.indices, "index", "indices"),
        Numbers.count(info.uniqueVertices, "unique vertex", "unique vertices"),
        Numbers.count(info.vertices, "buffer vertex", "buffer vertices") .. ", " .. Numbers.bytes(info.bytes),
        ("Size %s x %s x %s, radius %s"):format(Numbers.short(info.size.x), Numbers.short(info.size.y),
            Numbers.short(info.size.z), Numbers.short(info.radius)),
        "Edge lists: " .. (info.edgeLists and "yes" or "no"),
    }
    if info.skeleton then
        table.insert(lines, "Skeleton " .. info.skeleton)
    end
    if info.animations > 0 or info.poses > 0 then
        table.insert(lines, Numbers.count(info.animations, "animation") .. ", " .. Numbers.count(info.poses, "pose"))
    end
    table.insert(lines, Numbers.count(#info.submeshes, "submesh", "submeshes"))
    for index, subMesh in ipairs(info.submeshes) do
        table.insert(lines, describeSubMesh(index, subMesh))
    end
    for _, note in ipairs(info.notes) do
        table.insert(lines, note)
    end
    return table.concat(lines, "\n")
end

return MeshPane
