package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Threads query a pool while it steps. Its bodies move in lockstep, by 1/64 m in each step, which a
 * double adds without error: where a body is tells the step to the last bit. Torn pictures, and
 * pictures with another step's number, would be off by at least 1/64 m.
 */
@Timeout(300)
class SharedReadersTest {

    private static final double DT = 1.0 / 64;
    private static final int BODIES = 1500;
    private static final int READERS = 3;
    private static final int STEPS = 300;

    /** Readings that each reader begins and ends within one and the same step. */
    private static final int READINGS_WITHIN_STEPS = 200;

    private final Pool pool = new Pool(Effects.of(new Contacts()), Accuracy.GAME);
    private final Deque<RigidBody> bodies = new ArrayDeque<>();

    /** Odd while a step runs. */
    private final AtomicInteger turns = new AtomicInteger();

    private final AtomicInteger steps = new AtomicInteger();

    @Test
    void everyReadingIsOfOneFinishedStep() {
        for (int i = 0; i < BODIES; i++) {
            add(i, 0);
        }
        SharedView view = pool.shared();
        List<CompletableFuture<Integer>> readers = new ArrayList<>();
        for (int i = 0; i < READERS; i++) {
            SplittableRandom random = new SplittableRandom(i);
            readers.add(
                    CompletableFuture.supplyAsync(
                            () -> read(view, random), SharedReadersTest::start));
        }
        CompletableFuture<Void> all =
                CompletableFuture.allOf(readers.toArray(new CompletableFuture<?>[0]));
        for (int step = 1; step <= STEPS || !all.isDone(); step++) {
            pool.remove(bodies.remove());
            add(step % 200, step - 1);
            turns.incrementAndGet();
            pool.step(DT);
            turns.incrementAndGet();
            steps.incrementAndGet();
        }
        assertThat(view.copies()).isBetween(2, READERS + 2);
        for (CompletableFuture<Integer> reader : readers) {
            assertThat(reader.join()).isGreaterThanOrEqualTo(READINGS_WITHIN_STEPS);
        }
    }

    private static void start(Runnable reader) {
        Thread thread = new Thread(reader, "reader");
        thread.setDaemon(true);
        thread.start();
    }

    /** Rows in which nobody meets anybody; the name tells where and after which step it began. */
    private void add(int place, int step) {
        int row = bodies.size() + step;
        int x = 4 * (place % 50);
        bodies.add(
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.25))
                                .at(x, 2 * row)
                                .velocity(1, 0)
                                .name(x + " " + 2 * row + " " + step)));
    }

    /** Number of readings that were wholly within one step. */
    private int read(SharedView view, SplittableRandom random) {
        int within = 0;
        while (within < READINGS_WITHIN_STEPS || steps.get() < STEPS) {
            int turn = turns.get();
            int finished = steps.get();
            try (Picture picture = view.read()) {
                check(picture, finished, random);
            }
            within += turn % 2 == 1 && turns.get() == turn ? 1 : 0;
        }
        return within;
    }

    private static void check(Picture picture, int finished, SplittableRandom random) {
        long step = picture.step();
        require(step >= finished, "step %d is told after %d were finished", step, finished);
        require(picture.time() == step * DT, "time %s in step %d", picture.time(), step);
        List<RigidBody> shown = picture.bodies();
        require(shown.size() == BODIES, "%d bodies", shown.size());
        for (int i = 0; i < 12; i++) {
            RigidBody body = shown.get(random.nextInt(BODIES));
            String[] words = body.name().split(" ");
            double x = Integer.parseInt(words[0]) + (step - Integer.parseInt(words[2])) * DT;
            double y = Integer.parseInt(words[1]);
            require(picture.x(body) == x, "%s is at %s in step %d", body, picture.x(body), step);
            require(picture.y(body) == y, "%s is at %s in step %d", body, picture.y(body), step);
            require(picture.bodyAt(x, y).orElse(null) == body, "%s is not found", body);
            require(
                    picture.rayCast(x - 1, y, x, y).orElseThrow().body() == body,
                    "%s is not hit",
                    body);
            List<RigidBody> inside = new ArrayList<>();
            picture.overlapping(new Aabb(x - 0.5, y - 0.5, x + 0.5, y + 0.5), inside::add);
            require(inside.equals(List.of(body)), "%s is not alone, but %s", body, inside);
        }
    }

    private static void require(boolean holds, String message, Object... words) {
        if (!holds) {
            throw new AssertionError(String.format(message, words));
        }
    }
}
