-- How long an artist waits: from a movement of the slider to the frame that shows the new level, and how long each frame's
-- own work holds the interface up. Run by the editor:
--   lodsmith-editor --script benchmarks/editor-latency.lua MESH
-- The slider is moved as the mouse moves it, through the panel, 50 times, each time when the last level is on the screen.

local MOVES = 50
local editor, panel = lodsmith.editor, lodsmith.panel
local state, preview = panel.state, lodsmith.preview

local function waitUntil(condition)
    while not condition() do
        coroutine.yield()
    end
end

local function quantile(sorted, share)
    return sorted[math.max(1, math.ceil(#sorted * share))]
end

local function report(what, seconds)
    table.sort(seconds)
    print(("%-44s median %7.1f ms   95th percentile %7.1f ms   most %7.1f ms"):format(what, 1000 * quantile(seconds, 0.5),
        1000 * quantile(seconds, 0.95), 1000 * seconds[#seconds]))
end

local function isResting()
    return not state:isGenerating()
end

waitUntil(function()
    return state.mesh ~= nil and isResting()
end)
print(("%s: %d triangles"):format(state.mesh:name(), state.mesh:triangles(0)))
assert(state:setAutomatic(false))
while state:levelCount() > 0 do
    assert(state:select(1) and state:deleteLevel())
end
assert(state:addLevel("50"))
waitUntil(isResting)
panel.previewPane:showLevel(1)

local injected = nil
local connection = lodsmith.queue:onInjected(function()
    injected = editor:seconds()
end)
local latencies, generations, works, draws = {}, {}, {}, {}
local slider = CEGUI.toScrollbar(panel.definitionPane.parts.AmountSlider)
local range = slider:getDocumentSize() - slider:getPageSize()
for move = 1, MOVES do
    local start = editor:seconds()
    injected = nil
    slider:setScrollPosition(range * (0.2 + 0.6 * (move * 0.618 % 1)))
    repeat
        coroutine.yield()
        local work, draw = editor:frameTimes()
        table.insert(works, work)
        if draw > 0.001 then -- frames in which nothing has changed are not drawn
            table.insert(draws, draw)
        end
    until injected and isResting()
    table.insert(generations, injected - start)
    -- The frame in which the levels came has been drawn when the script goes on.
    table.insert(latencies, editor:seconds() - start)
    for _ = 1, 3 do
        coroutine.yield()
    end
end
connection:disconnect()
report("slider to levels on the mesh", generations)
report("slider to the frame that shows them", latencies)
report("interface held up by a frame's own work", works)
report("the renderer's own frame", draws)
editor:quit()
