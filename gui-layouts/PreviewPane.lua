-- The mesh as it is drawn: view, level, comparison, animation, and the mouse in it.

local Numbers = require("lodsmith.gui.Numbers")
local Words = require("lodsmith.gui.Words")

local PreviewPane = {}
PreviewPane.__index = PreviewPane

-- So near to the split, in pixels, the mouse takes hold of it.
local SPLIT_REACH = 8
local BY_CAMERA, SELECTED, FIRST_LEVEL = 1, 2, 3

function PreviewPane.new(panel, dock)
    local self = setmetatable({panel = panel, kit = panel.kit, state = panel.state, isStale = true}, PreviewPane)
    self.words, self.preview = Words.of(panel.api), panel.preview
    self.shown, self.compareA, self.compareB, self.share = BY_CAMERA, 1, 2, 0.5
    self.compareMode, self.animations = 1, {}
    local window, parts = self.kit:load("PreviewPane")
    dock:addChild(window)
    self.parts = parts
    self.image = parts.PreviewImage
    for _, name in ipairs({"ViewMode", "ShownLevel", "CompareMode", "CompareA", "CompareB", "Animation"}) do
        self[name] = CEGUI.toCombobox(parts[name])
    end
    self.kit:setItems(self.ViewMode, Words.names(self.words.viewModes))
    self.kit:setItems(self.CompareMode, Words.names(self.words.compareModes))
    self:connect()
    self:connectMouse()
    return self
end

function PreviewPane:connect()
    local kit, keyboard, panel = self.kit, self.panel.keyboard, self.panel
    panel:connectCombobox(self.ViewMode, function(index)
        self.state:told(self.preview:setMode(self.words.viewModes[index][1]))
        self.isStale = true
    end)
    local function choice(combobox, field)
        panel:connectCombobox(combobox, function(index)
            self[field] = index
            self.isStale = true
        end)
    end
    choice(self.ShownLevel, "shown")
    local actions = {
        {"SwitchDistance", function() self:viewAtSwitch() end},
        {"ResetCamera", function() self:resetCamera() end},
    }
    for _, action in ipairs(actions) do
        kit:on(self.parts[action[1]], "Clicked", action[2])
        keyboard:addButton(self.parts[action[1]], action[2])
    end
    choice(self.CompareMode, "compareMode")
    choice(self.CompareA, "compareA")
    choice(self.CompareB, "compareB")
    panel:connectCombobox(self.Animation, function(index)
        self.state:told(self.preview:play(index > 1 and self.animations[index - 1] or nil))
        self.isStale = true
    end)
    keyboard:shortcut(CEGUI.Key.D, true, actions[1][2], true)
    self:connectKeys()
    self.state:on("mesh", function()
        self.hasNewMesh = true
    end)
    for _, event in ipairs({"definition", "figures"}) do
        self.state:on(event, function()
            self.isStale = true
        end)
    end
end

function PreviewPane:connectKeys()
    local Key = CEGUI.Key
    local function orbit(x, y)
        return function()
            if self.preview then
                self.preview:orbit(x, y)
            end
        end
    end
    local function zoom(steps)
        return function()
            if self.preview then
                self.preview:zoom(steps)
            end
        end
    end
    self.panel.keyboard:add(self.image, {
        [Key.ArrowLeft] = orbit(-20, 0), [Key.ArrowRight] = orbit(20, 0), [Key.ArrowUp] = orbit(0, -20),
        [Key.ArrowDown] = orbit(0, 20), [Key.PageUp] = zoom(1), [Key.PageDown] = zoom(-1), [Key.Home] = function()
            self:resetCamera()
        end,
    })
end

-- Mouse ---------------------------------------------------------------------------------------------------------------

function PreviewPane:connectMouse()
    local kit, image = self.kit, self.image
    local function mouse(event, handler)
        kit:on(image, event, function(arguments)
            local args = CEGUI.toMouseEventArgs(arguments)
            return handler(self, args.position.x, args.position.y, args.button, args.wheelChange)
        end)
    end
    mouse("MouseButtonDown", self.mouseDown)
    mouse("MouseMove", self.mouseMove)
    mouse("MouseButtonUp", self.endDrag)
    -- The button may come up where nobody tells of it.
    for _, event in ipairs({"InputCaptureLost", "Deactivated"}) do
        kit:on(image, event, function()
            self:endDrag()
            return false
        end)
    end
    mouse("MouseWheel", function(_, _, _, _, change)
        if self.preview then
            self.preview:zoom(change)
        end
    end)
end

function PreviewPane:isComparing()
    return self.preview ~= nil and self.words.compareModes[self.compareMode][1] ~= self.panel.api.CompareMode.Off
end

function PreviewPane:isWipe()
    return self:isComparing() and self.words.compareModes[self.compareMode][1] == self.panel.api.CompareMode.Wipe
end

function PreviewPane:shareAt(x)
    local area = self.image:getUnclippedOuterRect():get()
    return math.max(0, math.min(1, (x - area:left()) / area:getWidth())), area:getWidth()
end

function PreviewPane:mouseDown(x, y, button)
    self.image:activate()
    if not self.preview then
        return
    end
    local share, width = self:shareAt(x)
    local isSplit = self:isWipe() and button == CEGUI.LeftButton and math.abs(share - self.share) * width <= SPLIT_REACH
    self.drag = {x = x, y = y, button = button, isSplit = isSplit}
    self.image:captureInput()
end

function PreviewPane:mouseMove(x, y)
    local drag = self.drag
    if not drag then
        return
    end
    local dx, dy = x - drag.x, y - drag.y
    drag.x, drag.y = x, y
    if drag.isSplit then
        self.share = self:shareAt(x)
        self.isStale = true
    elseif drag.button == CEGUI.LeftButton then
        self.preview:orbit(dx, dy)
    else
        self.preview:pan(dx, dy)
    end
end

function PreviewPane:endDrag()
    if self.drag then
        self.drag = nil
        self.image:releaseInput()
    end
end

-- For scripts ---------------------------------------------------------------------------------------------------------

-- level: a number in the list of levels, 0 for the mesh, "selected", or nil: the camera decides.
function PreviewPane:showLevel(level)
    if level == "selected" then
        self.shown = SELECTED
    else
        self.shown = level and FIRST_LEVEL + level or BY_CAMERA
    end
    self.isStale = true
end

-- mode: of lodsmith.CompareMode; first, second: numbers in the list of levels, 0 for the mesh; share: where the split is
function PreviewPane:compareLevels(mode, first, second, share)
    local _, index = Words.find(self.words.compareModes, mode)
    self.compareMode = index or 1
    self.compareA, self.compareB, self.share = (first or 0) + 1, (second or 0) + 1, share or 0.5
    self.isStale = true
end

-- What to draw --------------------------------------------------------------------------------------------------------

function PreviewPane:resetCamera()
    if self.preview and self.state.mesh then
        self.preview:resetCamera()
    end
end

-- Where the selected level begins, with the camera deciding what is shown.
function PreviewPane:viewAtSwitch()
    local state = self.state
    local row = state.selected and state:row(state.selected)
    if not self.preview or not row then
        state:say("error", "no level is selected")
        return
    end
    if state:told(self.preview:viewAt(state:shownDefinition():strategy(), row.value)) then
        self.shown = BY_CAMERA
        self.isStale = true
    end
end

-- OGRE's number of the index-th of the choices (the mesh, level 1, ...), the last one when there are not as many; nil
-- when the mesh does not have it.
function PreviewPane:ogreLevel(index)
    index = math.min(index, self.state:levelCount() + 1)
    if index == 1 then
        return 0
    end
    local row = self.state:row(index - 1)
    return row and row.ogreLevel
end

function PreviewPane:forcedLevel()
    if self.shown == BY_CAMERA then
        return nil
    elseif self.shown == SELECTED or self.shown >= FIRST_LEVEL + self.state:levelCount() + 1 then
        return self.state.selected and self:ogreLevel(self.state.selected + 1)
    end
    return self:ogreLevel(self.shown - FIRST_LEVEL + 1)
end

function PreviewPane:update()
    if not self.preview then
        self:refreshChoices()
        self.kit:setMessage(self.parts.PreviewNote, "info", "There is no preview without a renderer.")
        return
    end
    if self.hasNewMesh then
        self.hasNewMesh = false
        self:showMesh()
    end
    self:fit()
    if self.isStale then
        self.isStale = false
        self:refreshChoices()
        self:applyChoices()
    end
    self:refreshFigures()
end

function PreviewPane:showMesh()
    local mesh = self.state.mesh
    self.isStale = true
    if not mesh then
        self.preview:clear()
        return
    end
    if self.state:told(self.preview:show(mesh)) then
        self.animations = self.preview:animations()
        self.preview:resetCamera()
    end
end

-- The texture is as large as the widget.
function PreviewPane:fit()
    local size = self.image:getPixelSize()
    local width, height = math.max(1, math.floor(size.width)), math.max(1, math.floor(size.height))
    if width ~= self.width or height ~= self.height then
        self.width, self.height = width, height
        self.preview:resize(width, height)
    end
    local image = self.preview:image()
    if self.image:getProperty("Image") ~= image then
        self.image:setProperty("Image", image)
    end
end

function PreviewPane:refreshChoices()
    local kit, parts = self.kit, self.parts
    local levels = {"The mesh"}
    for index = 1, self.state:levelCount() do
        table.insert(levels, "Level " .. index)
    end
    local shown = {"By camera", "Selected", unpack(levels)}
    local animations = {"At rest", unpack(self.animations)}
    kit:setItems(self.ShownLevel, shown)
    kit:setItems(self.CompareA, levels)
    kit:setItems(self.CompareB, levels)
    kit:setItems(self.Animation, animations)
    local mode = self.preview and select(2, Words.find(self.words.viewModes, self.preview:mode()))
    local animation = 1
    for index, name in ipairs(self.animations) do
        if self.preview:animation() == name then
            animation = index + 1
        end
    end
    kit:chooseInCombobox(self.ViewMode, mode or 1)
    kit:chooseInCombobox(self.ShownLevel, self.shown <= #shown and self.shown or SELECTED)
    kit:chooseInCombobox(self.CompareMode, self.compareMode)
    kit:chooseInCombobox(self.CompareA, math.min(self.compareA, #levels))
    kit:chooseInCombobox(self.CompareB, math.min(self.compareB, #levels))
    kit:chooseInCombobox(self.Animation, animation)
    local isUsable, isComparing = self.preview ~= nil and self.state.mesh ~= nil, self:isComparing()
    kit:setEnabled(parts.ViewMode, isUsable)
    kit:setEnabled(parts.ShownLevel, isUsable and not isComparing)
    kit:setEnabled(parts.SwitchDistance, isUsable and self.state.selected ~= nil)
    kit:setEnabled(parts.ResetCamera, isUsable)
    kit:setEnabled(parts.CompareMode, isUsable)
    kit:setEnabled(parts.CompareA, isUsable and isComparing)
    kit:setEnabled(parts.CompareB, isUsable and isComparing)
    kit:setEnabled(parts.Animation, isUsable and #self.animations > 0)
end

function PreviewPane:applyChoices()
    local split = self.parts.Split
    split:setVisible(self:isComparing())
    if not self.state.mesh then
        return
    end
    local mode = self.words.compareModes[self.compareMode][1]
    local share = self:isWipe() and self.share or 0.5
    if self:isComparing() then
        split:setPosition(CEGUI.UVector2(CEGUI.UDim(share, -2), CEGUI.UDim(0, 0)))
        self.preview:compare(mode, self:ogreLevel(self.compareA) or 0, self:ogreLevel(self.compareB) or 0, share)
    else
        self.preview:compare(mode, 0, 0, share)
        self.preview:setLevel(self:forcedLevel())
    end
end

function PreviewPane:refreshFigures()
    local state, text = self.state, ""
    if state.mesh then
        local level, figures = self.preview:shownLevel(), state.info
        for _, row in ipairs(state:rows()) do
            if row.ogreLevel == level then
                figures = row
            end
        end
        local vertices = figures == state.info and figures.uniqueVertices or figures.vertices
        text = ("%s: %d triangles, %s, %s, %s away"):format(level == 0 and "The mesh" or "Level " .. level,
            self.preview:triangles(), Numbers.count(vertices or 0, "vertex", "vertices"),
            Numbers.count(figures.indices or 0, "index", "indices"), Numbers.short(self.preview:distance()))
    end
    self.kit:setText(self.parts.PreviewFigures, text)
    self:refreshLegend()
    self.kit:setText(self.parts.PreviewNote, state.mesh and self.preview:note() or "Choose a mesh on the left.")
end

-- What the colours of the deviation mean.
function PreviewPane:refreshLegend()
    local parts = self.parts
    local isShown = self.state.mesh ~= nil and self.preview:mode() == self.panel.api.ViewMode.Deviation
    parts.Legend:setVisible(isShown)
    parts.LegendText:setVisible(isShown)
    if isShown then
        local scale, message = self.preview:deviationScale()
        self.kit:setText(parts.LegendText,
            scale and "0 to " .. Numbers.short(scale) .. " and more" or message or "Measuring ...")
        local image = self.preview:legend()
        if parts.Legend:getProperty("Image") ~= image then
            parts.Legend:setProperty("Image", image)
        end
    end
end

return PreviewPane
