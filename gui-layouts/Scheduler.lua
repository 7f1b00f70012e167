-- Which edit is generated next: one generation at a time, and of the edits that come meanwhile the newest. A stream of
-- edits therefore shows what lies between, and its last one always wins. No CEGUI in here.

local Scheduler = {}
Scheduler.__index = Scheduler

-- worker: {apply = function(mesh, definition) -> decision | nil, message; isQueued = function(mesh);
--          cancel = function(mesh)}
-- queued: the decision that means that generation goes on in the background
-- done:   function(mesh, message or nil), for what needed no generation and for what was refused
function Scheduler.new(worker, queued, done)
    return setmetatable({worker = worker, queued = queued, done = done}, Scheduler)
end

function Scheduler:request(mesh, definition)
    self.waiting = {mesh = mesh, definition = definition}
    self:update()
end

-- The generation of a mesh has come to an end, well or not.
function Scheduler:finished(mesh)
    if self.running and self.running:equals(mesh) then
        self.running = nil
    end
end

function Scheduler:isBusy()
    return self.running ~= nil or self.waiting ~= nil
end

-- Nothing is generated any more, nor waits for it.
function Scheduler:cancel()
    self.waiting = nil
    if self.running then
        self.worker.cancel(self.running)
        self.running = nil
    end
end

-- Once a frame. Asks the queue too: a generation can vanish without a signal, with its mesh for example.
function Scheduler:update()
    if self.running and not self.worker.isQueued(self.running) then
        self.running = nil
    end
    if self.running or not self.waiting then
        return
    end
    local mesh = self.waiting.mesh
    if self.worker.isQueued(mesh) then
        self.running = mesh
        return
    end
    local definition = self.waiting.definition
    self.waiting = nil
    local decision, message = self.worker.apply(mesh, definition)
    if decision == self.queued then
        self.running = mesh
    else
        self.done(mesh, decision == nil and message or nil)
    end
end

return Scheduler
