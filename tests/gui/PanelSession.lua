-- The panel over stand-ins, and shortcuts to its windows.

local FakeLodsmith = require("FakeLodsmith")
local FakePreview = require("FakePreview")

local PanelSession = {}
PanelSession.__index = PanelSession

-- options: {host, fill, noPreview, graphError}
function PanelSession.open(options)
    options = options or {}
    local self = setmetatable({api = FakeLodsmith.new()}, PanelSession)
    if not options.noPreview then
        self.preview = FakePreview.new(self.api)
        self.api.preview = self.preview
        self.api.newGraph = function(name)
            self.graphName, self.graph = name, not options.graphError and FakePreview.newGraph() or nil
            return self.graph, options.graphError
        end
    end
    lodsmith = self.api
    self.panel = require("lodsmith.gui.AssetsManager").open({
        fill = options.fill ~= false, preview = self.preview, host = options.host or {canOpen = true},
    })
    self.state = self.panel.state
    self.parts = {}
    for _, pane in ipairs(self.panel.panes) do
        self:take(pane.parts)
    end
    self:take(self.panel.parts)
    for _, dialog in ipairs(self.panel.dialogs) do
        self:take(dialog.parts)
    end
    self:frame()
    return self
end

function PanelSession:take(parts)
    for name, window in pairs(parts) do
        self.parts[name] = window
    end
end

function PanelSession:frame(seconds)
    self.panel:update(seconds or 0.01)
    CEGUI.System:getSingleton():getDefaultGUIContext():injectTimePulse(seconds or 0.01)
end

function PanelSession:message()
    return self.parts.Message:getText()
end

-- The castle with manual levels at these distances.
function PanelSession:withLevels(...)
    local definition = self.api.newDefinition()
    definition:setAutomatic(false)
    for _, value in ipairs({...}) do
        definition:addLevel(value)
    end
    self.api.files["castle.mesh"] = definition
    self.panel:chooseMesh(self.api.known[1])
    self:frame()
    return self
end

function PanelSession:finish()
    self.api.queue:finish(self.state.mesh)
    self:frame()
end

return PanelSession
