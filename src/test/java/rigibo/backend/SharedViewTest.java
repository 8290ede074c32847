package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldPoint;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;

/**
 * What readers of a shared view see, and when; steps and readers interleave as each test states.
 */
@Timeout(60)
class SharedViewTest {

    private static final double DT = Scenes.DT;

    private final Pool pool = new Pool();
    private final RigidBody floor = Scenes.addFloor(pool);
    private final RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 5));

    /** Asks on another thread, and waits for the answer. */
    private static <T> T elsewhere(Supplier<T> question) {
        return CompletableFuture.supplyAsync(question, work -> new Thread(work).start()).join();
    }

    /**
     * A force that depends on the place is asked for many times within a step, when the step has
     * already changed where bodies are. Whoever asks the view at such a time, on the thread that
     * steps or on another, is told of the former step.
     */
    @Test
    void withinAStepTheFormerOneIsTold() {
        SharedView[] view = new SharedView[1];
        List<List<Object>> told = new ArrayList<>();
        RigidBody[] seen = new RigidBody[1];
        Effects effects =
                Scenes.usualWithoutSleep()
                        .with(
                                new Field(
                                        at -> {
                                            at.push(-at.y, 0.3 * at.x);
                                            if (view[0] != null) {
                                                told.add(read(view[0], seen[0]));
                                                told.add(elsewhere(() -> read(view[0], seen[0])));
                                            }
                                        }));
        try (Pool whirl = new Pool(effects, Accuracy.GAME)) {
            seen[0] = whirl.add(BodyDefinition.dynamic(new Circle(0.5)).at(1, 3).velocity(2, 0));
            whirl.step(DT);
            SharedView shared = whirl.shared();
            for (int step = 0; step < 20; step++) {
                List<Object> former = live(whirl, seen[0], step);
                told.clear();
                view[0] = shared;
                whirl.step(DT);
                view[0] = null;
                assertThat(told).hasSizeGreaterThanOrEqualTo(4).containsOnly(former);
                assertThat(read(shared, seen[0])).isEqualTo(live(whirl, seen[0], step + 1));
                assertThat(seen[0].x()).isNotEqualTo(former.get(2));
            }
        }
    }

    private static List<Object> live(Pool pool, RigidBody body, long step) {
        return List.of(step, pool.time(), body.x(), body.y(), body.velocityX());
    }

    private static List<Object> read(SharedView view, RigidBody body) {
        try (Picture picture = view.read()) {
            assertThat(picture.bodyAt(picture.x(body), picture.y(body))).contains(body);
            return List.of(
                    picture.step(),
                    picture.time(),
                    picture.x(body),
                    picture.y(body),
                    picture.velocityX(body));
        }
    }

    @Test
    void anOpenPictureDoesNotChangeWhateverIsDone() {
        SharedView view = pool.shared();
        pool.step(DT);
        double y = box.y();
        try (Picture picture = view.read()) {
            Scenes.run(pool, 120);
            pool.remove(box);
            RigidBody successor =
                    pool.add(BodyDefinition.dynamic(Polygon.box(2, 2)).at(0, 9).name("later"));
            Scenes.run(pool, 5);
            assertThat(picture.step()).isEqualTo(1);
            assertThat(picture.time()).isEqualTo(DT);
            assertThat(picture.bodies()).containsExactly(floor, box);
            assertThat(picture.y(box)).isEqualTo(y);
            assertThat(picture.bodyAt(0, y)).contains(box);
            assertThat(picture.contactEvents()).isEmpty();
            // It may well have the slot of the removed one: it is told by name, not by slot.
            assertThat(successor.slot()).isEqualTo(box.everSlot());
            assertThat(picture.shows(successor)).isFalse();
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> picture.x(successor))
                    .withMessage("the body 'later' was not in the pool in step 1, which is shown");
        }
        try (Picture picture = view.read()) {
            assertThat(picture.step()).isEqualTo(126);
            assertThat(picture.shows(box)).isFalse();
            assertThatIllegalArgumentException().isThrownBy(() -> picture.touching(floor, box));
        }
    }

    @Test
    void editsAreSeenAfterTheNextStepOrWhenPublished() {
        SharedView view = pool.shared();
        box.moveTo(3, 7, 0);
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(1)).at(-3, 7));
        try (Picture picture = view.read()) {
            assertThat(picture.x(box)).isZero();
            assertThat(picture.shows(ball)).isFalse();
        }
        view.publish();
        try (Picture picture = view.read()) {
            assertThat(picture.step()).isZero();
            assertThat(picture.bodyAt(3, 7)).contains(box);
            assertThat(picture.bodyAt(-3, 7)).contains(ball);
        }
        pool.remove(ball);
        pool.step(DT);
        try (Picture picture = view.read()) {
            assertThat(picture.step()).isEqualTo(1);
            assertThat(picture.shows(ball)).isFalse();
            assertThat(picture.bodies()).doesNotContain(ball);
        }
    }

    /** A step that an error ended is not one that a reader sees. */
    @Test
    void aStepThatFailsIsNotShown() {
        boolean[] fails = new boolean[1];
        Field field =
                new Field(
                        at -> {
                            if (fails[0]) {
                                throw new ArithmeticException("of the caller's");
                            }
                            push(at);
                        });
        Pool failing = new Pool(Effects.usual().with(field), Accuracy.GAME);
        RigidBody ball = failing.add(BodyDefinition.dynamic(new Circle(1)));
        SharedView view = failing.shared();
        failing.step(DT);
        double y = ball.y();
        fails[0] = true;
        try {
            failing.step(DT);
            throw new AssertionError("the step did not fail");
        } catch (ArithmeticException expected) {
            assertThat(expected).hasMessage("of the caller's");
        }
        try (Picture picture = view.read()) {
            assertThat(picture.step()).isEqualTo(1);
            assertThat(picture.y(ball)).isEqualTo(y);
        }
    }

    private static void push(FieldPoint at) {
        at.push(1, 0);
    }

    @Test
    void theViewIsOneUntilThePoolIsClosed() {
        SharedView view = pool.shared();
        assertThat(pool.shared()).isSameAs(view);
        Picture open = view.read();
        pool.close();
        assertThatIllegalStateException()
                .isThrownBy(view::read)
                .withMessageContaining("the pool was closed");
        assertThatIllegalStateException()
                .isThrownBy(view::publish)
                .withMessageContaining("the pool was closed");
        pool.step(DT);
        assertThat(open.step()).isZero();
        assertThat(open.y(box)).isEqualTo(5);
        open.close();
        SharedView again = pool.shared();
        assertThat(again).isNotSameAs(view);
        try (Picture picture = again.read()) {
            assertThat(picture.step()).isZero();
            assertThat(picture.time()).isEqualTo(DT);
        }
    }

    /** Two and as many as were open at once, however many steps pass. */
    @Test
    void copiesAreBoundedByThePicturesThatWereOpen() {
        SharedView view = pool.shared();
        Scenes.run(pool, 20);
        assertThat(view.copies()).isEqualTo(2);
        List<Picture> open = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            pool.step(DT);
            open.add(view.read());
        }
        Scenes.run(pool, 20);
        assertThat(view.copies()).isEqualTo(7);
        for (int i = 0; i < 5; i++) {
            assertThat(open.get(i).step()).isEqualTo(21 + i);
            open.get(i).close();
        }
        Scenes.run(pool, 20);
        assertThat(view.copies()).isEqualTo(7);
    }

    @Test
    void misuseOfAPictureIsRefused() {
        Picture picture = pool.shared().read();
        assertThatThrownBy(() -> elsewhere(picture::time))
                .hasCauseInstanceOf(IllegalStateException.class)
                .hasMessageContaining("is for the thread that took it");
        RigidBody stranger = new Pool().add(BodyDefinition.dynamic(new Circle(1)).name("ball"));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> picture.x(stranger))
                .withMessage("the body 'ball' belongs to another pool");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> picture.shows(null))
                .withMessageContaining("body");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> picture.bodyAt(Double.NaN, 0))
                .withMessageContaining("bodyAt x must be finite");
        picture.close();
        assertThatIllegalStateException()
                .isThrownBy(() -> picture.bodyAt(0, 0))
                .withMessageContaining("was closed");
        assertThatIllegalStateException()
                .isThrownBy(picture::close)
                .withMessageContaining("was closed");
    }

    @Test
    void aPictureIsNotClosedWhileItsContactsAreVisited() {
        SharedView view = pool.shared();
        Scenes.run(pool, 120);
        try (Picture picture = view.read()) {
            int[] visits = new int[1];
            picture.forEachContact(
                    contact -> {
                        visits[0]++;
                        assertThat(picture.touching(contact.a, contact.b)).isTrue();
                        assertThatIllegalStateException()
                                .isThrownBy(picture::close)
                                .withMessageContaining("while contacts are visited");
                    });
            assertThat(visits[0]).isEqualTo(1);
        }
    }

    @Test
    void sharingBeginsBetweenSteps() {
        Pool[] stepped = new Pool[1];
        Field field = new Field(at -> stepped[0].shared());
        stepped[0] = new Pool(Effects.usual().with(field), Accuracy.GAME);
        stepped[0].add(BodyDefinition.dynamic(new Circle(1)));
        assertThatIllegalStateException()
                .isThrownBy(() -> stepped[0].step(DT))
                .withMessageContaining("cannot begin to share during a step");
        stepped[0].shared();
        assertThat(stepped[0].step(DT)).isNotNull();
        Field publishing = new Field(at -> stepped[0].shared().publish());
        stepped[0].effects(Effects.usual().with(publishing));
        assertThatIllegalStateException()
                .isThrownBy(() -> stepped[0].step(DT))
                .withMessageContaining("cannot publish during a step");
    }
}
