package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.storage.Pairs;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;

/** A picture answers what its pool answers right after the step, to the last bit. */
@Execution(ExecutionMode.CONCURRENT)
class SharedAnswersTest {

    private static final int STEPS = 60;
    private static final int QUESTIONS = 12;
    private static final Shape[] SWEPT = {
        new Circle(0.3), Polygon.box(0.7, 0.4), new Capsule(0.6, 0.1)
    };

    private final SplittableRandom random = new SplittableRandom(11);

    /** Answers that were not empty, by kind: a test of nothing but misses would say little. */
    private int held;

    private int hit;
    private int touched;

    @ParameterizedTest
    @EnumSource(Scenes.class)
    void everySceneIsToldAlike(Scenes scene) {
        Pool pool = scene.build();
        SharedView view = pool.shared();
        compare(pool, view, scene + " before the first step");
        for (int step = 1; step <= STEPS; step++) {
            pool.step(Scenes.DT);
            compare(pool, view, scene + ", step " + step);
        }
        assertThat(hit).isGreaterThan(STEPS);
        assertThat(held).isGreaterThan(STEPS / 10);
        assertThat(touched).isGreaterThan(STEPS / 10);
    }

    /** Bodies come and go, slots are used again, contacts end by edits. */
    @Test
    void editedPoolsAreToldAlikeAfterEachStepAndWhenPublished() {
        for (int seed = 0; seed < 4; seed++) {
            SplittableRandom edits = new SplittableRandom(seed);
            Pool pool = Scenes.KINDS.build();
            SharedView view = pool.shared();
            for (int step = 0; step < STEPS; step++) {
                edit(pool, edits);
                if (step % 2 == 0) {
                    view.publish();
                    compare(pool, view, "seed " + seed + ", edits before step " + step);
                }
                pool.step(Scenes.DT);
                compare(pool, view, "seed " + seed + ", step " + step);
            }
        }
        assertThat(touched).isGreaterThan(4 * STEPS);
    }

    private static void edit(Pool pool, SplittableRandom random) {
        RigidBody any = pool.bodies().get(4 + random.nextInt(pool.bodies().size() - 4));
        switch (random.nextInt(6)) {
            case 0 -> pool.remove(any);
            case 1 ->
                    pool.add(
                            BodyDefinition.dynamic(SWEPT[random.nextInt(SWEPT.length)])
                                    .at(random.nextDouble(-6, 6), random.nextDouble(4, 9)));
            case 2 -> any.moveTo(random.nextDouble(-6, 6), random.nextDouble(3, 9), 1);
            case 3 -> any.shape(SWEPT[random.nextInt(SWEPT.length)]);
            case 4 -> any.disable();
            default -> any.filter(Filter.ALL.category(1 << random.nextInt(3)));
        }
    }

    @Test
    void aPoolWithoutContactsIsToldAlike() {
        Pool pool = new Pool(Effects.of(new Gravity(0, -9.81)), Accuracy.GAME);
        for (int i = 0; i < 200; i++) {
            Shape shape = SWEPT[i % SWEPT.length];
            pool.add(BodyDefinition.dynamic(shape).at(i % 16 - 8, i / 20).angle(i).velocity(0, 3));
        }
        SharedView view = pool.shared();
        for (int step = 1; step <= STEPS; step++) {
            pool.step(Scenes.DT);
            compare(pool, view, "step " + step);
        }
        assertThat(hit).isGreaterThan(STEPS);
    }

    /** Effects are declared and left out while readings go on: columns come and go. */
    @Test
    void poolsWhoseEffectsChangeAreToldAlike() {
        Pool pool = Scenes.MIXTURE.build();
        SharedView view = pool.shared();
        Effects usual = pool.effects();
        for (int step = 1; step <= STEPS; step++) {
            if (step % 7 == 0) {
                pool.effects(step % 2 == 0 ? usual : Effects.of(new Gravity(0, 1)));
            }
            pool.step(Scenes.DT);
            compare(pool, view, "step " + step);
        }
        assertThat(touched).isGreaterThan(STEPS / 2);
    }

    private void compare(Pool pool, SharedView view, String where) {
        try (Picture picture = view.read()) {
            assertThat(picture.time()).as(where).isEqualTo(pool.time());
            compareBodies(pool, picture, where);
            compareContacts(pool, picture, where);
            for (int i = 0; i < QUESTIONS; i++) {
                String question = where + ", question " + i;
                ask(pool, picture, question);
                askForShapes(pool, picture, question);
            }
        }
    }

    private static void compareBodies(Pool pool, Picture picture, String where) {
        assertThat(picture.bodies()).as(where).isEqualTo(pool.bodies());
        for (RigidBody body : pool.bodies()) {
            assertThat(picture.shows(body)).isTrue();
            assertThat(
                            Arrays.asList(
                                    picture.x(body),
                                    picture.y(body),
                                    picture.angle(body),
                                    picture.velocityX(body),
                                    picture.velocityY(body),
                                    picture.angularVelocity(body),
                                    picture.type(body),
                                    picture.shape(body),
                                    picture.isAwake(body)))
                    .as(where)
                    .containsExactly(
                            body.x(),
                            body.y(),
                            body.angle(),
                            body.velocityX(),
                            body.velocityY(),
                            body.angularVelocity(),
                            body.type(),
                            body.shape(),
                            body.isAwake());
        }
    }

    private void compareContacts(Pool pool, Picture picture, String where) {
        List<ContactEvent> events = pool.contactEvents();
        assertThat(picture.contactEvents()).as(where).isEqualTo(events);
        List<String> expected = new ArrayList<>();
        List<String> told = new ArrayList<>();
        pool.forEachContact(contact -> expected.add(words(contact)));
        picture.forEachContact(contact -> told.add(words(contact)));
        assertThat(told).as(where).isEqualTo(expected);
        touched += events.size();
        Pairs pairs = PoolStorage.of(pool).pairs;
        for (ContactEvent event : events) {
            if (event.bothAlive()) {
                boolean touching = pool.touching(event.a(), event.b());
                assertThat(picture.touching(event.a(), event.b())).isEqualTo(touching);
                assertThat(picture.touching(event.b(), event.a())).isEqualTo(touching);
                assertThat(touching).as(where).isEqualTo(isPairTouching(pairs, event));
            }
        }
    }

    /** The truth that two lists of pairs must come to: every pair of the two bodies, one by one. */
    private static boolean isPairTouching(Pairs pairs, ContactEvent event) {
        boolean isTouching = false;
        for (int pair = 0; pair < pairs.slots.high; pair++) {
            isTouching |=
                    pairs.bodyA[pair] == event.a().slot()
                            && pairs.bodyB[pair] == event.b().slot()
                            && pairs.touching[pair];
        }
        return isTouching;
    }

    private static String words(ContactView contact) {
        StringBuilder words = new StringBuilder().append(contact.event()).append(contact.friction);
        for (int i = 0; i < contact.points; i++) {
            words.append(' ').append(contact.pointX[i]).append(' ').append(contact.pointY[i]);
            words.append(' ').append(contact.separation[i]).append(' ').append(contact.force[i]);
        }
        return words.toString();
    }

    private void ask(Pool pool, Picture picture, String question) {
        double x = x();
        double y = y();
        double toX = x();
        double toY = y();
        Optional<RigidBody> body = pool.bodyAt(x, y);
        assertThat(picture.bodyAt(x, y)).as(question).isEqualTo(body);
        held += body.isPresent() ? 1 : 0;
        Optional<RayHit> first = pool.rayCast(x, y, toX, toY);
        assertThat(picture.rayCast(x, y, toX, toY)).as(question).isEqualTo(first);
        hit += first.isPresent() ? 1 : 0;
        Filter filter = Filter.ALL.mask(~(1 << random.nextInt(3)));
        assertThat(picture.rayCast(x, y, toX, toY, filter))
                .as(question)
                .isEqualTo(pool.rayCast(x, y, toX, toY, filter));
        assertThat(picture.rayCastAll(x, y, toX, toY, filter))
                .as(question)
                .isEqualTo(pool.rayCastAll(x, y, toX, toY, filter));
        assertThat(picture.nearest(x, y, 2, filter))
                .as(question)
                .isEqualTo(pool.nearest(x, y, 2, filter));
    }

    private void askForShapes(Pool pool, Picture picture, String question) {
        double x = x();
        double y = y();
        Aabb box = new Aabb(x, y, x + random.nextDouble(3), y + random.nextDouble(3));
        List<RigidBody> expected = new ArrayList<>();
        List<RigidBody> told = new ArrayList<>();
        pool.overlapping(box, expected::add);
        picture.overlapping(box, told::add);
        Shape shape = SWEPT[random.nextInt(SWEPT.length)];
        Placement at = new Placement(x, y, random.nextDouble(6));
        pool.overlapping(shape, at, Filter.ALL, expected::add);
        picture.overlapping(shape, at, Filter.ALL, told::add);
        assertThat(told).as(question).isEqualTo(expected);
        double dx = random.nextDouble(-8, 8);
        double dy = random.nextDouble(-8, 8);
        assertThat(picture.cast(shape, at, dx, dy, Filter.ALL))
                .as(question)
                .isEqualTo(pool.cast(shape, at, dx, dy, Filter.ALL));
    }

    private double x() {
        return random.nextDouble(-10, 10);
    }

    private double y() {
        return random.nextDouble(-1, 9);
    }
}
