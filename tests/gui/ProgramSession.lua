-- The panel over OGRE and the bindings, in a program without a window.

local ProgramSession = {}
ProgramSession.__index = ProgramSession
setmetatable(ProgramSession, {__index = require("PanelSession")})

local SECONDS = 60

function ProgramSession.open()
    local self = setmetatable({api = lodsmith, parts = {}}, ProgramSession)
    self.panel = require("lodsmith.gui.AssetsManager").open({fill = true, host = {canOpen = true}})
    self.state = self.panel.state
    for _, part in ipairs({self.panel, unpack(self.panel.panes)}) do
        self:take(part.parts or {})
    end
    for _, dialog in ipairs(self.panel.dialogs) do
        self:take(dialog.parts)
    end
    self:frame()
    return self
end

function ProgramSession:openSample(name)
    self.path = takeSample(name)
    local opened, message = self.panel:openMesh(self.path)
    if not opened then
        error(message, 2)
    end
    self:settle()
    return self
end

-- Frames until a condition holds.
function ProgramSession:wait(what, condition)
    local until_ = os.time() + SECONDS
    while not condition() do
        if os.time() > until_ then
            error("waited in vain for " .. what .. "; " .. self:message(), 2)
        end
        ogreFrame()
        self:frame(0.01)
    end
    self:frame()
end

-- Until nothing is generated.
function ProgramSession:settle()
    self:wait("generation", function()
        return not self.state:isGenerating()
    end)
end

return ProgramSession
