package rigibo.backend.broadphase;

import rigibo.backend.storage.DataStorage;

/** Size fixtures and candidate pairs. */
public final class Broadphase {

    public Broadphase(DataStorage data) {}

    public void add(int slot) {}

    public void remove(int slot) {}

    public void refit(int slot) {}

    public void forgetContacts(int slot) {}

    public void forgetPairs(int slot) {}
}
