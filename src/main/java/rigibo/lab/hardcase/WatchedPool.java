package rigibo.lab.hardcase;

import rigibo.backend.ContactEvent;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.StepReport;
import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;
import rigibo.lab.child.ThreadUse;
import rigibo.lab.truth.Solid;

import java.util.List;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;

/** A pool whose every step is checked against the laws that hold in every case. */
final class WatchedPool {

    /** The most bodies of a pool whose state is hashed after every step. */
    private static final int FEW = 8;

    /** The number of steps between two hashes of a larger pool. */
    private static final int STEPS_PER_HASH = 16;

    /** Effects that add energy, or store energy that is not counted here. */
    private static final List<Class<? extends Effect>> FROM_OUTSIDE =
            List.of(
                    Thrust.class,
                    SurfaceSpeed.class,
                    Wind.class,
                    Buoyancy.class,
                    CentralForce.class,
                    Fan.class,
                    Magnet.class,
                    Field.class);

    private final Trial trial;
    private final String variant;
    private final Pool pool;
    private final Gravity gravity;
    private final Balance balance;
    private final Overlap overlap = new Overlap();
    private EnergyGuard guard;
    private DoubleSupplier workOfStep = () -> 0;
    private boolean isWorkKnown;
    private boolean isEnergyKept;
    private boolean isMomentumKept;
    private boolean mayOverlap;
    private double deepestShare;
    private int steps;
    private long allocated;

    WatchedPool(Trial trial, String variant, Effects effects) {
        this.trial = trial;
        this.variant = variant;
        pool = new Pool(effects, trial.preset().accuracy());
        pool.workers(trial.workers());
        gravity = effects.find(Gravity.class).orElse(new Gravity(0, 0));
        balance = new Balance(gravity);
        isEnergyKept = FROM_OUTSIDE.stream().noneMatch(effects::declares);
        isMomentumKept =
                isEnergyKept && !effects.declares(Drag.class) && !effects.declares(AirDrag.class);
    }

    RigidBody add(BodyDefinition definition) {
        isMomentumKept &= definition.type() == BodyType.DYNAMIC && definition.gravityScale() == 1;
        isEnergyKept &= definition.type() != BodyType.KINEMATIC && definition.gravityScale() == 1;
        changed();
        return pool.add(trial.made(definition));
    }

    /** Joins two bodies; the energy of its spring counts, the work of its motor does not. */
    Joint join(JointDefinition definition) {
        isMomentumKept = false;
        changed();
        return pool.join(definition);
    }

    /** A fixed body to hang others on; it collides with nothing. */
    RigidBody hook(double x, double y) {
        return add(BodyDefinition.fixed(new Circle(0.01)).at(x, y).filter(Filter.ALL.mask(0)));
    }

    /** A stack of boxes of 1 m on the floor, the lowest first. */
    List<RigidBody> stack(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> add(Solid.box(1, 1).at(0, i + 0.5)))
                .toList();
    }

    /** Turns the check of energy off, for scenes with their own limit, such as that of a swing. */
    WatchedPool withEnergyOfItsOwn() {
        isEnergyKept = false;
        return this;
    }

    /** The largest present error of a joint, m. */
    double jointError() {
        return pool.joints().stream().mapToDouble(Joint::error).max().orElse(0);
    }

    /** Records the largest present error of a joint. */
    void measureJoints() {
        trial.measure("error of joints", jointError(), "m", JointLimits.ERROR);
    }

    /** The energy of motion, height and springs, J. */
    double energy() {
        return pool.kineticEnergy() + pool.potentialEnergy() + springs();
    }

    private double springs() {
        return pool.joints().stream().mapToDouble(Joint::energy).sum();
    }

    /** Turns the checks of overlap and energy off, for scenes in overlap or crushed. */
    WatchedPool allowingOverlap() {
        mayOverlap = true;
        isEnergyKept = false;
        return this;
    }

    /** Turns the check of overlap off, for scenes with their own limit. */
    WatchedPool withOverlapOfItsOwn() {
        mayOverlap = true;
        return this;
    }

    /**
     * Checks the energy against that of the start plus the work of driven bodies.
     *
     * @param work of the last step, J, asked after each
     */
    void countWork(DoubleSupplier work) {
        workOfStep = work;
        isWorkKnown = true;
    }

    /** The present speed of the fastest dynamic body, m/s. */
    double fastest() {
        double fastest = 0;
        for (RigidBody body : pool.bodies()) {
            boolean isAsked = body.type() == BodyType.DYNAMIC;
            double speed = Math.hypot(body.velocityX(), body.velocityY());
            fastest = isAsked ? Math.max(fastest, speed) : fastest;
        }
        return fastest;
    }

    /** Restarts the balances, after a change from outside. */
    void changed() {
        balance.restart();
        guard = null;
    }

    void remove(RigidBody body) {
        pool.remove(body);
        changed();
    }

    StepReport step() {
        return step(Trial.DT);
    }

    StepReport step(double dt) {
        balance.begin(pool.bodies(), springs());
        if (guard == null && (isEnergyKept || isWorkKnown)) {
            guard = new EnergyGuard(pool.bodies(), gravity, springs());
        }
        long before = ThreadUse.bytes();
        StepReport report = pool.step(dt);
        allocated += ThreadUse.bytes() - before;
        steps++;
        trial.count(report);
        watch(dt);
        if (pool.bodies().size() <= FEW || steps % STEPS_PER_HASH == 0) {
            trial.fold(pool.stateHash());
        }
        return report;
    }

    /** Makes steps of the game's length for a time in s. */
    void run(double seconds) {
        long count = Math.round(seconds / Trial.DT);
        for (long i = 0; i < count; i++) {
            step();
        }
    }

    Pool pool() {
        return pool;
    }

    double time() {
        return pool.time();
    }

    /** The bytes that the engine has allocated in all steps so far. */
    long allocated() {
        return allocated;
    }

    /** The deepest present overlap in widths of the smaller body, measured without the engine. */
    double overlapNow() {
        return overlap.deepestShare(pool.bodies());
    }

    /** The deepest overlap after any step so far, as a share of the smaller body's width. */
    double deepestShare() {
        return deepestShare;
    }

    /** The normal impulse between two bodies in the last step, N·s. */
    double impulseBetween(RigidBody one, RigidBody other) {
        double sum = 0;
        for (ContactEvent event : pool.contactEvents()) {
            boolean isPair =
                    event.a() == one && event.b() == other
                            || event.a() == other && event.b() == one;
            sum += isPair ? event.impulse() : 0;
        }
        return sum;
    }

    private void watch(double dt) {
        String where = variant + " step " + steps;
        trial.notFinite(balance.end(pool.bodies(), springs(), dt), where);
        if (isEnergyKept) {
            trial.energyGain(balance.energyGainShare(), where);
        }
        if (guard != null) {
            guard.add(workOfStep.getAsDouble());
            trial.energyBeyondStart(guard.beyond(pool.bodies(), springs()), where);
        }
        if (isMomentumKept) {
            trial.momentumError(balance.momentumErrorShare(), where);
        }
        deepestShare = Math.max(deepestShare, overlapNow());
        if (!mayOverlap) {
            trial.overlap(deepestShare, where);
        }
    }
}
