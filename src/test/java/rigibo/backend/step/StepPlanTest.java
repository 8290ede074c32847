package rigibo.backend.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Integrator;
import rigibo.backend.setup.StepStage;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;

import java.util.ArrayList;
import java.util.List;

/** A step consists of the declared effects and nothing else. */
class StepPlanTest {

    private static final Gravity GRAVITY = new Gravity(0, -8);
    private static final Field FIELD = new Field(at -> at.accelerate(1, 0));

    /** The parts of any step, where nothing is declared. */
    private static final List<String> BARE =
            List.of(
                    "ACCEPT     list the bodies that move",
                    "EFFECTS    begin with no acceleration",
                    "EFFECTS    refuse forces beyond all bounds",
                    "FLIGHT     move every body along its exact path",
                    "REST       move driven bodies",
                    "REPORT     put to rest what stopped being finite");

    private static final String CHANGING = "EFFECTS    integrate forces that change along the way";
    private static final String SLEEP = "REST       put islands to sleep that stayed in place";
    private static final String EVENTS =
            "FLIGHT     move bodies in flight from impact to impact, in the order of time";
    private static final String SPLIT =
            "FLIGHT     find what is driven into others, and move bodies in flight along their"
                    + " paths";
    private static final String FREE = "FLIGHT     move bodies in flight along their exact paths";

    private static StepPlan plan(Accuracy accuracy, Effect... effects) {
        Effects declared = Effects.of(effects);
        return new StepPlan(new DataStorage(declared), declared, accuracy);
    }

    /** The lines of a description but for the last, which tells the columns. */
    private static List<String> parts(StepPlan plan) {
        List<String> lines = plan.describe().lines().toList();
        return lines.subList(0, lines.size() - 1);
    }

    private static List<String> parts(Effect... effects) {
        return parts(plan(Accuracy.GAME, effects));
    }

    private static List<String> bareWith(int place, String... more) {
        List<String> parts = new ArrayList<>(BARE);
        parts.addAll(place, List.of(more));
        return parts;
    }

    @Test
    void withoutEffectsThereIsOnlyFlight() {
        assertThat(parts()).isEqualTo(BARE);
    }

    @Test
    void everySteadyForceIsAPart() {
        assertThat(parts(GRAVITY)).isEqualTo(bareWith(2, "EFFECTS    gravity"));
        assertThat(parts(new Thrust())).isEqualTo(bareWith(2, "EFFECTS    thrust"));
        assertThat(parts(new Thrust(), new Rotation())).isEqualTo(bareWith(2, "EFFECTS    thrust"));
        assertThat(parts(new Drag(), new Wind(1, 2)))
                .isEqualTo(bareWith(2, "EFFECTS    steady wind"));
        assertThat(parts(GRAVITY, new Drag(), new Thrust(), new Wind(1, 2)))
                .isEqualTo(
                        bareWith(
                                2,
                                "EFFECTS    gravity",
                                "EFFECTS    thrust",
                                "EFFECTS    steady wind"));
    }

    /** Linear drag is part of the path; gusts change along it, and so does the air's drag. */
    @Test
    void whatChangesAlongTheWayIsIntegrated() {
        assertThat(parts(new Drag())).isEqualTo(BARE);
        assertThat(parts(new Drag(), new Wind(1, 2, time -> time)))
                .isEqualTo(bareWith(2, CHANGING));
        assertThat(parts(new AirDrag(1, 1), new Wind(1, 2))).isEqualTo(bareWith(2, CHANGING));
        assertThat(parts(FIELD)).isEqualTo(bareWith(2, CHANGING));
    }

    /** Any other integrator than the closed form takes every path in substeps. */
    @ParameterizedTest
    @EnumSource(Integrator.class)
    void anIntegratorIsAskedForAlone(Integrator integrator) {
        Accuracy accuracy = Accuracy.GAME.withIntegrator(integrator);
        boolean isClosed = integrator == Integrator.BALLISTIC;
        assertThat(parts(plan(accuracy))).isEqualTo(isClosed ? BARE : bareWith(2, CHANGING));
    }

    @Test
    void contactsBringTheirStages() {
        assertThat(parts(new Contacts()))
                .containsExactly(
                        "ACCEPT     list the bodies that move",
                        "EFFECTS    begin with no acceleration",
                        "EFFECTS    refuse forces beyond all bounds",
                        "BROADPHASE size fixtures and candidate pairs",
                        "CLASSIFY   begin with all bodies in flight",
                        "CLASSIFY   manifolds of pairs that touch",
                        "CLASSIFY   measure contacts, and find what rests on them",
                        FREE,
                        "CONTACT    group bodies in contact into islands",
                        "CONTACT    solve islands in 4 substeps: loads",
                        "REST       move driven bodies",
                        "REPORT     put to rest what stopped being finite",
                        "REPORT     fixtures of what left its own");
    }

    /** Impacts at their times only where both the effect and the accuracy ask for them. */
    @ParameterizedTest
    @EnumSource(ImpactMode.class)
    void flightIsAsTheModeOfImpacts(ImpactMode mode) {
        Accuracy accuracy = Accuracy.GAME.withImpacts(mode);
        List<String> continuous = parts(plan(accuracy, new Contacts(), new ContinuousImpacts()));
        String touch = "CLASSIFY   manifolds of pairs that touch";
        String mayTouch = "CLASSIFY   manifolds of pairs that may touch";
        String flight =
                switch (mode) {
                    case EVENTS -> EVENTS;
                    case SPLIT -> SPLIT;
                    case DISCRETE -> FREE;
                };
        assertThat(continuous).contains(flight);
        assertThat(continuous.stream().filter(part -> part.startsWith("FLIGHT"))).hasSize(1);
        assertThat(continuous).contains(mode == ImpactMode.DISCRETE ? touch : mayTouch);
        assertThat(continuous).doesNotContain(mode == ImpactMode.DISCRETE ? mayTouch : touch);
        assertThat(parts(plan(accuracy, new Contacts()))).contains(FREE, touch);
    }

    @Test
    void rowsAreOfWhatIsDeclared() {
        assertThat(rows(new Contacts(), new Friction())).endsWith(": loads, friction");
        assertThat(rows(new Contacts(), new Restitution())).endsWith(": loads, impacts");
        assertThat(rows(new Contacts(), new Rotation(), new RollingResistance()))
                .endsWith(": loads, rolling, faces that turn");
        assertThat(rows(new Contacts(), new Friction(), new SurfaceSpeed()))
                .endsWith(": loads, friction, running surfaces");
        assertThat(rows(new Contacts())).startsWith("CONTACT    solve islands in 7 substeps: ");
    }

    private static String rows(Effect... effects) {
        return parts(plan(Accuracy.GAME.withSubsteps(7), effects)).stream()
                .filter(part -> part.contains("solve islands"))
                .findFirst()
                .orElseThrow();
    }

    /** A sleeper would not notice a change of the caller's function. */
    @Test
    void nothingSleepsWhereAFunctionActs() {
        assertThat(parts(new Contacts(), new Sleep())).contains(SLEEP);
        assertThat(parts(new Contacts())).doesNotContain(SLEEP);
        assertThat(parts(new Contacts(), new Sleep(), FIELD)).doesNotContain(SLEEP);
    }

    @Test
    void theDescriptionEndsWithTheColumns() {
        Effects effects = Effects.of(new Rotation());
        DataStorage data = new DataStorage(effects);
        StepPlan plan = new StepPlan(data, effects, Accuracy.GAME);
        String last = plan.describe().lines().reduce((before, after) -> after).orElseThrow();
        assertThat(last)
                .isEqualTo(
                        "columns    pose, motion, mass, turning: "
                                + data.bodies.bitsPerBody()
                                + " bits a body");
        assertThat(data.bodies.bitsPerBody()).isGreaterThan(Double.SIZE);
    }

    @Test
    void columnsOfPathsAreThereWhereTheyAreIntegrated() {
        DataStorage data = new DataStorage(Effects.of());
        StepPlan plan = new StepPlan(data, Effects.of(), Accuracy.GAME);
        assertThat(data.bodies.pullX).isNull();
        plan.compile(Effects.of(FIELD), Accuracy.GAME);
        assertThat(data.bodies.pullX).isNotNull();
        plan.compile(Effects.of(), Accuracy.GAME);
        assertThat(data.bodies.pullX).isNull();
    }

    /** A broadphase holds the bodies that are in it: it outlives what else is declared. */
    @Test
    void aPlanIsCompiledAnew() {
        Effects contacts = Effects.of(new Contacts(), GRAVITY);
        StepPlan plan = new StepPlan(new DataStorage(contacts), contacts, Accuracy.GAME);
        Broadphase broadphase = plan.broadphase();
        assertThat(broadphase).isNotNull();
        assertThat(plan.effects()).isSameAs(contacts);
        assertThat(plan.accuracy()).isSameAs(Accuracy.GAME);

        Effects fewer = Effects.of(new Contacts());
        plan.compile(fewer, Accuracy.EXACT);
        assertThat(plan.broadphase()).isSameAs(broadphase);
        assertThat(plan.effects()).isSameAs(fewer);
        assertThat(plan.accuracy()).isSameAs(Accuracy.EXACT);
        assertThat(parts(plan)).isEqualTo(parts(plan(Accuracy.EXACT, new Contacts())));

        plan.compile(Effects.of(), Accuracy.EXACT);
        assertThat(plan.broadphase()).isNull();
        assertThat(parts(plan)).isEqualTo(BARE);
    }

    /** A clock that counts its readings gives each part a nanosecond. */
    @Test
    void everyPartIsTimedUnderItsStage() {
        Effects effects = Effects.of(new Contacts(), GRAVITY, new Sleep(), new Rotation());
        DataStorage data = new DataStorage(effects);
        StepPlan plan = new StepPlan(data, effects, Accuracy.GAME);
        long[] readings = {100};
        for (int step = 0; step < 2; step++) {
            data.counters.impacts = 5;
            plan.run(0.25, () -> readings[0]++);
            assertThat(data.counters.impacts).as("counted anew").isZero();
            for (StepStage stage : StepStage.values()) {
                long parts = parts(plan).stream().filter(p -> p.startsWith(stage + " ")).count();
                assertThat(data.counters.nanos[stage.ordinal()]).as("%s", stage).isEqualTo(parts);
            }
        }
    }

    /** Stages come in the order that a report tells them. */
    @Test
    void stagesAreInTheirOrder() {
        StepPlan plan =
                plan(
                        Accuracy.EXACT,
                        GRAVITY,
                        new Contacts(),
                        new Rotation(),
                        new ContinuousImpacts(),
                        new Sleep(),
                        new Thrust(),
                        new Drag(),
                        new Wind(1, 1));
        assertThat(parts(plan))
                .extracting(part -> StepStage.valueOf(part.substring(0, part.indexOf(' '))))
                .isSorted()
                .contains(StepStage.values());
    }

    /** A body of 2 kg and 4 kg·m² at the origin. */
    private static int body(Bodies bodies, BodyType type) {
        int slot = bodies.take();
        bodies.type[slot] = type;
        bodies.awake[slot] = type == BodyType.DYNAMIC;
        bodies.mass[slot] = 2;
        bodies.inverseMass[slot] = 0.5;
        bodies.gravityScale[slot] = 1;
        if (bodies.turns()) {
            bodies.inertia[slot] = 4;
            bodies.inverseInertia[slot] = 0.25;
        }
        return slot;
    }

    /** ¼ s under gravity and a force of 16 N: v = a·t, x = a·t²/2, exactly; α = 12/4, likewise. */
    @Test
    void aStepDoesWhatIsDeclared() {
        Effects effects = Effects.of(GRAVITY, new Thrust(), new Rotation());
        DataStorage data = new DataStorage(effects);
        Bodies bodies = data.bodies;
        StepPlan plan = new StepPlan(data, effects, Accuracy.GAME);
        int ball = body(bodies, BodyType.DYNAMIC);
        int lift = body(bodies, BodyType.KINEMATIC);
        bodies.velocityX[lift] = 2;
        bodies.forceX[ball] = 16;
        bodies.torque[ball] = 12;
        data.thrusting.add(ball);
        plan.run(0.25, () -> 0);

        assertThat(bodies.velocityX[ball]).isEqualTo(2);
        assertThat(bodies.velocityY[ball]).isEqualTo(-2);
        assertThat(bodies.x[ball]).isEqualTo(0.25);
        assertThat(bodies.y[ball]).isEqualTo(-0.25);
        assertThat(bodies.spin[ball]).isEqualTo(0.75);
        assertThat(bodies.x[lift]).isEqualTo(0.5);
        assertThat(bodies.startX[ball]).isZero();

        // The force was for one step; gravity goes on from no acceleration.
        plan.run(0.25, () -> 0);
        assertThat(bodies.velocityX[ball]).isEqualTo(2);
        assertThat(bodies.velocityY[ball]).isEqualTo(-4);
        assertThat(bodies.spin[ball]).isEqualTo(0.75);
    }

    /** Refused before it moves: it is where it began, and named. */
    @Test
    void aForceBeyondAllBoundsIsRefused() {
        Effects effects = Effects.of(new Thrust());
        DataStorage data = new DataStorage(effects);
        StepPlan plan = new StepPlan(data, effects, Accuracy.GAME);
        int ball = body(data.bodies, BodyType.DYNAMIC);
        data.bodies.velocityX[ball] = 3;
        data.bodies.forceX[ball] = 1e300;
        data.thrusting.add(ball);
        plan.run(0.25, () -> 0);

        assertThat(data.bodies.x[ball]).isZero();
        assertThat(data.bodies.velocityX[ball]).isZero();
        assertThat(data.counters.quarantinedCount).isEqualTo(1);
    }

    /** At the largest number a step of any length ends nowhere: found at the end. */
    @Test
    void aPlaceBeyondAllNumbersIsRefused() {
        Effects effects = Effects.of();
        DataStorage data = new DataStorage(effects);
        StepPlan plan = new StepPlan(data, effects, Accuracy.GAME);
        int ball = body(data.bodies, BodyType.DYNAMIC);
        data.bodies.x[ball] = Double.MAX_VALUE;
        data.bodies.velocityX[ball] = 1e9;
        plan.run(1e300, () -> 0);

        assertThat(data.bodies.x[ball]).isEqualTo(Double.MAX_VALUE);
        assertThat(data.bodies.velocityX[ball]).isZero();
        assertThat(data.counters.quarantinedCount).isEqualTo(1);
    }
}
