package rigibo.fuzz.program;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;

import java.util.Map;
import java.util.TreeMap;

/** What a program acts on: a pool, and its bodies by the numbers that the program gives them. */
public final class Stage {

    private final Witness witness;
    private final Map<Integer, RigidBody> bodies = new TreeMap<>();
    private Pool pool;

    Stage(Pool pool, Witness witness) {
        this.pool = pool;
        this.witness = witness;
    }

    /** The pool at present: a program may go on with a restored one. */
    public Pool pool() {
        return pool;
    }

    /** How many bodies the program has added so far. */
    public int added() {
        return bodies.size();
    }

    boolean knows(int number) {
        return bodies.containsKey(number);
    }

    /** The body with a number, in its pool or removed. */
    RigidBody body(int number) {
        return bodies.get(number);
    }

    /** What bodies are called: a restored pool's are known by it. */
    static String name(int number) {
        return "b" + number;
    }

    void add(int number, BodyDefinition definition) {
        bodies.put(number, pool.add(definition));
    }

    void step(double dt) {
        witness.beforeStep(pool);
        pool.step(dt);
        witness.stepped(pool, dt);
    }

    Witness witness() {
        return witness;
    }

    /** A stage of its own with the restored pool, which nobody looks at. */
    public Stage copy() {
        Stage copy = new Stage(pool, Witness.NONE);
        copy.bodies.putAll(bodies);
        copy.goOnRestored();
        return copy;
    }

    /** Goes on with the pool that its own snapshot makes. */
    void goOnRestored() {
        pool = restored(pool.snapshot());
        for (RigidBody body : pool.bodies()) {
            bodies.put(Integer.parseInt(body.name().substring(1)), body);
        }
        witness.restored(pool);
    }

    /** The functions among the effects cannot be written and are handed in again. */
    Pool restored(byte[] snapshot) {
        return pool.effects().holdFunctions()
                ? Pool.restore(snapshot, pool.effects())
                : Pool.restore(snapshot);
    }
}
