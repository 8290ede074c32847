package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.row.SharedRows;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Pairs;
import rigibo.backend.team.Team;

/**
 * Shares the islands of a step among the workers of a team. Islands have no moving body in common,
 * and a solver keeps nothing from one island to the next, so that no bit depends on which worker
 * solves an island. An island that is most of the work is solved first, by all workers together.
 * Two cases need care. Islands on one driven body are solved by one worker, since {@link
 * rigibo.backend.contact.row.CarriedFrame} stops their carrier while it solves them. And the lists
 * to which several islands add, of impacts, broken joints and bodies put to rest, are written by
 * each worker for itself and joined in the order of islands.
 */
final class SharedIslands implements Team.Pieces {

    /**
     * Contacts and joints besides those of the largest island from which on islands are shared.
     * Solving one takes a microsecond or more, waking a worker some ten.
     */
    private static final int WORTHWHILE = 64;

    private static final int NONE = -1;

    /** Stands for all islands that driven bodies carry. */
    private static final int CARRIED = -2;

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;
    private final Team team;

    /**
     * The workers that solve islands side by side; the last one solves the island that all share.
     */
    private final IslandWorker[] workers;

    private final SharedNotes notes;

    /** The islands in the order in which workers take them, and those that are carried. */
    private final Found order = new Found();

    private final Found carried = new Found();
    private double dt;

    /** The island that all workers solve together, or {@link #NONE}. */
    private int together;

    SharedIslands(DataStorage data, Effects effects, Accuracy accuracy, Team team) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        this.team = team;
        workers = new IslandWorker[team.size() + 1];
        for (int i = 0; i < team.size(); i++) {
            DataStorage own = data.forWorker();
            workers[i] = new IslandWorker(own, new Narrowphase(own), effects, accuracy, null, null);
        }
        DataStorage own = data.forWorker();
        Narrowphase narrowphase = new Narrowphase(own);
        narrowphase.share(team);
        workers[team.size()] = new IslandWorker(own, narrowphase, effects, accuracy, null, team);
        notes = new SharedNotes(data, workers);
    }

    /**
     * Finds out whether all workers solve the largest island together; returns whether there is
     * enough to share besides it.
     */
    boolean prepare() {
        int largest = 0;
        int all = 0;
        for (int island = 0; island < islands.count; island++) {
            all += size(island);
            largest = size(island) > size(largest) ? island : largest;
        }
        // One that would keep a worker longer than its share of the whole is solved by all.
        boolean isMost = size(largest) * team.size() > all && !islands.areJoined(largest);
        together = isMost && size(largest) >= SharedRows.WORTHWHILE ? largest : NONE;
        return islands.count > 1 && all - size(largest) >= WORTHWHILE;
    }

    private int size(int island) {
        int contacts = islands.pairStart[island + 1] - islands.pairStart[island];
        boolean isJoined = islands.jointStart != null;
        int first = isJoined ? islands.jointStart[island] : 0;
        return contacts + (isJoined ? islands.jointStart[island + 1] - first : 0);
    }

    /** Advances every island to the end of a step of {@code dt} seconds. */
    void solve(double dt) {
        this.dt = dt;
        findOrder();
        notes.begin();
        if (together != NONE) {
            solve(together, team.size());
        }
        team.split(order.count, 1, this);
        notes.gather();
        for (IslandWorker worker : workers) {
            worker.tellWork(data.counters);
        }
        data.counters.sharedIslands = islands.count;
    }

    /** Lists all other islands, the largest first, so that none waits for it at the end. */
    private void findOrder() {
        order.clear();
        carried.clear();
        boolean mayCarry = isAnyDriven();
        for (int island = 0; island < islands.count; island++) {
            if (island != together && mayCarry && isCarried(island)) {
                carried.add(island);
            } else if (island != together) {
                order.add(island);
            }
        }
        if (carried.count > 0) {
            order.add(CARRIED);
        }
        int largest = 0;
        for (int i = 0; i < order.count; i++) {
            largest = sizeOf(order.numbers[i]) > sizeOf(order.numbers[largest]) ? i : largest;
        }
        int first = order.numbers[0];
        order.numbers[0] = order.numbers[largest];
        order.numbers[largest] = first;
    }

    private int sizeOf(int entry) {
        if (entry != CARRIED) {
            return size(entry);
        }
        int all = 0;
        for (int i = 0; i < carried.count; i++) {
            all += size(carried.numbers[i]);
        }
        return all;
    }

    private boolean isAnyDriven() {
        boolean isAny = false;
        for (int i = 0; !isAny && i < data.roster.awakeCount; i++) {
            isAny = bodies.isDriven(data.roster.awake[i]);
        }
        return isAny;
    }

    /** Whether a driven body touches a body of an island, or is joined to one. */
    private boolean isCarried(int island) {
        boolean isCarried = false;
        for (int i = islands.pairStart[island];
                !isCarried && i < islands.pairStart[island + 1];
                i++) {
            int pair = islands.pairs[i];
            isCarried = bodies.isDriven(pairs.bodyA[pair]) || bodies.isDriven(pairs.bodyB[pair]);
        }
        int end = islands.areJoined(island) ? islands.jointStart[island + 1] : 0;
        for (int i = end == 0 ? 0 : islands.jointStart[island]; !isCarried && i < end; i++) {
            isCarried = isHeldByDriven(data.joints, islands.joints[i]);
        }
        return isCarried;
    }

    private boolean isHeldByDriven(JointStore joints, int joint) {
        return bodies.isDriven(joints.bodyA[joint]) || bodies.isDriven(joints.bodyB[joint]);
    }

    @Override
    public void run(int from, int to, int worker) {
        for (int at = from; at < to; at++) {
            if (order.numbers[at] == CARRIED) {
                for (int i = 0; i < carried.count; i++) {
                    solve(carried.numbers[i], worker);
                }
            } else {
                solve(order.numbers[at], worker);
            }
        }
    }

    private void solve(int island, int worker) {
        notes.open(island, worker);
        workers[worker].solve(island, dt);
        notes.close(island, worker);
    }
}
