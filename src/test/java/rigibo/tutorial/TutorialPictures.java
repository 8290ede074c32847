package rigibo.tutorial;

import static rigibo.tutorial.PoolFigure.Ink.FAINT;
import static rigibo.tutorial.PoolFigure.Ink.GOOD;
import static rigibo.tutorial.PoolFigure.Ink.PLAIN;

import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The pictures of the tutorial: each shows the bodies of its chapter's program as they move. */
public final class TutorialPictures {

    private static final double STEP = 1.0 / 60; // s

    private TutorialPictures() {}

    /** All of them as SVG, by the names of their files. */
    public static Map<String, String> all() {
        Map<String, String> pictures = new LinkedHashMap<>();
        pictures.put("1-falling-box.svg", fallingBox());
        pictures.put("2-slide-and-bounce.svg", slideAndBounce());
        pictures.put("3-pendulum.svg", pendulum());
        pictures.put("4-trap-door.svg", trapDoor());
        pictures.put("5-look-ahead.svg", lookAhead());
        pictures.put("6-towers.svg", towers());
        pictures.put("7-cut-the-rope.svg", cutTheRope());
        return pictures;
    }

    private static void run(Pool pool, int steps) {
        for (int i = 0; i < steps; i++) {
            pool.step(STEP);
        }
    }

    private static String fallingBox() {
        PoolFigure figure = new PoolFigure(-4, -0.6, 4, 6.4);
        Pool pool = new Pool();
        RigidBody box = FallingBox.build(pool);
        for (int exposure = 0; exposure < 4; exposure++) {
            figure.body(pool, box, FAINT);
            figure.words(0.8, box.y(), String.format(Locale.ROOT, "%.2f s", pool.time()));
            run(pool, 15);
        }
        run(pool, 60);
        figure.pool(pool, PLAIN);
        figure.arrow(-1, FallingBox.HEIGHT, -1, 0);
        figure.words(-1.8, FallingBox.HEIGHT / 2, "5 m");
        return figure.svg();
    }

    private static String slideAndBounce() {
        PoolFigure figure = new PoolFigure(-5, -0.6, 7, 5);
        Pool pool = new Pool();
        SlideAndBounce.build(pool);
        for (int exposure = 0; exposure < 30; exposure++) {
            figure.body(pool, pool.bodies().get(2), FAINT);
            if (exposure % 3 == 0) {
                figure.body(pool, pool.bodies().get(1), FAINT);
            }
            run(pool, 5);
        }
        figure.pool(pool, PLAIN);
        return figure.svg();
    }

    private static String pendulum() {
        PoolFigure figure = new PoolFigure(-3, 0.4, 3, 3.6);
        Pool pool = Pendulum.open();
        Joint rod = Pendulum.build(pool);
        int half = (int) Math.round(Pendulum.period() / 2 / STEP);
        for (int i = 0; i <= half; i++) {
            if (i % 9 == 0) {
                figure.pool(pool, i == 45 ? PLAIN : FAINT);
            }
            run(pool, 1);
        }
        figure.body(pool, rod.a(), PLAIN);
        return figure.svg();
    }

    private static String trapDoor() {
        PoolFigure figure = new PoolFigure(-5, -0.6, 5, 6.8);
        Pool pool = TrapDoor.open();
        TrapDoor.Trap trap = TrapDoor.build(pool);
        boolean isOpen = false;
        figure.body(pool, trap.door(), FAINT);
        for (int i = 0; i < 63; i++) {
            if (i % 7 == 0) {
                figure.body(pool, trap.ball(), FAINT);
            }
            run(pool, 1);
            isOpen = isOpen || TrapDoor.opens(pool, trap);
        }
        figure.pool(pool, PLAIN);
        figure.words(1, 4.5, "the eye, a sensor");
        figure.words(-4.4, 1.9, "the door");
        figure.arrow(-0.5, 2.3, -1.8, 2.3);
        return figure.svg();
    }

    private static String lookAhead() {
        PoolFigure figure = new PoolFigure(-1, -0.6, 9.5, 4.6);
        Pool pool = new Pool();
        LookAhead.build(pool);
        byte[] before = pool.snapshot();
        for (int degrees = 15; degrees <= 75; degrees += 5) {
            figure.path(flight(Pool.restore(before), degrees), FAINT);
        }
        figure.path(flight(Pool.restore(before), 45), GOOD);
        figure.pool(pool, PLAIN);
        figure.words(4.3, 2.5, "45°");
        return figure.svg();
    }

    private static List<double[]> flight(Pool pool, double degrees) {
        List<double[]> points = new ArrayList<>();
        RigidBody ball = LookAhead.ball(pool);
        LookAhead.launch(ball, degrees);
        while (pool.hits().isEmpty()) {
            points.add(new double[] {ball.x(), ball.y()});
            pool.step(STEP);
        }
        return points;
    }

    private static String towers() {
        PoolFigure figure = new PoolFigure(-5.9, -0.5, 5.9, 2.9);
        Pool pool = Towers.run(1);
        figure.pool(pool, PLAIN);
        pool.forEachContact(
                contact -> {
                    // A metre for 600 N: the weight of a tower, 490 N, is drawn 0.8 m long.
                    double length = contact.impulse / STEP / 600;
                    // Side by side, for those of a tower stand above each other.
                    double x = contact.x + 0.3 * (contact.y - 1);
                    figure.arrow(x, contact.y, x, contact.y + length);
                });
        return figure.svg();
    }

    private static String cutTheRope() {
        PoolFigure figure = new PoolFigure(-3, -0.2, 5, 5.6);
        CutTheRope game = CutTheRope.begin(Accuracy.GAME);
        int steps = 0;
        while (!game.copy(Accuracy.DRAFT).winsIfCutNow()) {
            if (steps % 9 == 0) {
                figure.pool(game.pool(), FAINT);
            }
            game.step();
            steps++;
        }
        figure.pool(game.pool(), PLAIN);
        figure.words(game.ball().x() - 1.3, game.ball().y() - 0.4, "cut here");
        game.cut();
        for (int i = 0; !game.isWon(); i++) {
            game.step();
            if (i % 6 == 5) {
                figure.body(game.pool(), game.ball(), FAINT);
            }
        }
        figure.body(game.pool(), game.ball(), GOOD);
        return figure.svg();
    }
}
