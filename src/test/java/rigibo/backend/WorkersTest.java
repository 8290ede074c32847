package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import com.sun.management.ThreadMXBean;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;

/** Any number of workers makes the same bits, the same events in the same order, and no garbage. */
@Timeout(120)
@Execution(ExecutionMode.CONCURRENT)
class WorkersTest {

    private static final double DT = 1.0 / 60;
    private static final Effects EFFECTS = Effects.usual().with(new Joints());

    private final SplittableRandom random = new SplittableRandom(7);
    private final Pool pool = new Pool(EFFECTS, Accuracy.GAME);

    /**
     * Piles on a floor and on two belts, the belts carried along, chains whose links break, and
     * elastic discs: islands of all kinds that come together and part.
     */
    private static Pool crowd(int workers) {
        SplittableRandom random = new SplittableRandom(3);
        Pool pool = new Pool(EFFECTS, Accuracy.GAME);
        pool.workers(workers);
        pool.add(BodyDefinition.fixed(Polygon.box(400, 1)).at(0, -0.5));
        for (int pile = 0; pile < 12; pile++) {
            pile(pool, random, 6 * pile, 0);
        }
        for (int belt = 0; belt < 2; belt++) {
            double y = 20 + 20 * belt;
            pool.add(BodyDefinition.kinematic(Polygon.box(30, 1)).at(8, y).velocity(0.5, 0));
            for (int pile = 0; pile < 4; pile++) {
                pile(pool, random, 6 * pile, y + 0.5);
            }
        }
        for (int chain = 0; chain < 4; chain++) {
            chain(pool, 6 * chain, 70 + 4 * chain);
        }
        return pool;
    }

    private static void pile(Pool pool, SplittableRandom random, double x, double y) {
        Material elastic = new Material(1, 0.5, 0.4);
        for (int i = 0; i < 6; i++) {
            double aside = random.nextDouble(-0.2, 0.2);
            pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(x + aside, y + 0.6 + 1.2 * i));
        }
        pool.add(
                BodyDefinition.dynamic(new Circle(0.4))
                        .at(x + 0.3, y + 10)
                        .velocity(random.nextDouble(-3, 3), -6)
                        .material(elastic));
    }

    /** Links that a heavy end tears apart, one after the other or several in one step. */
    private static void chain(Pool pool, double x, double y) {
        RigidBody before = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 0.2)).at(x, y));
        for (int i = 1; i <= 10; i++) {
            double mass = i == 10 ? 50 : 1;
            RigidBody link =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.8, 0.2))
                                    .at(x + 0.8 * i, y)
                                    .mass(mass));
            pool.join(
                    RevoluteJoint.at(before, link, x + 0.8 * i - 0.4, y)
                            .breaking(700, Double.POSITIVE_INFINITY));
            before = link;
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void everyStepEndsInTheSameBits(int workers) {
        int shared = 0;
        int hits = 0;
        int breaks = 0;
        try (Pool one = crowd(1);
                Pool several = crowd(workers)) {
            for (int step = 0; step < 240; step++) {
                StepReport found = stepAlike(one, several, step);
                shared += found.sharedIslands() > 0 ? 1 : 0;
                hits += one.hits().size();
                breaks += one.brokenJoints().size();
            }
        }
        assertThat(shared).as("steps with shared islands").isGreaterThan(150);
        assertThat(hits).isGreaterThan(100);
        assertThat(breaks).isGreaterThan(4);
    }

    /** Makes a step of both, with the same results by the same work; returns what several told. */
    private static StepReport stepAlike(Pool one, Pool several, int step) {
        StepReport expected = one.step(DT);
        StepReport found = several.step(DT);
        assertThat(several.stateHash()).as("step %d", step).isEqualTo(one.stateHash());
        assertThat(words(several)).as("step %d", step).isEqualTo(words(one));
        assertThat(found.contactSolves()).isEqualTo(expected.contactSolves());
        assertThat(found.multiplications()).isEqualTo(expected.multiplications());
        assertThat(found.rows()).isEqualTo(expected.rows());
        assertThat(found.impacts()).isEqualTo(expected.impacts());
        assertThat(expected.sharedIslands()).isZero();
        assertThat(expected.splits()).isZero();
        return found;
    }

    /** Hits and breaks in their order, by the numbers of bodies. */
    private static List<String> words(Pool pool) {
        List<String> words = new ArrayList<>();
        for (HitEvent hit : pool.hits()) {
            words.add(
                    number(pool, hit.a())
                            + " hits "
                            + number(pool, hit.b())
                            + " at "
                            + hit.x()
                            + " "
                            + hit.y()
                            + " "
                            + hit.speed()
                            + " "
                            + hit.time());
        }
        for (JointBreak broken : pool.brokenJoints()) {
            words.add(
                    number(pool, broken.definition().a())
                            + " "
                            + number(pool, broken.definition().b())
                            + " "
                            + broken.force());
        }
        return words;
    }

    private static int number(Pool pool, RigidBody body) {
        return pool.bodies().indexOf(body);
    }

    /**
     * A heap is one island: its contacts are shared colour by colour. Beside it lie piles, which
     * are shared as wholes, and discs and boxes on belts, so that contacts of all kinds come along.
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void heapsAreSharedToo(int workers) {
        int splits = 0;
        int most = 0;
        try (Pool one = heap(1);
                Pool several = heap(workers)) {
            for (int step = 0; step < 150; step++) {
                StepReport found = stepAlike(one, several, step);
                splits += found.splits() > 50 ? 1 : 0;
                most = Math.max(most, found.contacts());
            }
        }
        assertThat(splits).as("steps with shared passes").isGreaterThan(60);
        assertThat(most).isGreaterThan(1_000);
    }

    /** A thousand bodies, thrown into a trough, and piles and a belt beside it. */
    private static Pool heap(int workers) {
        Pool pool = crowd(workers);
        SplittableRandom random = new SplittableRandom(11);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(200, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 30)).at(190, 15));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 30)).at(210, 15));
        Material material = new Material(1, 0.3, 0.5);
        for (int i = 0; i < 1_000; i++) {
            Shape shape = i % 3 == 0 ? new Circle(0.2) : Polygon.box(0.5, 0.3);
            double x = 191 + 0.6 * (i % 30) + random.nextDouble(0.05);
            pool.add(
                    BodyDefinition.dynamic(shape)
                            .at(x, 0.5 + 0.5 * (i / 30))
                            .velocity(random.nextDouble(-2, 2), -4)
                            .material(material));
        }
        return pool;
    }

    /** Workers without threads do the same work in another order. */
    @Test
    void aRehearsalEndsInTheSameBitsAndTellsWhatItSpares() {
        int sparing = 0;
        try (Pool one = crowd(1);
                Pool several = crowd(1)) {
            several.rehearse(3);
            assertThat(several.workers()).isEqualTo(3);
            for (int step = 0; step < 240; step++) {
                StepReport found = stepAlike(one, several, step);
                assertThat(one.report().spared()).isZero();
                assertThat(found.spared()).isNotNegative();
                sparing += found.splits() > 0 && found.spared() > 0 ? 1 : 0;
            }
            several.workers(3);
            stepAlike(one, several, 240);
            assertThat(several.report().spared()).isZero();
        }
        assertThat(sparing).as("steps that spare time").isGreaterThan(150);
    }

    /** The number is no part of a pool's state: it may change from step to step. */
    @Test
    void workersComeAndGo() {
        try (Pool one = crowd(1);
                Pool other = crowd(2)) {
            for (int step = 0; step < 60; step++) {
                other.workers(1 + random.nextInt(4));
                if (step == 30) {
                    one.accuracy(Accuracy.FINE);
                    other.accuracy(Accuracy.FINE);
                }
                one.step(DT);
                other.step(DT);
                assertThat(other.stateHash()).as("step %d", step).isEqualTo(one.stateHash());
            }
            other.workers(1);
            assertThat(other.workers()).isOne();
            one.step(DT);
            other.step(DT);
            assertThat(other.stateHash()).isEqualTo(one.stateHash());
        }
    }

    /** A level of the game has a few dozen bodies: nobody is woken for it. */
    @Test
    void fewBodiesAreNotShared() {
        pool.workers(2);
        pool.add(BodyDefinition.fixed(Polygon.box(400, 1)).at(0, -0.5));
        for (int pile = 0; pile < 4; pile++) {
            pile(pool, random, 6 * pile, 0);
        }
        for (int step = 0; step < 120; step++) {
            assertThat(pool.step(DT).splits()).isZero();
        }
        pool.close();
    }

    @Test
    void warmStepsAllocateNothingOnAnyThread() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        try (Pool several = new Pool(Effects.usual(), Accuracy.GAME)) {
            several.workers(2);
            several.add(BodyDefinition.fixed(Polygon.box(400, 1)).at(0, -0.5));
            List<RigidBody> swung = new ArrayList<>();
            for (int pile = 0; pile < 20; pile++) {
                for (int i = 0; i < 6; i++) {
                    BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1));
                    swung.add(several.add(box.at(6 * pile, 0.5 + i)));
                }
            }
            for (int step = 0; step < 300; step++) {
                shake(swung, step);
                several.step(DT);
            }
            long[] workers =
                    Arrays.stream(threads.getThreadInfo(threads.getAllThreadIds()))
                            .filter(Objects::nonNull)
                            .filter(info -> info.getThreadName().startsWith("rigibo-worker"))
                            .mapToLong(info -> info.getThreadId())
                            .toArray();
            assertThat(workers).isNotEmpty();
            long least = Long.MAX_VALUE;
            for (int batch = 0; batch < 5; batch++) {
                long before = allocated(threads, workers);
                int shared = 0;
                for (int step = 0; step < 60; step++) {
                    shake(swung, step);
                    shared += several.step(DT).sharedIslands();
                }
                least = Math.min(least, allocated(threads, workers) - before);
                assertThat(shared).isPositive();
            }
            assertThat(least).isZero();
        }
    }

    private static void shake(List<RigidBody> bodies, int step) {
        for (int i = 5; i < bodies.size(); i += 6) {
            bodies.get(i).velocity(step % 2 == 0 ? 0.3 : -0.3, 0);
        }
    }

    private static long allocated(ThreadMXBean threads, long[] workers) {
        long sum = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
        for (long worker : workers) {
            sum += threads.getThreadAllocatedBytes(worker);
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, -1, 65})
    void otherNumbersAreRefused(int workers) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> pool.workers(workers))
                .withMessageContaining("Pool.workers")
                .withMessageContaining("64");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> pool.rehearse(workers))
                .withMessageContaining("Pool.rehearse")
                .withMessageContaining("64");
        assertThat(pool.workers()).isOne();
    }

    @Test
    void workersDoNotChangeWithinAVisit() {
        pool.add(BodyDefinition.fixed(Polygon.box(400, 1)).at(0, -0.5));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        pool.step(DT);
        assertThatIllegalStateException()
                .isThrownBy(() -> pool.forEachContact(contact -> pool.workers(2)));
        assertThatIllegalStateException()
                .isThrownBy(() -> pool.forEachContact(contact -> pool.rehearse(2)));
    }
}
