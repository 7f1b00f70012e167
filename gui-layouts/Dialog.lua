-- A window that has to be answered before anything else: modal, with keys of its own.

local Keyboard = require("lodsmith.gui.Keyboard")

local Dialog = {}
Dialog.__index = Dialog

-- layout: its name; parent: the window that it is in; behind: what has the focus afterwards at the least
-- cancel: what Escape and the button in the title do
function Dialog.new(kit, parent, behind, layout, cancel)
    local self = setmetatable({kit = kit, behind = behind}, Dialog)
    self.window, self.parts = kit:load(layout)
    parent:addChild(self.window)
    self.keyboard = Keyboard.new(kit, self.window)
    local Key = CEGUI.Key
    self.keyboard:shortcut(Key.Escape, false, cancel, true)
    kit:on(self.window, "CloseClicked", cancel)
    self.window:setVisible(false)
    return self
end

-- Buttons in the order of the keyboard: {name, press}
function Dialog:addButtons(buttons)
    for _, button in ipairs(buttons) do
        self.kit:on(self.parts[button[1]], "Clicked", button[2])
        self.keyboard:addButton(self.parts[button[1]], button[2])
    end
end

function Dialog:isOpen()
    return self.window:isVisible()
end

function Dialog:open(focus)
    self.before = CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow():getActiveChild()
    self.window:setVisible(true)
    self.window:setModalState(true)
    self.window:moveToFront()
    self.keyboard:focus(focus)
end

function Dialog:close()
    if self:isOpen() then
        self.window:setModalState(false)
        self.window:setVisible(false)
        self:giveFocusBack()
    end
end

-- Without an active window keys would go nowhere. Another dialog may have opened over this one.
function Dialog:giveFocusBack()
    local before = self.before
    self.before = nil
    if CEGUI.System:getSingleton():getDefaultGUIContext():getModalWindow() then
        return
    end
    if before and CEGUI.WindowManager:getSingleton():isAlive(before) and before:isEffectiveVisible() then
        before:activate()
    else
        self.behind:activate()
    end
end

return Dialog
