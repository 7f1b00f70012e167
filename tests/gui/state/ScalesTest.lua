local Expect = require("Expect")
local GraphScale = require("lodsmith.gui.GraphScale")
local SliderScale = require("lodsmith.gui.SliderScale")
local SwitchValues = require("lodsmith.gui.SwitchValues")

local methods = {Proportional = 1, Constant = 2, Triangles = 3, Deviation = 4, CollapseCost = 5}
local strategies = {DistanceSphere = 1, DistanceBox = 2, PixelCount = 3, ScreenRatioPixelCount = 4}
local info = {uniqueVertices = 500, triangles = 990, radius = 10}

local Tests = {}

function Tests.sliderEndsAreTheMethodsRange()
    for method, most in pairs({[1] = 1, [2] = 500, [3] = 990, [4] = 10, [5] = 10}) do
        local scale = SliderScale.of(method, methods, info)
        Expect.equal(scale.toAmount(0), 0)
        Expect.equal(scale.toAmount(1), most)
        Expect.equal(scale.toAmount(2), most)
        Expect.equal(scale.toPosition(most), 1)
        Expect.equal(scale.toPosition(most * 3), 1)
    end
end

function Tests.sliderPositionAndAmountAgree()
    for method = 1, 5 do
        local scale = SliderScale.of(method, methods, info)
        for step = 1, 9 do
            local amount = scale.toAmount(step / 10)
            Expect.near(scale.toPosition(amount), step / 10, 0.02)
        end
    end
end

function Tests.smallDeviationsHaveMostOfTheSlider()
    local scale = SliderScale.of(methods.Deviation, methods, info)
    Expect.yes(scale.toAmount(0.2) < info.radius / 500)
    Expect.yes(scale.toPosition(info.radius / 100) > 0.3)
end

function Tests.wholeNumbersForCounts()
    Expect.equal(SliderScale.of(methods.Triangles, methods, info).toAmount(0.3333), 330)
end

function Tests.meshWithoutSizeHasASlider()
    local scale = SliderScale.of(methods.Deviation, methods, {radius = 0})
    Expect.equal(scale.toPosition(0), 0)
    Expect.equal(scale.toAmount(1), 0)
end

function Tests.switchValuesComeBack()
    for from = 1, 4 do
        for to = 1, 4 do
            local value = from <= 2 and 70 or from == 3 and 5000 or 0.01
            local there = SwitchValues.convert(strategies, from, to, value, 10)
            Expect.near(SwitchValues.convert(strategies, to, from, there, 10), value, value * 1e-6)
        end
    end
end

function Tests.switchValuesTurnRound()
    local near = SwitchValues.convert(strategies, 1, 3, 20, 10)
    local far = SwitchValues.convert(strategies, 1, 3, 200, 10)
    Expect.yes(near > far)
    -- A radius of 10 at 20 beyond the sphere's tangent: 22.36 away, 583 pixels of radius.
    Expect.near(near, math.pi * (10 / math.sqrt(500) * 540 / math.tan(math.rad(22.5))) ^ 2, 1)
end

function Tests.moreThanTheScreenIsAsNearAsCanBe()
    local distance = SwitchValues.convert(strategies, 3, 1, 1e12, 10)
    Expect.yes(distance > 0 and distance < 0.1)
end

function Tests.nextLevelIsHalfAsLarge()
    Expect.equal(SwitchValues.beyond(strategies, 1, 30, 10), 60)
    Expect.equal(SwitchValues.beyond(strategies, 3, 4000, 10), 1000)
    Expect.equal(SwitchValues.beyond(strategies, 3, nil, 10), 100000)
end

function Tests.graphIsLogarithmic()
    local scale = GraphScale.new({{triangles = 10, deviation = 1}, {triangles = 1000, deviation = 0.01},
        {triangles = 100, deviation = 0.1}, {triangles = 2000, deviation = 0}})
    Expect.equal(scale:x(10), 0)
    Expect.equal(scale:x(2000), 1)
    Expect.near(scale:y(0.1), 0.5, 1e-9)
    Expect.equal(scale:y(1), 1)
    Expect.equal(scale:y(0), 0)
    local upright, level = scale:ticks()
    Expect.equal(#upright, 3)
    Expect.equal(#level, 3)
    Expect.equal(upright[1], 0)
    Expect.near(level[2], 0.5, 1e-9)
end

function Tests.graphOfNothingAndOfOnePoint()
    Expect.yes(GraphScale.new({}):isEmpty())
    local scale = GraphScale.new({{triangles = 10, deviation = 0}})
    Expect.equal(scale:x(10), 0.5)
    Expect.equal(scale:y(0), 0)
end

function Tests.nearestMarkWithinReach()
    local places = {[2] = {x = 0.5, y = 0.5}, [5] = {x = 0.6, y = 0.5}}
    Expect.equal(GraphScale.nearest(places, 0.52, 0.5, 100, 100, 12), 2)
    Expect.equal(GraphScale.nearest(places, 0.58, 0.5, 100, 100, 12), 5)
    Expect.equal(GraphScale.nearest(places, 0.1, 0.5, 100, 100, 12), nil)
end

return Tests
