-- What a program shares: definitions, manager, queue, generator, analysis; and connections.
local check = require("check")
local fails, raises, same = check.fails, check.raises, check.same

local tests = {}

function tests.definitionsAreReadAndSaved()
    writeSphere("a.mesh", 2)
    local mesh = assert(lodsmith.openMesh(directory .. "/a.mesh"))
    local definition, path = lodsmith.definitions:read(mesh)
    assert(definition:equals(lodsmith.newDefinition()))
    same(nil, path)
    same(directory .. "/a.loddef", lodsmith.definitions:path(mesh))
    definition = check.levels(100, 40)
    same(directory .. "/a.loddef", lodsmith.definitions:save(mesh, definition))
    local saved
    saved, path = lodsmith.definitions:read(mesh)
    assert(saved:equals(definition))
    same(directory .. "/a.loddef", path)
    -- A copy, and fresh each time.
    assert(saved:removeLevel(1))
    assert(lodsmith.definitions:read(mesh):equals(definition))
end

function tests.whatIsSavedCountsWhenTheMeshIsLoadedAgain()
    writeSphere("a.mesh", 2)
    local path = directory .. "/a.mesh"
    for _, triangles in ipairs({ 100, 40 }) do
        local mesh = assert(lodsmith.openMesh(path))
        assert(lodsmith.definitions:save(mesh, check.levels(triangles)))
        removeMesh("a.mesh")
        mesh = assert(lodsmith.openMesh(path))
        finish()
        same(10, assert(mesh:info()).levels[1].value)
        assert(mesh:triangles(1) <= triangles and mesh:triangles(1) > triangles - 3)
    end
end

function tests.aFileWithErrorsIsAMessage()
    writeSphere("a.mesh", 1)
    local file = assert(io.open(directory .. "/a.loddef", "w"))
    file:write("<lod><manual>\n<level distance='x'/>\n<level distance='y'/></manual></lod>")
    file:close()
    local mesh = assert(lodsmith.openMesh(directory .. "/a.mesh"))
    local definition, message = lodsmith.definitions:read(mesh)
    same(nil, definition)
    assert(message:find("a.loddef:2:", 1, true) and message:find("a.loddef:3:", 1, true), message)
    fails("errors", lodsmith.manager:apply(mesh))
end

function tests.onlyWhatIsInOrderIsSaved()
    writeSphere("a.mesh", 1)
    local mesh = assert(lodsmith.openMesh(directory .. "/a.mesh"))
    local definition = check.levels(40)
    assert(definition:setType(lodsmith.Type.User))
    fails("level 1", lodsmith.definitions:save(mesh, definition))
    same(nil, io.open(directory .. "/a.loddef"))
    makeSphere("by hand")
    fails("no file", lodsmith.definitions:save(check.meshNamed("by hand"), check.levels(40)))
    fails("no file", lodsmith.definitions:path(check.meshNamed("by hand")))
end

function tests.theManagerAppliesADefinition()
    makeSphere("a", 2)
    local mesh = check.meshNamed("a")
    same(lodsmith.Decision.LeftAlone, lodsmith.manager:apply(mesh))
    same(lodsmith.Decision.Queued, lodsmith.manager:apply(mesh, check.levels(100, 40)))
    same(true, lodsmith.queue:isQueued(mesh))
    finish()
    same(2, #assert(mesh:info()).levels)
    same(lodsmith.Decision.Removed, lodsmith.manager:apply(mesh, check.levels()))
    same(0, #assert(mesh:info()).levels)
    same(lodsmith.Decision.Queued, lodsmith.manager:apply(mesh, lodsmith.newDefinition()))
    finish()
    local automatic = assert(mesh:info()).levels
    assert(#automatic > 0 and automatic[1].value > 10)
    local wrong = check.levels(40)
    assert(wrong:setType(lodsmith.Type.User))
    fails("level 1", lodsmith.manager:apply(mesh, wrong))
    same(#automatic, #assert(mesh:info()).levels)
end

function tests.automaticLevelsCanBeMadeOnesOwn()
    makeSphere("a", 3)
    local mesh = check.meshNamed("a")
    local definition = assert(lodsmith.manager:automaticDefinition(mesh))
    same(false, definition:isAutomatic())
    same(lodsmith.Strategy.PixelCount, definition:strategy())
    same(8, definition:levelCount(), "the mesh has no levels yet: all that it could have")
    same(6, assert(lodsmith.manager:automaticDefinition(mesh, 6)):levelCount())
    for _, levels in ipairs({ 0, 9, 1.5, 0 / 0 }) do
        fails("1 to 8", lodsmith.manager:automaticDefinition(mesh, levels))
    end
    -- The same levels. Fewer stops on the way may let a few other collapses be made.
    assert(lodsmith.generator:generate(mesh, lodsmith.newDefinition()))
    local automatic = assert(mesh:info()).levels
    definition = assert(lodsmith.manager:automaticDefinition(mesh))
    same(#automatic, definition:levelCount())
    assert(lodsmith.generator:generate(mesh, definition))
    local own = assert(mesh:info()).levels
    same(#automatic, #own)
    for index, level in ipairs(own) do
        same(automatic[index].value, level.value)
        assert(math.abs(automatic[index].triangles - level.triangles) <= 0.1 * level.triangles)
    end
end

function tests.thePolicyIsReadAndSet()
    local manager = lodsmith.manager
    same(true, manager:enabled())
    same(false, manager:automatic())
    same(500, manager:minTriangles())
    assert(manager:setAutomatic(true))
    assert(manager:setMinTriangles(100))
    assert(manager:setEnabled(true))
    same(true, manager:automatic())
    same(100, manager:minTriangles())
    for _, triangles in ipairs({ -1, 1e10, 0 / 0 }) do
        fails("triangles", manager:setMinTriangles(triangles))
    end
    makeSphere("a", 2)
    assert(manager:applyToAll())
    finish()
    assert(#assert(check.meshNamed("a"):info()).levels > 0)
    assert(manager:setAutomatic(false))
    assert(manager:applyToAll())
    same(0, #assert(check.meshNamed("a"):info()).levels)
end

function tests.theQueueTellsWhatItDid()
    makeSphere("a", 2)
    local mesh = check.meshNamed("a")
    local heard, fractions = {}, {}
    local injected = assert(lodsmith.queue:onInjected(function(m, report) heard[#heard + 1] = { m, report } end))
    local progress = assert(lodsmith.queue:onProgress(function(m, fraction)
        assert(m:equals(mesh))
        fractions[#fractions + 1] = fraction
    end))
    same(true, lodsmith.queue:generate(mesh, check.levels(100, 40)))
    same(1, lodsmith.queue:queued())
    same(true, lodsmith.queue:isQueued(mesh))
    finish()
    same(0, lodsmith.queue:queued())
    same(1, #heard)
    assert(heard[1][1]:equals(mesh))
    local report = heard[1][2]
    same(320, report.triangles)
    same(162, report.vertices)
    assert(math.abs(report.radius - 1) < 1e-5)
    same(false, report.fromCache)
    same(0, #report.notes)
    same(2, #report.levels)
    same(20, report.levels[2].value)
    same(mesh:triangles(2), report.levels[2].triangles)
    same(lodsmith.StopReason.TargetReached, report.levels[2].stop)
    same(false, report.levels[2].skipped)
    same(false, report.levels[2].handMade)
    assert(report.levels[2].deviation > report.levels[1].deviation and report.levels[1].deviation > 0)
    assert(injected:isConnected() and progress:isConnected())
    note(report.levels[1].triangles, report.levels[1].deviation)
end

function tests.theQueueTellsWhatFailed()
    makeSphere("a", 2)
    local mesh = check.meshNamed("a")
    local messages = {}
    local failed = assert(lodsmith.queue:onFailed(function(m, message) messages[#messages + 1] = m:name() .. ": " .. message end))
    local definition = check.levels(40)
    spoil("a")
    same(true, lodsmith.queue:generate(mesh, definition))
    finish()
    same(1, #messages)
    assert(messages[1]:find("^a: ") and failed:isConnected(), messages[1])
    fails("a", lodsmith.generator:generate(mesh, definition))
end

function tests.requestsAreTakenBack()
    makeSphere("a", 2)
    local mesh = check.meshNamed("a")
    local heard = 0
    local connection = assert(lodsmith.queue:onInjected(function() heard = heard + 1 end))
    assert(lodsmith.queue:generate(mesh, check.levels(40)))
    same(true, lodsmith.queue:cancel(mesh))
    same(false, lodsmith.queue:isQueued(mesh))
    assert(lodsmith.queue:generate(mesh, check.levels(40), 5))
    same(true, lodsmith.queue:cancelAll())
    finish()
    same(0, heard)
    fails("priority", lodsmith.queue:generate(mesh, check.levels(40), 0 / 0))
    assert(connection:isConnected())
end

function tests.theGeneratorReports()
    makeSphere("a", 2)
    local mesh = check.meshNamed("a")
    local report = assert(lodsmith.generator:generate(mesh, check.levels(100)))
    same(mesh:triangles(1), report.levels[1].triangles)
    local again = assert(lodsmith.generator:generate(mesh, check.levels(100)))
    same(report.levels[1].deviation, again.levels[1].deviation)
end

function tests.handMadeLevelsHaveNames()
    writeSphere("near.mesh", 2)
    writeSphere("far.mesh", 1)
    local mesh = assert(lodsmith.openMesh(directory .. "/near.mesh"))
    local definition = check.levels(100)
    assert(assert(definition:addLevel(50)):setMeshName("far.mesh"))
    same(lodsmith.Decision.Attached, lodsmith.manager:apply(mesh, definition))
    local level = assert(mesh:info()).levels[2]
    same(true, level.handMade)
    same("far.mesh", level.mesh)
    same(80, level.triangles)
    same(80, mesh:triangles(2))
    local report = assert(lodsmith.generator:generate(mesh, definition))
    same(true, report.levels[2].handMade)
    same("far.mesh", report.levels[2].mesh)
    same(nil, report.levels[1].mesh)
end

function tests.servicesEnd()
    makeSphere("a", 2)
    local mesh = check.meshNamed("a")
    local definitions, manager, queue = lodsmith.definitions, lodsmith.manager, lodsmith.queue
    local generator, analysis = lodsmith.generator, lodsmith.analysis
    local connection = assert(queue:onInjected(function() end))
    local job = assert(analysis:measure(mesh, 0, function() error("never called") end))
    endServices()
    same(false, connection:isConnected())
    same(true, connection:disconnect())
    same(false, job:isRunning())
    same(true, job:cancel())
    local definition = check.levels(40)
    fails("the definition manager is gone", definitions:read(mesh))
    fails("the definition manager is gone", definitions:path(mesh))
    fails("the definition manager is gone", definitions:save(mesh, definition))
    fails("the manager is gone", manager:apply(mesh))
    fails("the manager is gone", manager:applyToAll())
    fails("the manager is gone", manager:automaticDefinition(mesh))
    fails("the manager is gone", manager:automatic())
    fails("the manager is gone", manager:setAutomatic(true))
    fails("the manager is gone", manager:enabled())
    fails("the manager is gone", manager:setEnabled(true))
    fails("the manager is gone", manager:minTriangles())
    fails("the manager is gone", manager:setMinTriangles(1))
    fails("the queue is gone", queue:generate(mesh, definition))
    fails("the queue is gone", queue:isQueued(mesh))
    fails("the queue is gone", queue:queued())
    fails("the queue is gone", queue:cancel(mesh))
    fails("the queue is gone", queue:cancelAll())
    fails("the queue is gone", queue:onInjected(function() end))
    fails("the queue is gone", queue:onFailed(function() end))
    fails("the queue is gone", queue:onProgress(function() end))
    fails("the generator is gone", generator:generate(mesh, definition))
    fails("the analysis is gone", analysis:measure(mesh, 0, function() end))
    fails("the analysis is gone", analysis:curve(mesh, definition, 8, function() end))
    -- New ones are new.
    startServices()
    same(0, lodsmith.queue:queued())
    fails("the queue is gone", queue:queued())
    same("a", mesh:name())
end

function tests.aConnectionIsDisconnectedOnce()
    makeSphere("a", 1)
    local mesh = check.meshNamed("a")
    local heard = {}
    local first = assert(lodsmith.queue:onInjected(function() heard[#heard + 1] = "first" end))
    same(true, first:disconnect())
    same(true, first:disconnect())
    same(false, first:isConnected())
    -- Were the function let go twice, two others would be taken for one another.
    local second = assert(lodsmith.queue:onInjected(function() heard[#heard + 1] = "second" end))
    local third = assert(lodsmith.queue:onInjected(function() heard[#heard + 1] = "third" end))
    first = nil
    collectgarbage()
    local fourth = assert(lodsmith.queue:onInjected(function() heard[#heard + 1] = "fourth" end))
    assert(lodsmith.queue:generate(mesh, check.levels(40)))
    finish()
    same("second third fourth", table.concat(heard, " "))
    assert(second:isConnected() and third:isConnected() and fourth:isConnected())
end

function tests.collectingAConnectionDisconnects()
    makeSphere("a", 1)
    local mesh = check.meshNamed("a")
    local heard = 0
    local weak = setmetatable({}, { __mode = "v" })
    do
        local function listener() heard = heard + 1 end
        weak[1] = listener
        local connection = assert(lodsmith.queue:onInjected(listener))
        connection = nil
    end
    collectgarbage()
    collectgarbage()
    same(nil, weak[1])
    assert(lodsmith.queue:generate(mesh, check.levels(40)))
    finish()
    same(0, heard)
end

function tests.theEmittersEndLetsFunctionsGo()
    local weak = setmetatable({}, { __mode = "v" })
    local connection
    do
        local function listener() return weak end
        weak[1] = listener
        connection = assert(lodsmith.queue:onInjected(listener))
    end
    collectgarbage()
    assert(weak[1])
    endServices()
    collectgarbage()
    same(nil, weak[1])
    same(false, connection:isConnected())
    startServices()
end

function tests.aHandlerMayDisconnectItselfAndOthers()
    makeSphere("a", 1)
    local mesh = check.meshNamed("a")
    local heard = {}
    local first, second
    first = assert(lodsmith.queue:onInjected(function()
        heard[#heard + 1] = "first"
        first:disconnect()
        second:disconnect()
        first, second = nil, nil
        collectgarbage()
    end))
    second = assert(lodsmith.queue:onInjected(function() heard[#heard + 1] = "second" end))
    for _ = 1, 2 do
        assert(lodsmith.queue:generate(mesh, check.levels(40)))
        finish()
    end
    same("first", table.concat(heard, " "))
end

function tests.aHandlerMayDoAnything()
    makeSphere("a", 1)
    makeSphere("b", 1)
    local mesh, other = check.meshNamed("a"), check.meshNamed("b")
    local names = {}
    local connection
    connection = assert(lodsmith.queue:onInjected(function(m)
        names[#names + 1] = m:name()
        if m:equals(mesh) then
            assert(lodsmith.queue:generate(other, check.levels(40)))
            removeMesh("a")
            fails("the mesh is gone", mesh:info())
        else
            endServices()
            same(false, connection:isConnected())
        end
    end))
    assert(lodsmith.queue:generate(mesh, check.levels(40)))
    finish()
    same("a b", table.concat(names, " "))
    startServices()
end

function tests.anErrorInAHandlerIsReported()
    makeSphere("a", 1)
    local mesh = check.meshNamed("a")
    local messages = {}
    lodsmith.onError = function(message) messages[#messages + 1] = message end
    local heard = 0
    local wrong = assert(lodsmith.queue:onInjected(function() error("broken handler") end))
    local strange = assert(lodsmith.queue:onInjected(function() error({}) end))
    local fine = assert(lodsmith.queue:onInjected(function() heard = heard + 1 end))
    assert(lodsmith.queue:generate(mesh, check.levels(40)))
    finish()
    same(1, heard)
    same(2, #messages)
    assert(messages[1]:find("broken handler", 1, true) and messages[1]:find("services.lua", 1, true), messages[1])
    same("an error without a message", messages[2])
    -- One that is broken itself does no harm.
    lodsmith.onError = function() error("broken too") end
    assert(lodsmith.queue:generate(mesh, check.levels(40)))
    finish()
    same(2, heard)
    lodsmith.onError = nil
    assert(lodsmith.queue:generate(mesh, check.levels(40)))
    finish()
    same(3, heard)
    assert(wrong:isConnected() and strange:isConnected() and fine:isConnected())
end

function tests.aConnectionMadeInACoroutineOutlivesIt()
    makeSphere("a", 1)
    local heard = 0
    local connection
    local routine = coroutine.create(function()
        connection = assert(lodsmith.queue:onInjected(function() heard = heard + 1 end))
        coroutine.yield()
    end)
    assert(coroutine.resume(routine))
    routine = nil
    collectgarbage()
    assert(lodsmith.queue:generate(check.meshNamed("a"), check.levels(40)))
    finish()
    same(1, heard)
    assert(connection:isConnected())
end

function tests.onlyFunctionsAreConnected()
    for _, wrong in ipairs({ 1, "f", {}, lodsmith.queue }) do
        raises("function", function() lodsmith.queue:onInjected(wrong) end)
    end
    raises("function", function() lodsmith.queue:onInjected() end)
    raises("function", function() lodsmith.queue:onFailed(nil) end)
end

function tests.levelsAreMeasured()
    makeSphere("a", 3)
    local mesh = check.meshNamed("a")
    assert(lodsmith.generator:generate(mesh, check.levels(400, 100)))
    local results = {}
    local jobs = {}
    for level = 0, 2 do
        jobs[level] = assert(lodsmith.analysis:measure(mesh, level, function(result, message)
            same(nil, message)
            results[level] = result
        end))
        same(true, jobs[level]:isRunning())
    end
    finishAnalysis()
    for level = 0, 2 do
        same(false, jobs[level]:isRunning())
    end
    assert(results[0].maximum < 1e-6)
    assert(results[2].maximum > results[1].maximum and results[1].maximum > results[1].rms)
    assert(results[1].rms >= results[1].mean and results[1].mean > 0 and results[1].normalMean > 0)
    same(0, results[2].flipped)
    same(0, results[2].newBorderEdges)
    fails("no level 3", lodsmith.analysis:measure(mesh, 3, function() end))
    fails("no level -1", lodsmith.analysis:measure(mesh, -1, function() end))
    fails("no level 0.5", lodsmith.analysis:measure(mesh, 0.5, function() end))
    note(results[2].maximum)
end

function tests.curvesFallAndRise()
    makeSphere("a", 3)
    local mesh = check.meshNamed("a")
    local points
    local job = assert(lodsmith.analysis:curve(mesh, lodsmith.newDefinition(), 12, function(result) points = result end))
    finishAnalysis()
    same(1280, points[1].triangles)
    same(642, points[1].vertices)
    same(0, points[1].deviation)
    assert(#points > 4)
    for index = 2, #points do
        assert(points[index].triangles < points[index - 1].triangles)
        assert(points[index].deviation >= points[index - 1].deviation)
    end
    same(1, job:fraction())
    fails("1 to 256", lodsmith.analysis:curve(mesh, lodsmith.newDefinition(), 0, function() end))
    fails("1 to 256", lodsmith.analysis:curve(mesh, lodsmith.newDefinition(), 257, function() end))
    fails("1 to 256", lodsmith.analysis:curve(mesh, lodsmith.newDefinition(), 2.5, function() end))
end

function tests.jobsAreCancelled()
    makeSphere("a", 3)
    local mesh = check.meshNamed("a")
    local called = 0
    local function count() called = called + 1 end
    local kept = assert(lodsmith.analysis:curve(mesh, lodsmith.newDefinition(), 12, count))
    local cancelled = assert(lodsmith.analysis:measure(mesh, 0, count))
    same(true, cancelled:cancel())
    same(false, cancelled:isRunning())
    assert(lodsmith.analysis:measure(mesh, 0, count))
    collectgarbage() -- nobody holds that one
    collectgarbage()
    finishAnalysis()
    same(1, called)
    same(false, kept:isRunning())
end

function tests.whatCannotBeMeasuredIsAMessage()
    makeSphere("a", 2)
    local mesh = check.meshNamed("a")
    local seen
    local job = assert(lodsmith.analysis:measure(mesh, 0, function(...) seen = { n = select("#", ...), ... } end))
    removeMesh("a")
    finishAnalysis()
    same(2, seen.n)
    same(nil, seen[1])
    assert(type(seen[2]) == "string")
    same(false, job:isRunning())
end

return tests
