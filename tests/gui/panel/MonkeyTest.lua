local Expect = require("Expect")
local Hand = require("Hand")

local EVENTS = 600

local function press()
    local names = {"Tab", "Return", "Escape", "Space", "Delete", "Insert", "ArrowUp", "ArrowDown", "ArrowLeft",
        "ArrowRight", "Home", "End", "PageUp", "PageDown", "Backspace"}
    Hand.key(CEGUI.Key[names[math.random(#names)]], math.random(4) == 1 and "shift" or nil)
end

local function pressControl()
    local names = {"S", "Z", "Y", "C", "V", "O", "R", "D"}
    Hand.key(CEGUI.Key[names[math.random(#names)]], "control")
end

local function click()
    Hand.click(CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow(), math.random(), math.random())
end

local function drag()
    local root = CEGUI.System:getSingleton():getDefaultGUIContext():getRootWindow()
    Hand.drag(root, math.random(), math.random(), math.random(), math.random(), math.random(0, 2))
end

local function type()
    local texts = {"5", "0.5", "-1", "x", "1e9", ".", "[", " "}
    Hand.type(texts[math.random(#texts)])
end

-- What goes on around the panel.
local function happen(session)
    local api, mesh = session.api, session.state.mesh
    local chance = math.random(6)
    if mesh and api.queue:isQueued(mesh) then
        if chance == 1 then
            api.queue:fail(mesh, "no memory")
        else
            api.queue:finish(mesh)
        end
    elseif chance == 2 then
        api.finishJobs()
    elseif chance == 3 and mesh then
        api.queue:progress(mesh, math.random())
    end
end

local Tests = {}

function Tests.randomHandsDoNoHarm()
    local session = require("PanelSession").open():withLevels(20, 50)
    local errors = {}
    session.panel.guard.tell = function(message)
        table.insert(errors, message)
    end
    math.randomseed(7)
    local actions = {press, pressControl, click, click, click, drag, type, happen}
    for _ = 1, EVENTS do
        actions[math.random(#actions)](session)
        session:frame(math.random() * 0.3)
        Expect.equal(errors[1], nil)
    end
    for _, step in ipairs(session.state.undoSteps) do
        Expect.yes(step.definition)
    end
    session.panel:close()
end

return Tests
