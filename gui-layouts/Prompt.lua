-- Asks for a value, and says beside the box what is wrong with it.

local Dialog = require("lodsmith.gui.Dialog")

local Prompt = {}
Prompt.__index = Prompt

function Prompt.new(kit, parent, behind)
    local self = setmetatable({kit = kit}, Prompt)
    local function cancel()
        self.dialog:close()
    end
    local function accept()
        self:accept()
    end
    self.dialog = Dialog.new(kit, parent, behind, "Prompt", cancel)
    self.box = self.dialog.parts.PromptValue
    kit:on(self.box, "TextChanged", function()
        self:validate()
    end)
    kit:on(self.box, "TextAccepted", accept)
    self.dialog.keyboard:addText(self.box)
    self.dialog:addButtons({{"Accept", accept}, {"Dismiss", cancel}})
    return self
end

-- options: {title, text, value, check = function(text) -> value | nil, message; accept = the same}
function Prompt:ask(options)
    self.options = options
    self.dialog.window:setText(options.title)
    self.kit:setText(self.dialog.parts.PromptText, options.text)
    self.kit:setText(self.box, options.value)
    self:validate()
    self.dialog:open(self.box)
end

function Prompt:mark(message)
    local skin = self.kit:skinOf(self.box)
    self.kit:setColour(self.box, "NormalTextColour", message and skin.error or skin.text)
    self.kit:setMessage(self.dialog.parts.PromptError, "error", message or "")
end

function Prompt:validate()
    local valid, message = self.options.check(self.box:getText())
    self:mark(not valid and message or nil)
    return valid
end

-- The box stays until what is in it can be.
function Prompt:accept()
    if not self:validate() then
        return
    end
    local done, message = self.options.accept(self.box:getText())
    if done then
        self.dialog:close()
    else
        self:mark(message)
    end
end

return Prompt
