#include <lodsmith/ogre/PMInjector.h>

#include "GenerationQueue.h"
#include "MainThread.h"

#include <lodsmith/core/Assert.h>

#include <OgreRoot.h>

#include <utility>

namespace lodsmith {

PMInjector::PMInjector(std::shared_ptr<GenerationQueue> queue, Milliseconds budget) : mQueue(std::move(queue))
{
    setBudget(budget);
    Ogre::Root::getSingleton().addFrameListener(this);
}

PMInjector::~PMInjector()
{
    // OGRE may have been taken down first.
    if (Ogre::Root* root = Ogre::Root::getSingletonPtr())
        root->removeFrameListener(this);
}

// A handler of a signal may destroy this object and the generator; the queue's table lives on until it has returned.

void PMInjector::update()
{
    assertMainThread();
    const std::shared_ptr<GenerationQueue> queue = mQueue;
    queue->work(mBudget);
}

void PMInjector::injectNow()
{
    assertMainThread();
    const std::shared_ptr<GenerationQueue> queue = mQueue;
    queue->injectNow();
}

void PMInjector::finishAll()
{
    assertMainThread();
    const std::shared_ptr<GenerationQueue> queue = mQueue;
    queue->finishAll();
}

void PMInjector::setBudget(Milliseconds budget)
{
    LODSMITH_ASSERT(budget >= Milliseconds::zero(), "the budget of a frame is a number from 0 on");
    mBudget = budget;
}

bool PMInjector::frameStarted(const Ogre::FrameEvent&)
{
    update();
    return true;
}

} // namespace lodsmith
