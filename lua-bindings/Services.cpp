#include "Services.h"

#include <sigc++/functors/mem_fun.h>

namespace lodsmith::lua {

Services::Services(LodDefinitionManager& definitionManager, LodManager& lodManager,
                   QueuedProgressiveMeshGenerator& generatorQueue)
    : definitions(definitionManager), manager(lodManager), queue(generatorQueue)
{
    PMInjectorSignaler& signals = queue.signals();
    mFromQueue[0] = signals.injected.connect(injected.make_slot());
    mFromQueue[1] = signals.failed.connect(failed.make_slot());
    mFromQueue[2] = signals.progress.connect(progress.make_slot());
}

Services::~Services()
{
    for (sigc::connection& connection : mFromQueue)
        connection.disconnect();
    // Whatever is being emitted just now ends here.
    injected.clear();
    failed.clear();
    progress.clear();
}

ServiceHandle::ServiceHandle(const char* typeName, const char* what, const std::shared_ptr<Services>& services)
    : Handle(typeName), mWhat(what), mServices(services)
{
}

Returned ServiceHandle::gone() const
{
    return Returned::failure(std::string("the ") + mWhat + " is gone");
}

Connection::Connection(const sigc::connection& connection) : Handle("lodsmith::Connection"), mConnection(connection) {}

Connection::~Connection()
{
    mConnection.disconnect();
}

Returned Connection::disconnect()
{
    mConnection.disconnect();
    return true;
}

Returned Connection::isConnected() const
{
    return mConnection.connected();
}

} // namespace lodsmith::lua
