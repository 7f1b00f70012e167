-- Definitions and their levels. Each function is a test; note() writes down what has to be the same however garbage is collected.
local check = require("check")
local fails, raises, same = check.fails, check.raises, check.same
local Method, Strategy = lodsmith.Method, lodsmith.Strategy

local tests = {}

local function manual()
    local definition = lodsmith.newDefinition()
    assert(definition:setAutomatic(false))
    return definition
end

function tests.aNewOneIsAsAnEmptyFile()
    local definition = lodsmith.newDefinition()
    same(true, definition:isAutomatic())
    same(lodsmith.Type.Automatic, definition:type())
    same(Strategy.DistanceSphere, definition:strategy())
    same(nil, definition:metric())
    same(false, definition:lockBorders())
    same(0, definition:levelCount())
    same(nil, definition:weight("uv"))
    assert(definition:equals(assert(lodsmith.parseDefinition("<lod/>"))))
end

function tests.settersSetAndTextTellsAll()
    local definition = manual()
    assert(definition:setType(lodsmith.Type.User))
    assert(definition:setType(lodsmith.Type.Automatic))
    assert(definition:setStrategy(Strategy.PixelCount))
    assert(definition:setMetric(lodsmith.Metric.Quadric))
    assert(definition:setLockBorders(true))
    for index, attribute in ipairs({ "normal", "uv", "colour", "bone" }) do
        assert(definition:setWeight(attribute, index / 10))
    end
    assert(assert(definition:addLevel(500)):setTarget(Method.Deviation, 0.25))
    local again = assert(lodsmith.parseDefinition(assert(definition:text()), "again.loddef"))
    assert(again:equals(definition) and definition:equals(again))
    same(Strategy.PixelCount, again:strategy())
    same(lodsmith.Metric.Quadric, again:metric())
    same(true, again:lockBorders())
    -- Single precision inside, but what was written.
    same(0.1, again:weight("normal"))
    same(0.4, again:weight("bone"))
    same(500, again:level(1):value())
    same(Method.Deviation, again:level(1):method())
    same(0.25, again:level(1):amount())
    note(again:text())
end

function tests.settersRefuseWhatIsNoConstant()
    local definition = manual()
    local before = definition:copy()
    for _, number in ipairs({ -1, 4, 0.5, 1e300, 0 / 0, 1 / 0 }) do
        fails("none of lodsmith.Strategy", definition:setStrategy(number))
    end
    fails("none of lodsmith.Type", definition:setType(2))
    fails("none of lodsmith.Metric", definition:setMetric(2))
    fails("colour", definition:setWeight("color", 1))
    fails("colour", definition:weight("color"))
    for _, weight in ipairs({ -1, 0 / 0, 1 / 0, 1e39 }) do
        fails("0 or more", definition:setWeight("uv", weight))
    end
    assert(definition:equals(before))
end

function tests.metricAndWeightsCanBeLeftToTheDefault()
    local definition = manual()
    assert(definition:setMetric(lodsmith.Metric.Curvature))
    assert(definition:setMetric(nil))
    same(nil, definition:metric())
    assert(definition:setWeight("uv", 2))
    assert(definition:setWeight("uv", nil))
    same(nil, definition:weight("uv"))
end

function tests.levelsComeInTheOrderTheyWereAdded()
    local definition = manual()
    for _, value in ipairs({ 30, 10, 20.1 }) do
        same(value, assert(definition:addLevel(value)):value())
    end
    same(3, definition:levelCount())
    same("30 10 20.1", table.concat({ definition:level(1):value(), definition:level(2):value(), definition:level(3):value() }, " "))
    fails("no level 4", definition:level(4))
    fails("no level 0", definition:level(0))
    fails("no level 1.5", definition:level(1.5))
    fails("no level", definition:level(0 / 0))
end

function tests.valuesAreInRangeAndThereOnce()
    local definition = manual()
    local first = assert(definition:addLevel(10))
    local second = assert(definition:addLevel(20))
    for _, value in ipairs({ 0, -1, 1.1e18, 1 / 0, 0 / 0, 1e-60 }) do
        fails("above 0", definition:addLevel(value))
        fails("above 0", first:setValue(value))
    end
    fails("level 2 already", definition:addLevel(20))
    fails("level 2 already", first:setValue(20))
    -- The same number in single precision.
    fails("level 1 already", definition:addLevel(10.0000000001))
    same(2, definition:levelCount())
    assert(first:setValue(10))
    assert(first:setValue(1e18))
    same(20, second:value())
end

function tests.noMoreLevelsThanTheLimit()
    local definition = manual()
    for value = 1, lodsmith.limits.maxLevels do
        assert(definition:addLevel(value))
    end
    fails("256", definition:addLevel(1000))
    same(lodsmith.limits.maxLevels, definition:levelCount())
end

function tests.amountsAreCheckedByTheirMethod()
    local level = assert(manual():addLevel(10))
    same(Method.Proportional, level:method())
    same(0.5, level:amount())
    fails("0 to 1", level:setAmount(1.5))
    fails("0 to 1", level:setAmount(0 / 0))
    fails("whole number", level:setTarget(Method.Triangles, 1.5))
    fails("0 or more", level:setTarget(Method.Deviation, -1))
    fails("0 or more", level:setTarget(Method.CollapseCost, 1 / 0))
    fails("none of lodsmith.Method", level:setTarget(5, 0))
    same(Method.Proportional, level:method())
    same(0.5, level:amount())
    assert(level:setTarget(Method.Triangles, 1000))
    same(1000, level:amount())
    -- 1000 is no share: that method's default.
    assert(level:setMethod(Method.Proportional))
    same(0.5, level:amount())
    assert(level:setTarget(Method.Deviation, 0.75))
    -- 0.75 is one.
    assert(level:setMethod(Method.Proportional))
    same(0.75, level:amount())
    assert(level:setMethod(Method.Triangles))
    same(0, level:amount())
    fails("none of lodsmith.Method", level:setMethod(-1))
end

function tests.meshNames()
    local level = assert(manual():addLevel(10))
    same(false, level:isHandMade())
    assert(level:setMeshName("far/house.mesh"))
    same("far/house.mesh", level:meshName())
    same(true, level:isHandMade())
    for _, name in ipairs({ " a", "a ", "a\nb", "a\0b", ("x"):rep(lodsmith.limits.maxMeshNameBytes + 1), "\255" }) do
        fails("the mesh name", level:setMeshName(name))
    end
    same("far/house.mesh", level:meshName())
    assert(level:setMeshName(""))
    same(false, level:isHandMade())
end

function tests.aLevelKnowsItWasRemoved()
    local definition = manual()
    local first = assert(definition:addLevel(10))
    local second = assert(definition:addLevel(20))
    local again = definition:level(1)
    assert(definition:removeLevel(1))
    same(1, definition:levelCount())
    for _, gone in ipairs({ first, again }) do
        fails("the level is gone", gone:value())
        fails("the level is gone", gone:setValue(5))
        fails("the level is gone", gone:method())
        fails("the level is gone", gone:setMethod(0))
        fails("the level is gone", gone:amount())
        fails("the level is gone", gone:setAmount(0))
        fails("the level is gone", gone:setTarget(0, 0))
        fails("the level is gone", gone:meshName())
        fails("the level is gone", gone:setMeshName(""))
        fails("the level is gone", gone:isHandMade())
    end
    same(20, second:value())
    -- One at the same place with the same value is another.
    assert(definition:addLevel(10))
    fails("the level is gone", first:value())
    fails("no level 3", definition:removeLevel(3))
end

function tests.sortingKeepsTheHandsOnLevels()
    local definition = manual()
    local levels = {}
    for _, value in ipairs({ 30, 10, 20 }) do
        levels[value] = assert(definition:addLevel(value))
        assert(levels[value]:setTarget(Method.Triangles, value))
    end
    assert(definition:sortLevels())
    same(10, definition:level(1):value())
    same(30, definition:level(3):value())
    -- With pixels, many are near.
    assert(definition:setStrategy(Strategy.PixelCount))
    assert(definition:sortLevels())
    same(30, definition:level(1):value())
    for value, level in pairs(levels) do
        same(value, level:value())
        same(value, level:amount())
    end
    assert(definition:removeLevel(1))
    fails("the level is gone", levels[30]:value())
    same(10, levels[10]:amount())
end

function tests.assignmentAliasesAndCopyIsDeep()
    local definition = manual()
    local level = assert(definition:addLevel(10))
    local alias, copy = definition, definition:copy()
    assert(copy:equals(definition))
    assert(level:setValue(11))
    same(11, alias:level(1):value())
    same(10, copy:level(1):value())
    assert(not copy:equals(definition))
    assert(copy:removeLevel(1))
    same(11, level:value())
end

function tests.levelsOutliveTheDefinitionsHandle()
    local level = assert(manual():addLevel(10))
    collectgarbage()
    same(10, level:value())
    assert(level:setValue(12))
    same(12, level:value())
end

function tests.errorsAreSentences()
    local definition = manual()
    same(0, #definition:errors())
    assert(definition:setType(lodsmith.Type.User))
    assert(definition:addLevel(10))
    assert(definition:addLevel(20))
    local errors = definition:errors()
    same(2, #errors)
    assert(errors[2]:find("level 2", 1, true), errors[2])
    fails("level 1", definition:text())
    note(errors[1], errors[2])
end

function tests.parsingTellsAllErrorsOneALine()
    local text = "<lod><manual><level distance='x'><value>0.5</value></level>\n<level distance='-1'/></manual></lod>"
    local definition, message = lodsmith.parseDefinition(text, "house.loddef")
    same(nil, definition)
    local lines = 0
    for line in message:gmatch("[^\n]+") do
        assert(line:find("^house.loddef:%d+: "), line)
        lines = lines + 1
    end
    assert(lines >= 2, message)
    fails("", lodsmith.parseDefinition(""))
    fails("", lodsmith.parseDefinition("<lod/>\0<lod/>"))
    note(message)
end

function tests.whatOthersWroteInAFileStays()
    local text = "<lod><!-- by hand --><automatic enabled='false'/><studio x='1'/></lod>"
    local definition = assert(lodsmith.parseDefinition(text))
    assert(definition:addLevel(5))
    local written = definition:copy():text()
    assert(written:find("<!-- by hand -->", 1, true) and written:find("<studio x=\"1\"", 1, true), written)
end

function tests.wrongTypesAreLuaErrors()
    local definition = manual()
    local level = assert(definition:addLevel(10))
    raises("number", function() definition:addLevel("far") end)
    raises("number", function() definition:addLevel() end)
    raises("number", function() definition:addLevel({}) end)
    raises("boolean", function() definition:setAutomatic(1) end)
    raises("string", function() definition:weight({}) end)
    raises("lodsmith::Definition", function() definition:equals(level) end)
    raises("nil", function() definition:equals(nil) end)
    raises("lodsmith::Definition", function() definition.levelCount(level) end)
    raises("lodsmith::Definition", function() definition.levelCount({}) end)
    raises("", function() definition.levelCount() end)
    raises("", function() definition:levelCount(1) end)
    raises("string", function() lodsmith.parseDefinition(definition) end)
    same(1, definition:levelCount())
end

function tests.thereAreNoConstructorsAndNoDestructors()
    for _, class in ipairs({ "Definition", "Level", "Mesh", "Resource", "Connection", "Job", "Queue", "Manager" }) do
        for _, name in ipairs({ "new", "new_local", "delete" }) do
            same(nil, lodsmith[class][name])
        end
    end
    same(nil, lodsmith.newDefinition().new)
    same(nil, lodsmith.newDefinition().delete)
end

function tests.constantsAreThoseOfTheDocumentation()
    local names = {
        Strategy = { "DistanceSphere", "DistanceBox", "PixelCount", "ScreenRatioPixelCount" },
        Type = { "Automatic", "User" },
        Method = { "Proportional", "Constant", "Triangles", "Deviation", "CollapseCost" },
        Metric = { "Quadric", "Curvature" },
        Decision = { "LeftAlone", "Queued", "Attached", "Removed" },
        StopReason = { "TargetReached", "Locked", "Seam", "Topology" },
    }
    for table_, constants in pairs(names) do
        local seen = {}
        for _, name in ipairs(constants) do
            local number = lodsmith[table_][name]
            assert(type(number) == "number" and not seen[number], table_ .. "." .. name)
            seen[number] = true
        end
    end
    same(256, lodsmith.limits.maxLevels)
    same(1e18, lodsmith.limits.maxValue)
    same(1024, lodsmith.limits.maxMeshNameBytes)
end

return tests
