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

/** A pool whose every step is held to what is true in every case. */
final class WatchedPool {

    /** Bodies up to which the state is hashed after every step. */
    private static final int FEW = 8;

    /** Steps between two hashes of a pool of many bodies. */
    private static final int STEPS_PER_HASH = 16;

    /** Effects that put energy in, or keep some that the books do not know. */
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

    /** Something fixed to hang other things on, which meets nobody. */
    RigidBody hook(double x, double y) {
        return add(BodyDefinition.fixed(new Circle(0.01)).at(x, y).filter(Filter.ALL.mask(0)));
    }

    /** Boxes of 1 m on each other, the lowest on the floor, from there upwards. */
    List<RigidBody> stack(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> add(Solid.box(1, 1).at(0, i + 0.5)))
                .toList();
    }

    /** For scenes whose limit of energy is their own, as that of a swing. */
    WatchedPool withEnergyOfItsOwn() {
        isEnergyKept = false;
        return this;
    }

    /** Most that the joints are off from what they hold now, m. */
    double jointError() {
        return pool.joints().stream().mapToDouble(Joint::error).max().orElse(0);
    }

    /** Keeps by how much all joints are off now. */
    void measureJoints() {
        trial.measure("error of joints", jointError(), "m", JointLimits.ERROR);
    }

    /** Of motion, height and springs, J. */
    double energy() {
        return pool.kineticEnergy() + pool.potentialEnergy() + springs();
    }

    private double springs() {
        return pool.joints().stream().mapToDouble(Joint::energy).sum();
    }

    /** For scenes that begin in overlap or are crushed: how deep is not judged at every step. */
    WatchedPool allowingOverlap() {
        mayOverlap = true;
        isEnergyKept = false;
        return this;
    }

    /** For scenes whose limit of overlap is their own. */
    WatchedPool withOverlapOfItsOwn() {
        mayOverlap = true;
        return this;
    }

    /**
     * Has the energy held to that of the start and to what driven bodies do.
     *
     * @param work of the last step, J, asked after each
     */
    void countWork(DoubleSupplier work) {
        workOfStep = work;
        isWorkKnown = true;
    }

    /** Fastest dynamic body now, m/s. */
    double fastest() {
        double fastest = 0;
        for (RigidBody body : pool.bodies()) {
            boolean isAsked = body.type() == BodyType.DYNAMIC;
            double speed = Math.hypot(body.velocityX(), body.velocityY());
            fastest = isAsked ? Math.max(fastest, speed) : fastest;
        }
        return fastest;
    }

    /** After something was changed from outside, the books begin anew. */
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

    /** Steps of the game's length until so much time has passed. */
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

    /** Bytes that the engine has allocated in all steps up to now. */
    long allocated() {
        return allocated;
    }

    /** Deepest overlap now as a share of the smaller body's width, by our own measure. */
    double overlapNow() {
        return overlap.deepestShare(pool.bodies());
    }

    /** Deepest overlap seen at any step, as a share of the smaller body's width. */
    double deepestShare() {
        return deepestShare;
    }

    /** Normal impulse between two bodies in the last step, N·s. */
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
