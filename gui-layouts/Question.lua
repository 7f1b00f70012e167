-- Asks what to do with unsaved changes.

local Dialog = require("lodsmith.gui.Dialog")

local Question = {}
Question.__index = Question

local NAMES = {save = "Save", discard = "Discard", cancel = "Cancel"}
local BUTTONS = {"First", "Second", "Third"}

-- answered: function(answer)
function Question.new(kit, parent, behind, answered)
    local self = setmetatable({kit = kit, answered = answered}, Question)
    self.dialog = Dialog.new(kit, parent, behind, "Question", function()
        self:answer("cancel")
    end)
    local buttons = {}
    for index, name in ipairs(BUTTONS) do
        buttons[index] = {name, function()
            self:answer(self.answers[index])
        end}
    end
    self.dialog:addButtons(buttons)
    return self
end

-- question: {title, text, answers = {"save", "discard", "cancel"}}
function Question:ask(question)
    local parts = self.dialog.parts
    self.answers = question.answers
    self.dialog.window:setText(question.title)
    self.kit:setText(parts.QuestionText, question.text)
    for index, name in ipairs(BUTTONS) do
        local answer = question.answers[index]
        parts[name]:setVisible(answer ~= nil)
        self.kit:setText(parts[name], answer and NAMES[answer] or "")
    end
    self.dialog:open(parts[BUTTONS[#question.answers]])
end

function Question:answer(answer)
    self.dialog:close()
    self.answered(answer)
end

return Question
