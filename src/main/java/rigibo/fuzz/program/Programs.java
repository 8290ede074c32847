package rigibo.fuzz.program;

import rigibo.fuzz.chance.Chance;

import java.util.ArrayList;
import java.util.List;

/** Draws programs. A seed and an index make the same program in every JVM. */
public final class Programs {

    /** The most bodies that a program adds. */
    static final int MOST_BODIES = 200;

    /** A kind of operation and its frequency. */
    private record Share(double probability, Draw draw) {}

    private interface Draw {
        Operation next();
    }

    private final Chance chance;
    private final Temper temper;
    private final Verbs verbs;
    private final Connections connections;
    private final EverydayVerbs everyday;
    private final Questions questions;
    private final ShapeQuestions shapeQuestions;
    private final Refusals refusals;
    private int bodies;

    private Programs(Chance chance) {
        this.chance = chance;
        int expected = chance.oneOf(chance.whole(1, 6), chance.whole(1, 12), chance.whole(1, 30));
        expected = chance.happens(0.02) ? 100 : expected;
        temper = Temper.draw(chance, expected);
        Bodies drawnBodies = new Bodies(chance, temper);
        verbs = new Verbs(chance, temper, drawnBodies);
        connections = new Connections(chance, temper);
        everyday = new EverydayVerbs(chance, temper, drawnBodies);
        questions = new Questions(chance, temper);
        shapeQuestions = new ShapeQuestions(chance, temper, drawnBodies);
        refusals = new Refusals(chance);
        bodies = expected;
    }

    /** The program with an index among those of a seed. */
    public static Program of(long seed, long index) {
        return new Programs(Chance.of(seed, index)).draw();
    }

    private Program draw() {
        List<Operation> operations = new ArrayList<>();
        for (int number = 0; number < bodies; number++) {
            operations.add(verbs.add(number));
        }
        for (int left = chance.whole(5, 60); left > 0; left--) {
            operations.add(next());
        }
        return new Program(
                DrawnEffects.draw(chance, temper), DrawnAccuracy.draw(chance), operations);
    }

    private Operation next() {
        List<Share> shares =
                List.of(
                        new Share(0.35, verbs::steps),
                        new Share(0.16, () -> verbs.ofBody(body())),
                        new Share(0.08, () -> everyday.ofBody(body())),
                        new Share(0.02, everyday::explode),
                        new Share(0.04, () -> connections.join(body(), body())),
                        new Share(0.02, connections::change),
                        new Share(0.05, verbs::ofPool),
                        new Share(0.06, this::add),
                        new Share(0.07, () -> questions.ask(body(), body())),
                        new Share(0.03, () -> shapeQuestions.ask(body(), body())),
                        new Share(0.04, questions::copy),
                        new Share(0.08, () -> refusals.draw(body())));
        double drawn = chance.between(0, 1);
        for (Share share : shares) {
            drawn -= share.probability();
            if (drawn < 0) {
                return share.draw().next();
            }
        }
        return verbs.steps();
    }

    private Operation add() {
        return bodies < MOST_BODIES ? verbs.add(bodies++) : verbs.steps();
    }

    private int body() {
        return chance.whole(0, bodies - 1);
    }
}
