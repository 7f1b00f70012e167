-- Work without a mouse: the order of the controls, and what keys do in each. CEGUI itself has neither.

local Keyboard = {}
Keyboard.__index = Keyboard

local Key = CEGUI.Key
local SHIFT, CONTROL = 4, 8 -- bits of KeyEventArgs.sysKeys

local function holds(systemKeys, bit)
    return math.floor(systemKeys / bit) % 2 == 1
end

-- kit: Kit; scope: the window whose keys these are
function Keyboard.new(kit, scope)
    local self = setmetatable({kit = kit, controls = {}, shortcuts = {}}, Keyboard)
    kit:on(scope, "KeyDown", function(arguments)
        local key = CEGUI.toKeyEventArgs(arguments)
        return self:press(key.scancode, holds(key.sysKeys, CONTROL), holds(key.sysKeys, SHIFT))
    end)
    return self
end

-- Adds a control at the end of the order. keys: a table of functions by key; those that return false leave the key to
-- CEGUI.
function Keyboard:add(window, keys)
    table.insert(self.controls, {window = window, keys = keys or {}})
end

function Keyboard:addButton(window, press)
    self:add(window, {[Key.Return] = press, [Key.NumpadEnter] = press, [Key.Space] = press})
end

-- list: Listbox or MultiColumnList; move: function(step); accept: what Enter does, or nil
function Keyboard:addList(window, move, accept)
    local function by(step)
        return function()
            move(step)
        end
    end
    self:add(window, {
        [Key.ArrowUp] = by(-1), [Key.ArrowDown] = by(1), [Key.PageUp] = by(-10), [Key.PageDown] = by(10),
        [Key.Home] = by(-math.huge), [Key.End] = by(math.huge), [Key.Return] = accept, [Key.NumpadEnter] = accept,
    })
end

-- What keys do wherever the focus is. Where keys is a text's own key too, the text has it.
function Keyboard:shortcut(key, isControl, action, isForTextToo)
    table.insert(self.shortcuts, {key = key, isControl = isControl, action = action, isForTextToo = isForTextToo})
end

function Keyboard:focused()
    for index, control in ipairs(self.controls) do
        if control.window:isActive() then
            return control, index
        end
    end
    return nil
end

local function isText(control)
    return control ~= nil and control.isText
end

-- An edit box: has its own keys, and CEGUI keeps Tab from those around it.
function Keyboard:addText(window, keys)
    self:add(window, keys)
    self.controls[#self.controls].isText = true
    self.kit:on(window, "KeyDown", function(arguments)
        local key = CEGUI.toKeyEventArgs(arguments)
        if key.scancode ~= Key.Tab then
            return false
        end
        return self:press(Key.Tab, false, holds(key.sysKeys, SHIFT))
    end)
end

-- Whether the key was used up.
function Keyboard:press(key, isControl, isShift)
    local control = self:focused()
    for _, shortcut in ipairs(self.shortcuts) do
        local isMeant = shortcut.key == key and shortcut.isControl == isControl
        if isMeant and (shortcut.isForTextToo or not isText(control)) then
            return shortcut.action(isShift) ~= false
        end
    end
    if key == Key.A and isControl and isText(control) then
        Keyboard.selectAll(control.window)
        return true
    end
    if key == Key.Tab then
        self:move(isShift and -1 or 1)
        return true
    end
    local action = control and not isControl and control.keys[key]
    if not action then
        return false
    end
    return action() ~= false
end

local function takesFocus(window)
    return window:isEffectiveVisible() and not window:isEffectiveDisabled()
end

-- The focus goes on by one control, and round at the end.
function Keyboard:move(step)
    local _, index = self:focused()
    local count = #self.controls
    index = index or (step > 0 and count or 1)
    for _ = 1, count do
        index = (index - 1 + step) % count + 1
        local control = self.controls[index]
        if takesFocus(control.window) then
            self:focus(control.window)
            return
        end
    end
end

function Keyboard.selectAll(window)
    local box = CEGUI.toEditbox(window)
    box:setSelection(0, #box:getText())
end

function Keyboard:focus(window)
    window:activate()
    if window:getType():find("Editbox") then
        Keyboard.selectAll(window)
    end
    self:frame(window)
end

-- A frame around what the keys have led to, beside which CEGUI shows nothing for most controls.
function Keyboard:frame(window)
    if not self.mark then
        self.mark = CEGUI.WindowManager:getSingleton():createWindow("Lodsmith/StaticText", "KeyboardFocus")
        self.mark:setProperty("BackgroundEnabled", "false")
        self.mark:setMousePassThroughEnabled(true)
        self.kit:setColour(self.mark, "FrameColours", self.kit:skinOf(window).focus)
    end
    window:getParent():addChild(self.mark)
    local area = window:getArea()
    local width, height = window:getPixelSize().width, window:getPixelSize().height
    if window:getType():find("Combobox") then
        height = CEGUI.toCombobox(window):getEditbox():getPixelSize().height
    end
    self.mark:setPosition(CEGUI.UVector2(CEGUI.UDim(area.min.x.scale, area.min.x.offset - 2),
        CEGUI.UDim(area.min.y.scale, area.min.y.offset - 2)))
    self.mark:setSize(CEGUI.USize(CEGUI.UDim(0, width + 4), CEGUI.UDim(0, height + 4)))
    self.mark:setVisible(true)
    self.framed = window
end

-- Once a frame: the mark goes when the mouse has taken the focus elsewhere.
function Keyboard:update()
    if self.framed and not self.framed:isActive() then
        self.mark:setVisible(false)
        self.framed = nil
    end
end

return Keyboard
