local Expect = require("Expect")
local Scheduler = require("lodsmith.gui.Scheduler")

local mesh = {}
function mesh:equals(other)
    return self == other
end

-- A scheduler over a queue that remembers what it was given.
local function make(decide)
    local world = {applied = {}, queued = false, done = {}}
    world.scheduler = Scheduler.new({
        apply = function(_, definition)
            table.insert(world.applied, definition)
            local decision, message = (decide or function() return "queued" end)(definition)
            world.queued = decision == "queued"
            return decision, message
        end,
        isQueued = function()
            return world.queued
        end,
        cancel = function()
            world.queued = false
        end,
    }, "queued", function(_, message)
        table.insert(world.done, message or "done")
    end)
    function world.finish()
        world.queued = false
        world.scheduler:finished(mesh)
        world.scheduler:update()
    end
    return world
end

local Tests = {}

function Tests.startsAtOnceWhenNothingRuns()
    local world = make()
    world.scheduler:request(mesh, 1)
    Expect.equal(#world.applied, 1)
    Expect.yes(world.scheduler:isBusy())
end

function Tests.newestWaitsAndWins()
    local world = make()
    for edit = 1, 5 do
        world.scheduler:request(mesh, edit)
    end
    world.finish()
    Expect.equal(table.concat(world.applied, " "), "1 5")
    world.finish()
    Expect.no(world.scheduler:isBusy())
end

function Tests.streamShowsIntermediateResults()
    local world = make()
    for edit = 1, 30 do
        world.scheduler:request(mesh, edit)
        if edit % 10 == 0 then
            world.finish()
        end
    end
    Expect.equal(table.concat(world.applied, " "), "1 10 20 30")
end

function Tests.waitsForAGenerationOfOthers()
    local world = make()
    world.queued = true
    world.scheduler:request(mesh, 1)
    Expect.equal(#world.applied, 0)
    world.finish()
    Expect.equal(#world.applied, 1)
end

function Tests.goesOnWhenAGenerationVanishes()
    local world = make()
    world.scheduler:request(mesh, 1)
    world.scheduler:request(mesh, 2)
    world.queued = false
    world.scheduler:update()
    Expect.equal(table.concat(world.applied, " "), "1 2")
end

function Tests.tellsOfWhatNeedsNoGeneration()
    local world = make(function(definition)
        if definition == 1 then
            return "removed"
        end
        return nil, "no such mesh"
    end)
    world.scheduler:request(mesh, 1)
    world.scheduler:request(mesh, 2)
    Expect.equal(table.concat(world.done, ", "), "done, no such mesh")
    Expect.no(world.scheduler:isBusy())
end

function Tests.cancelDropsWhatWaitsToo()
    local world = make()
    world.scheduler:request(mesh, 1)
    world.scheduler:request(mesh, 2)
    world.scheduler:cancel()
    Expect.no(world.queued)
    world.scheduler:update()
    Expect.equal(#world.applied, 1)
end

return Tests
