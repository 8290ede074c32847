package rigibo.backend.contact;

import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;

/**
 * The workers' records of the islands that they solve: impacts, broken joints and bodies put to
 * rest. Each worker has lists of its own; joined in the order of islands, they equal the lists of a
 * single worker.
 */
final class SharedNotes {

    /** Per island: start and end of its hits, broken joints and bodies put to rest; its worker. */
    private static final int STRIDE = 7;

    private static final int WORKER = 6;

    private final DataStorage data;
    private final IslandWorker[] workers;
    private int[] notes = new int[0];

    SharedNotes(DataStorage data, IslandWorker[] workers) {
        this.data = data;
        this.workers = workers;
    }

    void begin() {
        if (notes.length < STRIDE * data.islands.count) {
            notes = new int[2 * STRIDE * data.islands.count];
        }
        for (IslandWorker worker : workers) {
            worker.data.beginShared(data);
        }
    }

    /** Begins the notes of an island. */
    void open(int island, int worker) {
        notes[STRIDE * island + WORKER] = worker;
        write(STRIDE * island, worker);
    }

    /** Ends the notes of an island. */
    void close(int island, int worker) {
        write(STRIDE * island + 1, worker);
    }

    private void write(int at, int worker) {
        DataStorage own = workers[worker].data;
        notes[at] = own.hits == null ? 0 : own.hits.count;
        notes[at + 2] = own.broken.count;
        notes[at + 4] = own.counters.quarantinedCount;
    }

    /** Adds all notes to those of the step, in the order of islands. */
    void gather() {
        for (int island = 0; island < data.islands.count; island++) {
            int at = STRIDE * island;
            gather(at, workers[notes[at + WORKER]].data);
        }
    }

    private void gather(int at, DataStorage own) {
        if (notes[at] < notes[at + 1]) {
            data.hits.append(own.hits, notes[at], notes[at + 1]);
        }
        for (int i = notes[at + 2]; i < notes[at + 3]; i++) {
            data.broken.add(own.broken.numbers[i]);
        }
        Counters counters = own.counters;
        for (int i = notes[at + 4]; i < notes[at + 5]; i++) {
            data.counters.quarantine(counters.quarantined[i]);
        }
    }
}
