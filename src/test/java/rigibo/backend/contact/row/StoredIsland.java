package rigibo.backend.contact.row;

import rigibo.backend.Pool;
import rigibo.backend.PoolStorage;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * Islands in the columns of a pool that never steps, with contacts written by hand, and the classes
 * that pack them.
 */
public final class StoredIsland {

    public final DataStorage data;
    public final Bodies bodies;
    public final Pairs pairs;
    public final Motions motions;
    public final PackedContacts contacts = new PackedContacts();

    /** Null where bodies do not turn. */
    public final PackedTurns turns;

    public final RowBuilder builder;

    private final Pool pool;
    private int count;

    /** An island without bodies. */
    public StoredIsland(Effects effects) {
        pool = new Pool(effects, Accuracy.GAME);
        data = PoolStorage.of(pool);
        bodies = data.bodies;
        pairs = data.pairs;
        data.islands.count = 1;
        motions = new Motions(bodies.turns());
        turns = bodies.turns() ? new PackedTurns(bodies, motions) : null;
        builder = new RowBuilder(data, motions, contacts, turns);
    }

    /** An island without bodies, with contacts and rotation. */
    public static StoredIsland turning() {
        return new StoredIsland(Effects.of(new Contacts(), new Rotation()));
    }

    /** Measures the island's contacts again. */
    FreshRows fresh() {
        return new FreshRows(
                data,
                new Narrowphase(data),
                motions,
                contacts,
                builder,
                new SharedRows(null, contacts));
    }

    /** Adds a body, to the island if it is dynamic; returns its slot. */
    public int body(BodyDefinition definition) {
        pool.add(definition);
        if (bodies.isDynamic(count)) {
            Islands islands = data.islands;
            int end = islands.bodyStart[islands.count]++;
            if (end == islands.bodies.length) {
                islands.bodies = Arrays.copyOf(islands.bodies, 2 * end);
            }
            islands.bodies[end] = count;
        }
        return count++;
    }

    /** Adds a contact without points, with a normal at an angle in rad; returns its pair. */
    public int contact(int a, int b, double angle) {
        int pair = pairs.add(bodies, a, b);
        pairs.normalX[pair] = Math.cos(angle);
        pairs.normalY[pair] = Math.sin(angle);
        Islands islands = data.islands;
        int end = islands.pairStart[islands.count]++;
        if (end == islands.pairs.length) {
            islands.pairs = Arrays.copyOf(islands.pairs, 2 * end);
        }
        islands.pairs[end] = pair;
        return pair;
    }

    /** Adds a point to a contact, m. */
    public void point(int pair, double x, double y, double separation) {
        int point = 2 * pair + pairs.points[pair]++;
        pairs.pointX[point] = x;
        pairs.pointY[point] = y;
        pairs.separation[point] = separation;
    }

    /** Starts another island for bodies and contacts that are added from now on. */
    public void beginIsland() {
        int last = data.islands.count++;
        data.islands.bodyStart[last + 1] = data.islands.bodyStart[last];
        data.islands.pairStart[last + 1] = data.islands.pairStart[last];
    }
}
