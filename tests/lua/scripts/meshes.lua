-- Meshes, files and resources.
local check = require("check")
local fails, raises, same = check.fails, check.raises, check.same

local tests = {}

function tests.meshesAreThoseOfOgreByName()
    makeSphere("b")
    makeSphere("a")
    local names = {}
    for _, mesh in ipairs(lodsmith.meshes()) do
        names[#names + 1] = mesh:name()
        assert(mesh:group() ~= "Internal")
    end
    same("a b", table.concat(names, " "))
    assert(not check.meshNamed("a"):equals(check.meshNamed("b")))
    assert(check.meshNamed("a"):equals(check.meshNamed("a")))
end

function tests.aHandleKnowsThatItsMeshIsGone()
    makeSphere("a")
    local mesh = check.meshNamed("a")
    same(false, mesh:isGone())
    removeMesh("a")
    same(true, mesh:isGone())
    same(false, mesh:isLoaded())
    assert(not mesh:equals(mesh))
    for _, method in ipairs({ "name", "group", "load", "path", "info" }) do
        fails("the mesh is gone", mesh[method](mesh))
    end
    fails("the mesh is gone", mesh:triangles(0))
    local definition = lodsmith.newDefinition()
    fails("the mesh is gone", lodsmith.manager:apply(mesh))
    fails("the mesh is gone", lodsmith.manager:apply(mesh, definition))
    fails("the mesh is gone", lodsmith.manager:automaticDefinition(mesh))
    fails("the mesh is gone", lodsmith.queue:generate(mesh, definition))
    fails("the mesh is gone", lodsmith.generator:generate(mesh, definition))
    fails("the mesh is gone", lodsmith.definitions:read(mesh))
    fails("the mesh is gone", lodsmith.definitions:path(mesh))
    fails("the mesh is gone", lodsmith.definitions:save(mesh, definition))
    fails("the mesh is gone", lodsmith.analysis:measure(mesh, 0, function() end))
    fails("the mesh is gone", lodsmith.analysis:curve(mesh, definition, 8, function() end))
    same(false, lodsmith.queue:isQueued(mesh))
    same(true, lodsmith.queue:cancel(mesh))
    -- Another mesh of the name is another mesh.
    makeSphere("a")
    same(true, mesh:isGone())
end

function tests.infoCounts()
    makeSphere("a", 2)
    local info = assert(check.meshNamed("a"):info())
    same(320, info.triangles)
    same(960, info.indices)
    same(162, info.uniqueVertices)
    same(162, info.vertices)
    assert(math.abs(info.radius - 1) < 1e-5)
    -- OGRE makes boxes a hundredth larger on each side.
    assert(info.size.x >= 2 and info.size.x <= 2.05 and info.size.z <= 2.05)
    same(false, info.edgeLists)
    same(nil, info.skeleton)
    same(0, info.animations)
    same(0, info.poses)
    same(0, #info.levels)
    same(1, #info.submeshes)
    local submesh = info.submeshes[1]
    same(320, submesh.triangles)
    same(162, submesh.vertices)
    same(960, submesh.indices)
    same(2, submesh.indexBytes)
    same(false, submesh.shared)
    -- Positions and normals of the vertices, and the indices.
    same(162 * 24 + 960 * 2, info.bytes)
end

function tests.infoTellsOfLevels()
    makeSphere("a", 2)
    local mesh = check.meshNamed("a")
    assert(lodsmith.generator:generate(mesh, check.levels(100, 40)))
    local levels = assert(mesh:info()).levels
    same(2, #levels)
    for index, level in ipairs(levels) do
        same(10 * index, level.value)
        same(mesh:triangles(index), level.triangles)
        same(level.indices, 3 * level.triangles)
        same(level.bytes, 2 * level.indices)
        same(false, level.handMade)
        assert(level.triangles <= 100 and level.vertices < 162 and level.vertices > 3)
    end
    same(320, mesh:triangles(0))
    fails("no level 3", mesh:triangles(3))
    fails("no level -1", mesh:triangles(-1))
    fails("no level 0.5", mesh:triangles(0.5))
    note(levels[1].triangles, levels[2].vertices)
end

function tests.filesAreOpenedFromAnywhere()
    writeSphere("a.mesh", 1)
    writeSphere("b.mesh", 2)
    local a = assert(lodsmith.openMesh(directory .. "/a.mesh"))
    local b = assert(lodsmith.openMesh(directory .. "/./b.mesh"))
    same(a:group(), b:group())
    same(80, a:triangles(0))
    same(directory .. "/a.mesh", a:path())
    assert(a:isLoaded())
    assert(a:equals(assert(lodsmith.openMesh(directory .. "/a.mesh"))))
    -- One that came after the directory was listed.
    writeSphere("c.mesh", 1)
    same(a:group(), assert(lodsmith.openMesh(directory .. "/c.mesh")):group())
    makeSphere("by hand")
    fails("comes from no file", check.meshNamed("by hand"):path())
end

local function writeFile(name, bytes)
    local file = assert(io.open(directory .. "/" .. name, "wb"))
    file:write(bytes)
    file:close()
end

local function readFile(name)
    local file = assert(io.open(directory .. "/" .. name, "rb"))
    local bytes = file:read("*a")
    file:close()
    return bytes
end

function tests.whatIsNoMeshIsAMessage()
    writeFile("empty.mesh", "")
    writeFile("text.mesh", "This is no mesh at all, but somebody's letter.")
    writeSphere("good.mesh", 1)
    writeFile("old.mesh", (readFile("good.mesh"):gsub("MeshSerializer_v1%.100", "MeshSerializer_v9.876")))
    fails("is empty", lodsmith.openMesh(directory .. "/empty.mesh"))
    fails("no OGRE mesh", lodsmith.openMesh(directory .. "/text.mesh"))
    fails("version", lodsmith.openMesh(directory .. "/old.mesh"))
    fails("No such file", lodsmith.openMesh(directory .. "/missing.mesh"))
    fails("regular file", lodsmith.openMesh(directory))
    fails("", lodsmith.openMesh(""))
    same(0, #lodsmith.meshes())
    assert(lodsmith.openMesh(directory .. "/good.mesh"))
end

function tests.aFileCutOffAnywhereIsAMessage()
    writeSphere("good.mesh", 1)
    local bytes = readFile("good.mesh")
    for index = 1, 40 do
        local length = math.floor(#bytes * index / 41)
        writeFile("cut.mesh", bytes:sub(1, length))
        fails("cut.mesh", lodsmith.openMesh(directory .. "/cut.mesh"))
    end
    -- Opening it works once it is whole.
    writeFile("cut.mesh", bytes)
    same(80, assert(lodsmith.openMesh(directory .. "/cut.mesh")):triangles(0))
end

function tests.directoriesAreListed()
    writeSphere("b.mesh", 1)
    writeFile("A.MESH", "")
    writeFile(".hidden.mesh", "")
    writeFile("other.txt", "")
    local list = assert(lodsmith.listDirectory(directory))
    same(directory, list.path)
    assert(directory:find(list.parent, 1, true) == 1)
    same("A.MESH b.mesh", table.concat(list.meshes, " "))
    same(0, #list.directories)
    local above = assert(lodsmith.listDirectory(directory .. "/.."))
    same(list.parent, above.path)
    assert(#above.directories > 0)
    same(nil, assert(lodsmith.listDirectory("/")).parent)
    fails("No such file", lodsmith.listDirectory(directory .. "/nowhere"))
    fails("", lodsmith.listDirectory(directory .. "/b.mesh"))
end

function tests.castsAreChecked()
    writeSphere("a.mesh", 1)
    local mesh = assert(lodsmith.openMesh(directory .. "/a.mesh"))
    assert(lodsmith.definitions:save(mesh, check.levels(40)))
    assert(lodsmith.manager:apply(mesh))
    local meshResource = assert(lodsmith.resource("a.mesh", mesh:group()))
    local definitionResource = assert(lodsmith.resource("a.loddef", mesh:group()))
    same("Mesh", meshResource:type())
    same("LodDefinition", definitionResource:type())
    same("a.mesh", meshResource:name())
    same(mesh:group(), meshResource:group())
    same(nil, lodsmith.toDefinition(meshResource))
    same(nil, lodsmith.toMesh(definitionResource))
    assert(lodsmith.toMesh(meshResource):equals(mesh))
    same(1, lodsmith.toDefinition(definitionResource):levelCount())
    same(nil, lodsmith.resource("b.mesh", mesh:group()))
    same(nil, lodsmith.resource("a.mesh", "no group"))
    raises("lodsmith::Resource", function() lodsmith.toMesh(mesh) end)
end

function tests.aCastSurvivesWhatItWasCastFrom()
    makeSphere("a")
    local resource = assert(lodsmith.resource("a", "General"))
    local mesh = assert(lodsmith.toMesh(resource))
    resource = nil
    collectgarbage()
    same("a", mesh:name())
    resource = assert(lodsmith.resource("a", "General"))
    removeMesh("a")
    same(true, mesh:isGone())
    same(true, resource:isGone())
    same(nil, lodsmith.toMesh(resource))
    same(nil, lodsmith.toDefinition(resource))
    fails("the resource is gone", resource:name())
    fails("the resource is gone", resource:group())
    fails("the resource is gone", resource:type())
end

function tests.anObjectInDisguiseIsAnError()
    makeSphere("a")
    local mesh = check.meshNamed("a")
    local disguised = tolua.cast(mesh, "lodsmith::Definition")
    raises("alive", function() disguised:levelCount() end)
    raises("alive", function() lodsmith.manager:apply(mesh, disguised) end)
    same("a", mesh:name())
    -- The disguise keeps nothing alive.
    mesh = nil
    collectgarbage()
    raises("alive", function() disguised:levelCount() end)
end

function tests.ownershipIsNoAffairOfScripts()
    makeSphere("a")
    local mesh = check.meshNamed("a")
    tolua.takeownership(mesh)
    removeMesh("a")
    fails("the mesh is gone", mesh:name())
    mesh = nil
    collectgarbage()
end

function tests.whatWasFinalisedByHandIsAnError()
    makeSphere("a")
    for _ = 1, 20 do
        local mesh = check.meshNamed("a")
        getmetatable(mesh).__gc(mesh)
        raises("alive", function() mesh:name() end)
        -- Another may have got its address by now.
        same("a", check.meshNamed("a"):name())
        raises("alive", function() mesh:name() end)
        getmetatable(mesh).__gc(mesh)
    end
    collectgarbage()
end

function tests.aFinaliserMayLookAtWhatIsGoingToo()
    makeSphere("a")
    local seen = {}
    do
        local proxy = newproxy(true)
        local mesh = check.meshNamed("a")
        getmetatable(proxy).__gc = function() seen[1] = { pcall(function() return mesh:name() end) } end
    end
    collectgarbage()
    collectgarbage()
    assert(seen[1] and (seen[1][1] == false or seen[1][2] == "a"))
end

return tests
