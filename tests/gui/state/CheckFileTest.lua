-- Mesh files are checked before they are loaded, where the host has a check.

local Expect = require("Expect")
local FakeLodsmith = require("FakeLodsmith")
local LodState = require("lodsmith.gui.LodState")

local Tests = {}

function Tests.aFileThatDoesNotPassIsNotLoaded()
    local api = FakeLodsmith.new()
    local asked = {}
    local state = LodState.new(api, function(path)
        table.insert(asked, path)
        return nil, path .. ": broken"
    end)
    local opened, message = state:openMesh("/fake/a.mesh")
    Expect.equal(opened, nil)
    Expect.equal(message, "/fake/a.mesh: broken")
    Expect.equal(state.mesh, nil)
    Expect.equal(#asked, 1)
end

return Tests
