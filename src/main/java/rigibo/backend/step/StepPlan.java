package rigibo.backend.step;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.ContactStage;
import rigibo.backend.contact.row.IslandForces;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.flight.Course;
import rigibo.backend.flight.Flight;
import rigibo.backend.flight.FreeFlight;
import rigibo.backend.flight.OpenFlight;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.force.GravityKernel;
import rigibo.backend.force.LockedAxesKernel;
import rigibo.backend.force.ThrustKernel;
import rigibo.backend.force.TorqueKernel;
import rigibo.backend.force.WindKernel;
import rigibo.backend.rest.IslandBuilder;
import rigibo.backend.rest.JointedBodies;
import rigibo.backend.rest.LockedBodies;
import rigibo.backend.rest.PileClassifier;
import rigibo.backend.rest.Sleeping;
import rigibo.backend.sense.SensorStage;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Integrator;
import rigibo.backend.setup.StepStage;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.team.Team;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;

/**
 * The stages of a step, compiled from the declared effects and the accuracy: an effect that is not
 * declared adds no stage. Compiled again only when either changes.
 */
public final class StepPlan {

    private final DataStorage data;
    private final List<Part> parts = new ArrayList<>();
    private Effects effects;
    private Accuracy accuracy;

    /** The broad phase; null where contacts are not declared. */
    private Broadphase broadphase;

    /** Shares the work of stages that can be shared; null for one worker. */
    private Team team;

    /** A plan for the data of a pool. */
    public StepPlan(DataStorage data, Effects effects, Accuracy accuracy) {
        this.data = data;
        compile(effects, accuracy);
    }

    /** Shares the work from the next step on; null for one worker. */
    public void share(Team workers) {
        team = workers;
        compile(effects, accuracy);
    }

    /** Compiles the parts of a step. */
    public void compile(Effects declared, Accuracy wanted) {
        effects = declared;
        accuracy = wanted;
        parts.clear();
        StepBodies bodies = new StepBodies(data);
        ChangingForces forces = new ChangingForces(declared);
        if (data.bodies.lockedX != null) {
            forces.holdAxes(data.bodies);
        }
        boolean areIntegrated = !forces.isEmpty() || wanted.integrator() != Integrator.BALLISTIC;
        data.bodies.integratePaths(areIntegrated);
        Course course = areIntegrated ? new Course(data, forces, wanted) : null;
        add(StepStage.ACCEPT, "list the bodies that move", bodies::accept);
        compileEffects(bodies, course);
        if (declared.declares(Contacts.class)) {
            broadphase = broadphase == null ? new Broadphase(data) : broadphase;
            broadphase.senses = declared.declares(Sensors.class);
            compileContacts(bodies, course, areIntegrated ? new IslandForces(data, forces) : null);
        } else {
            broadphase = null;
            OpenFlight flight = new OpenFlight(data, course);
            add(StepStage.FLIGHT, "move every body along its exact path", flight::fly);
        }
        add(StepStage.REST, "move driven bodies", bodies::moveDriven);
        // A function of the caller may change its force, and a sleeping body would not notice.
        declared.find(Sleep.class)
                .filter(sleep -> !declared.holdFunctions())
                .ifPresent(
                        sleep ->
                                add(
                                        StepStage.REST,
                                        "put islands to sleep that stayed in place",
                                        new Sleeping(data, sleep)::settle));
        add(StepStage.REPORT, "put to rest what stopped being finite", bodies::quarantine);
        if (broadphase != null) {
            add(StepStage.REPORT, "fixtures of what left its own", dt -> broadphase.coverPoses());
        }
        if (declared.declares(Sensors.class)) {
            add(
                    StepStage.REPORT,
                    "tell who is inside of sensors",
                    new SensorStage(data, broadphase)::sense);
        }
    }

    private void compileEffects(StepBodies bodies, Course course) {
        add(StepStage.EFFECTS, "begin with no acceleration", bodies::clearAccelerations);
        effects.find(Gravity.class)
                .ifPresent(
                        gravity ->
                                add(
                                        StepStage.EFFECTS,
                                        "gravity",
                                        new GravityKernel(data, gravity)::accelerate));
        if (effects.declares(Thrust.class)) {
            TorqueKernel torque = data.bodies.turns() ? new TorqueKernel(data) : null;
            add(StepStage.EFFECTS, "thrust", new ThrustKernel(data, torque)::accelerate);
        }
        effects.find(Wind.class)
                .filter(wind -> wind.isSteady() && effects.declares(Drag.class))
                .ifPresent(
                        wind ->
                                add(
                                        StepStage.EFFECTS,
                                        "steady wind",
                                        new WindKernel(data, wind)::accelerate));
        if (data.bodies.lockedX != null) {
            add(
                    StepStage.EFFECTS,
                    "bear what pulls along locked axes",
                    new LockedAxesKernel(data)::hold);
        }
        if (course != null) {
            add(StepStage.EFFECTS, "integrate forces that change along the way", course::begin);
        }
        add(StepStage.EFFECTS, "refuse forces beyond all bounds", bodies::quarantine);
    }

    private void compileContacts(StepBodies bodies, Course course, IslandForces forces) {
        ImpactMode mode =
                effects.declares(ContinuousImpacts.class)
                        ? accuracy.impacts()
                        : ImpactMode.DISCRETE;
        Narrowphase narrowphase = new Narrowphase(data);
        if (team != null) {
            narrowphase.share(team);
        }
        PileClassifier classifier = new PileClassifier(data, accuracy, mode);
        add(StepStage.BROADPHASE, "size fixtures and candidate pairs", broadphase::update);
        add(StepStage.CLASSIFY, "begin with all bodies in flight", bodies::scatter);
        if (mode == ImpactMode.DISCRETE) {
            add(StepStage.CLASSIFY, "manifolds of pairs that touch", dt -> narrowphase.collide(0));
        } else {
            add(StepStage.CLASSIFY, "manifolds of pairs that may touch", narrowphase::collide);
        }
        JointedBodies jointed = effects.declares(Joints.class) ? new JointedBodies(data) : null;
        if (jointed != null) {
            add(StepStage.CLASSIFY, "take what joints hold for piled", jointed::pile);
        }
        if (data.bodies.lockedX != null) {
            add(
                    StepStage.CLASSIFY,
                    "take what is locked along an axis for piled",
                    new LockedBodies(data)::pile);
        }
        add(
                StepStage.CLASSIFY,
                "measure contacts, and find what rests on them",
                classifier::classify);
        if (mode == ImpactMode.EVENTS) {
            add(
                    StepStage.FLIGHT,
                    "move bodies in flight from impact to impact, in the order of time",
                    new Flight(data, narrowphase, broadphase, accuracy, course)::fly);
        } else if (mode == ImpactMode.SPLIT) {
            add(
                    StepStage.FLIGHT,
                    "find what is driven into others, and move bodies in flight along their paths",
                    new Flight(data, narrowphase, broadphase, accuracy, course)::fly);
        } else {
            add(
                    StepStage.FLIGHT,
                    "move bodies in flight along their exact paths",
                    new FreeFlight(data, course)::fly);
        }
        if (jointed != null) {
            add(StepStage.CONTACT, "find the joints of who was woken", jointed::pileWoken);
        }
        IslandBuilder islands = new IslandBuilder(data);
        add(StepStage.CONTACT, "group bodies in contact into islands", dt -> islands.build());
        add(
                StepStage.CONTACT,
                "solve islands in " + accuracy.substeps() + " substeps: " + rowsInWords(),
                new ContactStage(data, narrowphase, effects, accuracy, forces, team)::solve);
    }

    private String rowsInWords() {
        List<String> rows = new ArrayList<>(List.of("loads"));
        addIf(Friction.class, "friction", rows);
        addIf(RollingResistance.class, "rolling", rows);
        addIf(SurfaceSpeed.class, "running surfaces", rows);
        addIf(Restitution.class, "impacts", rows);
        addIf(Rotation.class, "faces that turn", rows);
        addIf(Joints.class, "joints", rows);
        if (data.bodies.lockedX != null) {
            rows.add("locked axes");
        }
        return String.join(", ", rows);
    }

    private void addIf(Class<? extends Effect> effect, String row, List<String> rows) {
        if (effects.declares(effect)) {
            rows.add(row);
        }
    }

    /** Advances by {@code dt} seconds; the clock returns ns. */
    public void run(double dt, LongSupplier clock) {
        data.beginStep();
        long before = clock.getAsLong();
        for (int i = 0; i < parts.size(); i++) {
            Part part = parts.get(i);
            part.work.run(dt);
            long after = clock.getAsLong();
            data.counters.nanos[part.stage.ordinal()] += after - before;
            before = after;
        }
        if (team != null) {
            data.counters.splits = team.takeSplits();
            data.counters.spared = team.takeSpared();
        }
    }

    /** The broad phase; null where contacts are not declared. */
    public Broadphase broadphase() {
        return broadphase;
    }

    public Effects effects() {
        return effects;
    }

    public Accuracy accuracy() {
        return accuracy;
    }

    /** A description of the parts, one line each, headed by the stage to which it belongs. */
    public String describe() {
        StringBuilder words = new StringBuilder();
        for (Part part : parts) {
            words.append(String.format("%-10s %s%n", part.stage, part.words));
        }
        return words.append("columns    ")
                .append(data.bodies.declaredColumns())
                .append(": ")
                .append(data.bodies.bitsPerBody())
                .append(" bits a body")
                .toString();
    }

    private void add(StepStage stage, String words, Work work) {
        parts.add(new Part(stage, words, work));
    }

    private record Part(StepStage stage, String words, Work work) {}

    private interface Work {
        void run(double dt);
    }
}
