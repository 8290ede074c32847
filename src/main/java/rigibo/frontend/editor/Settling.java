package rigibo.frontend.editor;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.editor.draft.Settled;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.PuzzleGame;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Lets a draft move until everything rests, before the author's eyes, and makes that its start. All
 * of it is one change, which is undone at once. If something leaves the world or never rests, the
 * draft stays as it was.
 */
final class Settling {

    /** Steps in each turn: eight times as fast as in play. */
    private static final int HASTE = 8;

    /** A draft that has not come to rest by then never will: for instance, a motor drives it. */
    private static final int LONGEST = Steps.of(30);

    /**
     * A draft that stays still for this many steps is at rest; at the top of a swing everything is
     * still for a moment.
     */
    private static final int STILL = Steps.of(1);

    /** Below the world, so deep that nothing comes back from there, m. */
    private static final double BOTTOM = -1;

    private final Desk desk;
    private final PuzzleGame game;
    private final Draft origin;
    private String culprit = "";

    /** How it stands. */
    enum State {
        MOVING,
        RESTED,
        LOST,
        RESTLESS
    }

    /** Begins with the level that the desk's draft is. */
    Settling(Desk desk, Level level) {
        this.desk = desk;
        game = new PuzzleGame(level, Accuracy.GAME);
        origin = desk.draft();
        desk.history().begin();
    }

    /** JSON pointer of what left the world, or did not rest; empty as long as nothing did. */
    String culprit() {
        return culprit;
    }

    /** Moves on; the draft is done with unless everything is still moving. */
    State turn() {
        for (int i = 0; i < HASTE; i++) {
            game.step();
        }
        Map<String, RigidBody> bodies = bodies();
        State state = state(bodies);
        switch (state) {
            case MOVING -> desk.change(posed(bodies));
            case RESTED -> {
                desk.change(posed(bodies));
                desk.change(new Settled(origin, desk.draft()).start());
                desk.history().end();
            }
            case LOST, RESTLESS -> cancel();
        }
        return state;
    }

    /** Leaves the draft as it was. */
    void cancel() {
        desk.history().cancel();
    }

    private State state(Map<String, RigidBody> bodies) {
        for (Map.Entry<String, RigidBody> entry : bodies.entrySet()) {
            if (hasLeft(entry.getValue())) {
                culprit = entry.getKey();
                return State.LOST;
            }
        }
        if (game.stillSteps() >= STILL) {
            return State.RESTED;
        }
        if (game.steps() < LONGEST) {
            return State.MOVING;
        }
        culprit = fastest(bodies);
        return State.RESTLESS;
    }

    private static boolean hasLeft(RigidBody body) {
        return !body.isAlive() || body.y() < BOTTOM;
    }

    private static String fastest(Map<String, RigidBody> bodies) {
        return bodies.entrySet().stream()
                .max(
                        Map.Entry.comparingByValue(
                                (one, other) -> Double.compare(speed(one), speed(other))))
                .map(Map.Entry::getKey)
                .orElse("");
    }

    private static double speed(RigidBody body) {
        return Math.hypot(body.velocityX(), body.velocityY())
                + Math.abs(body.angularVelocity()) * body.shape().boundingRadius();
    }

    private Draft posed(Map<String, RigidBody> bodies) {
        Draft posed = desk.draft();
        for (Map.Entry<String, RigidBody> entry : bodies.entrySet()) {
            RigidBody body = entry.getValue();
            Item item = origin.item(entry.getKey()).orElseThrow();
            Point centre = new Point(body.x(), body.y());
            posed = posed.with(Settled.posed(item, centre, Math.toDegrees(body.angle())));
        }
        return posed;
    }

    /** The bodies that forces move, by their place in the draft. */
    private Map<String, RigidBody> bodies() {
        Map<String, RigidBody> bodies = new LinkedHashMap<>();
        for (int i = 0; i < game.balls().size(); i++) {
            bodies.put(i == 0 ? "/ball" : "/moreBalls/" + (i - 1), game.balls().get(i));
        }
        for (int i = 0; i < game.pieces().size(); i++) {
            if (game.pieces().get(i).definition().isDynamic()) {
                bodies.put("/bodies/" + i, game.pieces().get(i).body());
            }
        }
        return bodies;
    }
}
