package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.List;
import java.util.Random;

/** Pools are changed between steps, at rest and in the middle of contact. */
class EditsTest {

    private static final double WEIGHTLESS_STEP = 9.81 * Scenes.DT;

    /** A crate asleep on a plank on a floor. */
    private final Pool pool = new Pool();

    private final RigidBody floor = Scenes.addFloor(pool);
    private final RigidBody plank =
            pool.add(BodyDefinition.dynamic(Polygon.box(4, 0.5)).at(0, 0.25));
    private final RigidBody crate = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1));

    private void fallAsleep() {
        for (int i = 0; i < 300 && crate.isAwake(); i++) {
            pool.step(Scenes.DT);
        }
        assertThat(crate.isAwake()).isFalse();
        assertThat(plank.isAwake()).isFalse();
    }

    @Test
    void sleepersStayExactlyWhereTheyAre() {
        fallAsleep();
        double y = crate.y();
        Scenes.run(pool, 600);
        assertThat(crate.y()).isEqualTo(y);
        assertThat(pool.report().awake()).isZero();
    }

    @Test
    void removedSupportLetsFallInTheNextStep() {
        fallAsleep();
        pool.remove(plank);
        pool.step(Scenes.DT);
        assertThat(crate.isAwake()).isTrue();
        assertThat(crate.velocityY()).isCloseTo(-WEIGHTLESS_STEP, within(1e-2 * WEIGHTLESS_STEP));
        Scenes.run(pool, 120);
        assertThat(crate.y()).isCloseTo(0.5, within(1e-3));
    }

    @Test
    void supportThatMovesAwayWakesWhatLayOnIt() {
        fallAsleep();
        plank.moveTo(30, 5, 0);
        Scenes.run(pool, 2);
        assertThat(crate.velocityY()).isLessThan(0);
    }

    @Test
    void supportThatShrinksWakesWhatLayOnIt() {
        fallAsleep();
        plank.shape(Polygon.box(4, 0.2));
        Scenes.run(pool, 120);
        assertThat(crate.y()).isCloseTo(0.7, within(5e-3));
    }

    @Test
    void staticBodyThatBecomesDynamicFallsWithItsLoad() {
        fallAsleep();
        floor.type(BodyType.DYNAMIC);
        Scenes.run(pool, 30);
        assertThat(floor.y()).isLessThan(-1);
        assertThat(crate.y()).isLessThan(0.5);
    }

    @Test
    void impulseWakesWhatItHitsAndWhatLiesOnIt() {
        fallAsleep();
        plank.applyImpulse(0, 10 * plank.mass(), plank.x(), plank.y());
        pool.step(Scenes.DT);
        assertThat(plank.isAwake()).isTrue();
        assertThat(crate.isAwake()).isTrue();
        assertThat(crate.velocityY()).isGreaterThan(0);
    }

    @Test
    void otherGravityWakesAndMovesEverything() {
        fallAsleep();
        pool.effects(pool.effects().with(new Gravity(0, 9.81)));
        Scenes.run(pool, 60);
        assertThat(crate.velocityY()).isGreaterThan(5);
        assertThat(plank.velocityY()).isGreaterThan(5);
    }

    @Test
    void effectDeclaredLaterWorksFromTheNextStep() {
        fallAsleep();
        pool.effects(pool.effects().with(new Thrust()));
        crate.applyForce(0, 30 * crate.mass(), crate.x(), crate.y());
        pool.step(Scenes.DT);
        assertThat(crate.velocityY()).isCloseTo((30 - 9.81) * Scenes.DT, within(1e-9));
        pool.effects(pool.effects().without(Thrust.class));
        Scenes.run(pool, 120);
        assertThat(crate.y()).isCloseTo(1, within(2e-3));
    }

    @Test
    void withoutContactsEverythingFallsThrough() {
        fallAsleep();
        pool.effects(Effects.of(new Gravity(0, -9.81)));
        Scenes.run(pool, 60);
        assertThat(crate.y()).isCloseTo(1 - 9.81 / 2, within(1e-3));
    }

    @Test
    void frictionCanBeTakenAway() {
        Pool slope =
                new Pool(
                        Effects.of(
                                new Gravity(3, -9), new Contacts(), new Rotation(), new Friction()),
                        Accuracy.GAME);
        Scenes.addFloor(slope);
        RigidBody box = slope.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        Scenes.run(slope, 60);
        assertThat(box.x()).isCloseTo(0, within(1e-3));
        slope.effects(slope.effects().without(Friction.class));
        double before = box.velocityX();
        Scenes.run(slope, 60);
        assertThat(box.velocityX() - before).isCloseTo(3, within(1e-6));
    }

    @Test
    void accuracyMayChangeAtAnyStep() {
        List<Accuracy> presets =
                List.of(Accuracy.DRAFT, Accuracy.EXACT, Accuracy.GAME, Accuracy.FINE);
        Pool stack = Scenes.STACK.build();
        for (int i = 0; i < 240; i++) {
            stack.accuracy(presets.get(i % presets.size()));
            stack.step(Scenes.DT);
        }
        RigidBody top = stack.bodies().get(10);
        assertThat(top.x()).isCloseTo(0, within(2e-3));
        assertThat(top.y()).isCloseTo(9.5, within(2e-2));
    }

    @Test
    void accuracyDoesNotWakeWhatSleeps() {
        fallAsleep();
        pool.accuracy(Accuracy.EXACT);
        pool.step(Scenes.DT);
        assertThat(crate.isAwake()).isFalse();
    }

    @Test
    void heavierMaterialMakesAHeavierBody() {
        crate.material(new Material(700, 0.5, 0.2));
        assertThat(crate.mass()).isCloseTo(700, within(1e-9));
        assertThat(crate.inertia()).isCloseTo(700.0 / 6, within(1e-9));
        crate.shape(new Circle(0.5));
        assertThat(crate.mass()).isCloseTo(700 * Math.PI / 4, within(1e-9));
    }

    /**
     * Random edits in a heap. Nothing may throw, stop being finite or leave a trace of removed
     * bodies in the events.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void editsInTheMiddleOfContactDoNoHarm(long seed) {
        Random random = new Random(seed);
        Pool heap = Scenes.MIXTURE.build();
        Scenes.run(heap, 60);
        for (int step = 0; step < 240; step++) {
            RigidBody victim = heap.bodies().get(3 + random.nextInt(heap.bodies().size() - 3));
            edit(heap, victim, random);
            heap.step(Scenes.DT);
            String when = "seed " + seed + ", step " + step;
            for (RigidBody body : heap.bodies()) {
                double sum = body.x() + body.y() + body.angle() + body.kineticEnergy();
                assertThat(sum).as("%s: %s", when, body).isFinite();
            }
            for (ContactEvent event : heap.contactEvents()) {
                boolean isEnd = event.phase() == ContactEvent.Phase.END;
                assertThat(isEnd || event.bothAlive()).as(when).isTrue();
            }
            assertThat(heap.report().quarantined()).as(when).isZero();
        }
    }

    private static void edit(Pool heap, RigidBody victim, Random random) {
        switch (random.nextInt(8)) {
            case 0 -> victim.material(new Material(1 + random.nextInt(9), 0.9, 0.9));
            case 1 -> victim.type(BodyType.values()[random.nextInt(3)]);
            case 2 -> victim.type(BodyType.DYNAMIC);
            case 3 -> victim.shape(Polygon.regular(3 + random.nextInt(9), 0.4));
            case 4 -> victim.shape(new Circle(0.3));
            case 5 -> victim.moveTo(10 * random.nextDouble() - 5, 8, random.nextDouble());
            case 6 -> {
                heap.remove(victim);
                heap.add(BodyDefinition.dynamic(Polygon.box(0.6, 0.6)).at(0, 9));
            }
            default -> victim.wake();
        }
    }
}
