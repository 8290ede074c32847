package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Correction;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** A pool restored from its snapshot is the pool: it goes on to the same bits. */
@Execution(ExecutionMode.CONCURRENT)
class SnapshotTest {

    /** In the middle of contacts: bodies lie in heaps, fall, bounce, sleep and are driven. */
    private static final int TAKEN = 140;

    private static final int STEPS = 600;

    @ParameterizedTest
    @EnumSource(Preset.class)
    void goesOnToTheSameBits(Preset preset) {
        Pool pool = Potpourri.build(preset.accuracy);
        Potpourri.run(pool, 0, TAKEN);
        requireSomeOfEverything(pool);
        Pool restored = Pool.restore(pool.snapshot());
        requireSame(restored, pool, preset + " at once");
        Set<ContactEvent.Phase> phases = EnumSet.noneOf(ContactEvent.Phase.class);
        for (int i = TAKEN; i < TAKEN + STEPS; i++) {
            Potpourri.step(pool, i);
            Potpourri.step(restored, i);
            requireSameHash(restored, pool, preset + " after step " + i);
            assertThat(restored.contactEvents()).hasSameSizeAs(pool.contactEvents());
            pool.contactEvents().forEach(event -> phases.add(event.phase()));
        }
        requireSame(restored, pool, preset + " at the end");
        assertThat(phases).containsExactlyInAnyOrder(ContactEvent.Phase.values());
    }

    /**
     * Two discs part in the step in which they fall asleep. The one wakes within the next, and the
     * other with it, for they touched; a driven disc beside that had it looked for before. They
     * part too slowly to be told from what rests.
     */
    @Test
    void whatPartedFallingAsleepAndWokeWithinAStepGoesOnToTheSameBits() {
        Effects effects = Effects.of(new Contacts(), new Sleep(0.5, 1));
        Pool pool = new Pool(effects, Accuracy.DRAFT.withCorrection(Correction.NONE));
        RigidBody first = pool.add(BodyDefinition.dynamic(new Circle(1)));
        RigidBody second = pool.add(BodyDefinition.dynamic(new Circle(1)).at(1.9995, 0));
        second.velocity(1e-3, 0);
        RigidBody driven = pool.add(BodyDefinition.kinematic(new Circle(1)).at(-3.5, 0));
        driven.velocity(2, 0);
        pool.add(BodyDefinition.kinematic(new Circle(1)).at(2.0005, 2.01).velocity(0, 1e-3));
        pool.step(1);
        assertThat(List.of(first.isAwake(), second.isAwake())).containsOnly(false);
        driven.velocity(-0.01, 0);
        pool.step(1.0 / 1024);
        assertThat(List.of(first.isAwake(), second.isAwake())).containsOnly(true);
        Pool restored = Pool.restore(pool.snapshot());
        pool.step(Scenes.DT);
        restored.step(Scenes.DT);
        requireSame(restored, pool, "a step later");
    }

    @ParameterizedTest
    @EnumSource(Scenes.class)
    void anySceneGoesOnToTheSameBits(Scenes scene) {
        Pool pool = scene.build();
        Scenes.run(pool, TAKEN);
        Pool restored = Pool.restore(pool.snapshot(), pool.effects());
        for (int i = 0; i < TAKEN; i++) {
            pool.step(Scenes.DT);
            restored.step(Scenes.DT);
            assertThat(restored.stateHash())
                    .as("%s, step %d, seed %d", scene, i, Scenes.SEED)
                    .isEqualTo(pool.stateHash());
        }
    }

    /** Anything a stage kept from one step to the next without saving it would be missing here. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void nothingLastsFromStepToStepButWhatASnapshotHolds(Preset preset) {
        Pool pool = Potpourri.build(preset.accuracy);
        Pool restored = Potpourri.build(preset.accuracy);
        for (int i = 0; i < 2 * TAKEN; i++) {
            restored = Pool.restore(restored.snapshot());
            Potpourri.step(pool, i);
            Potpourri.step(restored, i);
            requireSameHash(restored, pool, preset + " restored before step " + i);
        }
    }

    @Test
    void goesOnToTheSameBitsInAFreshJvm(@TempDir Path directory)
            throws IOException, InterruptedException {
        Pool pool = Potpourri.build(Accuracy.GAME);
        Potpourri.run(pool, 0, TAKEN);
        Path file = directory.resolve("snapshot");
        Files.write(file, pool.snapshot());
        Potpourri.run(pool, TAKEN, TAKEN + STEPS);
        String printed =
                ChildJvm.output(
                        ChildJvm.own(),
                        List.of("-ea"),
                        GoOn.class,
                        file.toString(),
                        Integer.toString(TAKEN),
                        Integer.toString(TAKEN + STEPS));
        assertThat(printed).isEqualTo(Long.toHexString(pool.stateHash()));
    }

    @Test
    void bodiesKeepTheirOrderAndNames() {
        Pool pool = Potpourri.build(Accuracy.GAME);
        Potpourri.run(pool, 0, TAKEN);
        Pool restored = Pool.restore(pool.snapshot());
        assertThat(names(restored)).isEqualTo(names(pool)).contains("paddle", "asleep \uD83D");
        assertThat(slots(restored)).isEqualTo(slots(pool)).isNotEqualTo(sorted(slots(pool)));
        assertThat(restored.time()).isEqualTo(pool.time());
        assertThat(restored.accuracy()).isEqualTo(pool.accuracy());
        assertThat(restored.effects()).isEqualTo(pool.effects());
        assertThat(restored.plan()).isEqualTo(pool.plan());
        assertThat(restored.kineticEnergy()).isEqualTo(pool.kineticEnergy());
        assertThat(restored.potentialEnergy()).isEqualTo(pool.potentialEnergy());
        for (int i = 0; i < pool.bodies().size(); i++) {
            requireSameBody(restored.bodies().get(i), pool.bodies().get(i));
        }
    }

    private static void requireSameBody(RigidBody body, RigidBody original) {
        assertThat(body).hasToString(original.toString());
        assertThat(body.shape()).isEqualTo(original.shape());
        assertThat(body.material()).isEqualTo(original.material());
        assertThat(body.type()).isEqualTo(original.type());
        assertThat(body.mass()).isEqualTo(original.mass());
        assertThat(body.inertia()).isEqualTo(original.inertia());
        assertThat(body.isAwake()).isEqualTo(original.isAwake());
    }

    @Test
    void equalShapesBecomeOneAgain() {
        Pool restored = Pool.restore(Potpourri.build(Accuracy.GAME).snapshot());
        List<RigidBody> boxes =
                restored.bodies().stream()
                        .filter(body -> body.name().startsWith("box"))
                        .collect(Collectors.toList());
        assertThat(boxes).hasSize(5);
        assertThat(boxes).allSatisfy(b -> assertThat(b.shape()).isSameAs(boxes.get(0).shape()));
    }

    @Test
    void forcesAskedForBeforeASnapshotActAfterIt() {
        Pool pool = new Pool(Potpourri.EFFECTS, Accuracy.GAME);
        RigidBody disc = pool.add(BodyDefinition.dynamic(new Circle(1)));
        disc.applyForce(30, 4, 5, 6);
        disc.applyTorque(2);
        Pool restored = Pool.restore(pool.snapshot());
        pool.step(Scenes.DT);
        restored.step(Scenes.DT);
        // Without the force, gravity would have given it 0.1 m/s² to the right.
        assertThat(restored.bodies().get(0).velocityX()).isGreaterThan(5 * Scenes.DT);
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
    }

    /** Once the force of the water on a sleeper was not saved, and it went on 15 mm elsewhere. */
    @Test
    void sleepersInWaterThatAreStruckGoOnTheSame() {
        Effects water = Effects.usual().with(new Buoyancy(2, 0.5, 1)).with(new Sleep(0.2, 1e-3));
        Pool pool = new Pool(water, Accuracy.GAME);
        Scenes.addTray(pool);
        for (int i = 0; i < 3; i++) {
            pool.add(BodyDefinition.dynamic(Polygon.box(0.6, 0.6)).at(0, 0.3 + 0.6 * i));
        }
        Scenes.run(pool, TAKEN);
        assertThat(pool.bodies())
                .filteredOn(body -> body.type() == BodyType.DYNAMIC && !body.isAwake())
                .hasSize(3);
        pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(0.1, 2.3).velocity(0, -3));
        Pool restored = Pool.restore(pool.snapshot());
        for (int i = 0; i < TAKEN; i++) {
            pool.step(Scenes.DT);
            restored.step(Scenes.DT);
            requireSameHash(restored, pool, "step " + i);
        }
        requireSame(restored, pool, "at the end");
    }

    @Test
    void emptyPoolIsRestored() {
        Pool pool = new Pool();
        Pool restored = Pool.restore(pool.snapshot());
        requireSame(restored, pool, "empty");
        assertThat(restored.bodies()).isEmpty();
        assertThat(restored.report().bodies()).isZero();
    }

    @Test
    void poolThatHasNeverStepped() {
        Pool pool = Potpourri.build(Accuracy.GAME);
        pool.remove(pool.bodies().get(9));
        pool.remove(pool.bodies().get(7));
        Pool restored = Pool.restore(pool.snapshot());
        requireSame(restored, pool, "before the first step");
        Potpourri.run(pool, 0, TAKEN);
        Potpourri.run(restored, 0, TAKEN);
        requireSame(restored, pool, "after " + TAKEN);
    }

    @Test
    void snapshotWithinAStepIsRefused() {
        Pool pool = Potpourri.build(Accuracy.GAME);
        pool.clock(() -> pool.snapshot().length);
        assertThatThrownBy(() -> pool.step(Scenes.DT))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("cannot take a snapshot during a step");
    }

    @Test
    void snapshotLeavesNoTrace() {
        Pool pool = Potpourri.build(Accuracy.GAME);
        Pool photographed = Potpourri.build(Accuracy.GAME);
        for (int i = 0; i < TAKEN; i++) {
            photographed.snapshot();
            Potpourri.step(photographed, i);
            Potpourri.step(pool, i);
        }
        assertThat(photographed.stateHash()).isEqualTo(pool.stateHash());
    }

    @Test
    void effectsHandedInReplaceThoseDeclared() {
        Pool pool = Potpourri.build(Accuracy.GAME);
        Effects moon = Potpourri.EFFECTS.with(new Gravity(0, -1.62));
        Pool restored = Pool.restore(pool.snapshot(), moon);
        assertThat(restored.effects()).isSameAs(moon);
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
    }

    private static void requireSameHash(Pool restored, Pool pool, String when) {
        assertThat(restored.stateHash()).as(when).isEqualTo(pool.stateHash());
    }

    private static void requireSame(Pool restored, Pool pool, String when) {
        requireSameHash(restored, pool, when);
        assertThat(restored.snapshot()).as(when).isEqualTo(pool.snapshot());
        assertThat(events(restored)).as(when).isEqualTo(events(pool));
    }

    /** A snapshot of an idle pool would prove little. */
    private static void requireSomeOfEverything(Pool pool) {
        assertThat(pool.contactEvents()).hasSizeGreaterThan(15);
        assertThat(pool.report().rows()).isGreaterThan(20);
        assertThat(pool.bodies())
                .as("sleepers")
                .filteredOn(body -> body.type() == BodyType.DYNAMIC && !body.isAwake())
                .hasSizeGreaterThan(2);
    }

    private static String events(Pool pool) {
        return pool.contactEvents().stream()
                .map(event -> event.a().slot() + " " + event.b().slot() + " " + event)
                .collect(Collectors.joining("\n"));
    }

    private static List<String> names(Pool pool) {
        return pool.bodies().stream().map(RigidBody::name).collect(Collectors.toList());
    }

    private static List<Integer> slots(Pool pool) {
        return pool.bodies().stream().map(RigidBody::slot).collect(Collectors.toList());
    }

    private static List<Integer> sorted(List<Integer> numbers) {
        return numbers.stream().sorted().collect(Collectors.toList());
    }
}
