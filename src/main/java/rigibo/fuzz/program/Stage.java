package rigibo.fuzz.program;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;

import java.util.Map;
import java.util.TreeMap;

/** The pool of a running program, and its bodies by the program's numbers. */
public final class Stage {

    private final Witness witness;
    private final Map<Integer, RigidBody> bodies = new TreeMap<>();
    private Pool pool;

    Stage(Pool pool, Witness witness) {
        this.pool = pool;
        this.witness = witness;
    }

    /** The present pool; a program may continue with a restored one. */
    public Pool pool() {
        return pool;
    }

    /** The number of bodies that the program has added so far. */
    public int added() {
        return bodies.size();
    }

    boolean knows(int number) {
        return bodies.containsKey(number);
    }

    /** The body with a number, possibly removed. */
    RigidBody body(int number) {
        return bodies.get(number);
    }

    /** The name of the body with a number, by which it is found in a restored pool. */
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

    /** A separate stage with the restored pool and no witness. */
    public Stage copy() {
        Stage copy = new Stage(pool, Witness.NONE);
        copy.bodies.putAll(bodies);
        copy.goOnRestored();
        return copy;
    }

    /** Continues with the pool restored from its own snapshot. */
    void goOnRestored() {
        pool = restored(pool.snapshot());
        for (RigidBody body : pool.bodies()) {
            bodies.put(Integer.parseInt(body.name().substring(1)), body);
        }
        witness.restored(pool);
    }

    /** Functions of effects are not saved and are passed again. */
    Pool restored(byte[] snapshot) {
        return pool.effects().holdFunctions()
                ? Pool.restore(snapshot, pool.effects())
                : Pool.restore(snapshot);
    }
}
