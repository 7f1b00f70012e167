-- An edit box for a value of the state: what is typed counts with Enter or when the box is left, Escape takes it
-- back, and what cannot be is marked while it is typed.

local Field = {}
Field.__index = Field

-- options: {check = function(text) -> true | nil, message; commit = function(text) -> true | nil, message;
--           tell = function(message or nil), called when what is wrong changes}
function Field.new(kit, keyboard, window, options)
    local self = setmetatable({kit = kit, window = window, options = options, shown = ""}, Field)
    kit:on(window, "TextChanged", function()
        self:validate()
    end)
    kit:on(window, "TextAccepted", function()
        self:commit()
    end)
    kit:on(window, "Deactivated", function()
        self:commit()
        return false
    end)
    keyboard:addText(window, {
        [CEGUI.Key.Escape] = function()
            self:revert()
        end,
    })
    return self
end

function Field:isTouched()
    return self.window:getText() ~= self.shown
end

function Field:mark(message)
    self.message = message
    local skin = self.kit:skinOf(self.window)
    self.kit:setColour(self.window, "NormalTextColour", message and skin.error or skin.text)
    self.options.tell()
end

function Field:validate()
    if not self:isTouched() then
        self:mark(nil)
        return true
    end
    local valid, message = self.options.check(self.window:getText())
    self:mark(not valid and message or nil)
    return valid
end

function Field:commit()
    if not self:isTouched() or not self:validate() then
        return
    end
    local text = self.window:getText()
    local done, message = self.options.commit(text)
    if done then
        self.shown = text
    end
    self:mark(not done and message or nil)
end

function Field:revert()
    self.kit:setText(self.window, self.shown)
    self:mark(nil)
end

-- Shows what the state has. key: what the value belongs to; half-typed text outlives a refresh, but not another key.
function Field:refresh(key, text)
    if key == self.key and (self.message or (self.window:isActive() and self:isTouched())) then
        return
    end
    self.key, self.shown = key, text
    self:revert()
end

return Field
