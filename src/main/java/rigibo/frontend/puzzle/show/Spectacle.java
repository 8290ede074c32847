package rigibo.frontend.puzzle.show;

import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.level.Handling;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.level.World;
import rigibo.frontend.puzzle.picture.Skins;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Link;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.joint.JointPen;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Animations for display only: deleted boxes burst, impacts raise dust, the ball glows, confetti
 * flies, cut ropes hang down, and a lost world turns grey. It observes the game instead of
 * receiving events, so that a click of any origin looks the same.
 */
final class Spectacle {

    /** Turns for which a deleted box is squashed: 80 ms. */
    private static final int SQUASH_TURNS = 5;

    /** Turns in which a lost world becomes grey. */
    private static final int GREYING_TURNS = 36;

    /** Turns for which the ball flashes when the level is solved. */
    private static final int FLASH_TURNS = 40;

    /** Width of the glow, in radii of the ball. */
    private static final double GLOW = 4.6;

    /** Speed of falling from which on a RigiBo looks afraid, m/s. */
    private static final double FEARED = 2.0;

    /** Cut of a rope without a pointer, as a share of its length. */
    static final double MIDDLE = 0.5;

    private final Belts belts = new Belts();
    private final Flashes flashes = new Flashes();
    private final LooseEnds looseEnds = new LooseEnds();
    private final Map<String, Double> cuts = new HashMap<>();
    private final Splinters splinters = new Splinters();
    private final Dust dust = new Dust();
    private final List<Squashed> squashed = new ArrayList<>();
    private final List<Optional<Remains>> last = new ArrayList<>();
    private final Session session;
    private PuzzleGame watched;
    private int steps;
    private int grey;
    private int flash;
    private int acts;

    /** A body that is disappearing. */
    private static final class Squashed {
        final Remains remains;
        int turns;

        Squashed(Remains remains) {
            this.remains = remains;
        }
    }

    Spectacle(Session session) {
        this.session = session;
        begin(session.game());
    }

    /** Makes one frame of 1/60 s, after the session has. */
    void frame() {
        PuzzleGame game = session.game();
        if (game != watched) {
            begin(game);
        }
        watchPieces();
        watchClicks();
        if (game.steps() != steps) {
            dust.raise(game.pool());
            World world = game.level().world();
            looseEnds.step(world.gravityX(), world.gravityY(), game.pool());
            belts.step(game);
            steps = game.steps();
        }
        squashed.forEach(body -> body.turns++);
        burst();
        splinters.step();
        flashes.step();
        dust.step();
        grey = game.outcome() == Outcome.LOST ? Math.min(GREYING_TURNS, grey + 1) : 0;
        flash = Math.max(0, flash - 1);
    }

    /** Removes all animations of the old attempt when a new one begins or a click is undone. */
    private void begin(PuzzleGame game) {
        watched = game;
        steps = game.steps();
        splinters.clear();
        dust.clear();
        squashed.clear();
        last.clear();
        grey = 0;
        flash = 0;
        looseEnds.clear();
        belts.clear();
        flashes.clear();
        acts = game.acts().size();
        for (Act act : game.acts()) {
            rope(act).ifPresent(it -> looseEnds.hang(it, cut(act), game.pool()));
        }
    }

    /** A rope that a click cut. */
    private Optional<Link> rope(Act act) {
        return watched.target(act.target())
                .filter(target -> target.is(Verb.CUT))
                .map(Link.class::cast);
    }

    private double cut(Act act) {
        return cuts.getOrDefault(act.target(), MIDDLE);
    }

    private void watchClicks() {
        List<Act> all = watched.acts();
        for (Act act : all.subList(acts, all.size())) {
            watched.target(act.target()).ifPresent(this::flashIfFrozen);
            rope(act).ifPresent(it -> looseEnds.cut(it, cut(act)));
        }
        acts = all.size();
    }

    private void flashIfFrozen(Target target) {
        if (target instanceof Piece piece && piece.is(Verb.FREEZE)) {
            flashes.freeze(piece.x(), piece.y(), piece.body().shape().boundingRadius());
        }
    }

    /**
     * Sets the place at which the pointer is about to cut a rope; after an undo it is cut there
     * again. Without it, a rope is cut in its middle.
     *
     * @param share of its length, 0 to 1
     */
    void cutting(Link rope, double share) {
        cuts.put(rope.id(), share);
    }

    /** Draws the moving parts of a piece: chevrons of a belt, the fuse of a bomb, embers. */
    void drawOn(Canvas canvas, Camera camera, Piece piece) {
        Pose pose = session.pose(piece.body());
        belts.draw(canvas, camera, piece, pose);
        Bombs.draw(canvas, camera, piece, pose, watched.steps());
        Embers.draw(canvas, camera, piece, pose, watched.steps());
    }

    /** Draws the remains of cut ropes. */
    void drawRopes(JointPen pen) {
        looseEnds.draw(pen);
    }

    private void watchPieces() {
        List<Piece> pieces = watched.pieces();
        for (int i = 0; i < pieces.size(); i++) {
            Optional<Remains> now = seen(pieces.get(i));
            if (i == last.size()) {
                last.add(now);
            }
            Piece piece = pieces.get(i);
            if (now.isEmpty() && piece.is(Verb.LIGHT)) {
                last.get(i).ifPresent(remains -> blowUp(piece, remains));
            }
            if (now.isEmpty() && piece.melt().isPresent()) {
                last.get(i).ifPresent(splinters::burst);
            }
            if (now.isEmpty() && piece.is(Verb.DELETE)) {
                last.get(i).ifPresent(remains -> squashed.add(new Squashed(remains)));
            }
            last.set(i, now);
        }
    }

    private void blowUp(Piece bomb, Remains remains) {
        if (bomb.fuse().filter(fuse -> fuse.isBurntDown(watched.steps())).isPresent()) {
            Handling.Charge charge = bomb.definition().handling().charge().orElseThrow();
            Pose at = remains.pose();
            flashes.blast(at.x(), at.y(), charge.radius() + charge.falloff());
            splinters.burst(remains);
        }
    }

    private Optional<Remains> seen(Piece piece) {
        RigidBody body = piece.body();
        return body.isAlive()
                ? Optional.of(
                        new Remains(body.shape(), session.pose(body), Skins.of(piece.substance())))
                : Optional.empty();
    }

    private void burst() {
        for (Iterator<Squashed> each = squashed.iterator(); each.hasNext(); ) {
            Squashed body = each.next();
            if (body.turns > SQUASH_TURNS) {
                splinters.burst(body.remains);
                each.remove();
            }
        }
    }

    /** Confetti, and a flash of the ball's glow. */
    void celebrate() {
        flash = FLASH_TURNS;
        watched.balls().forEach(ball -> splinters.celebrate(ball.x(), ball.y()));
    }

    /** The mood of a piece that is not under the pointer. */
    Canvas.Mood mood(Piece piece) {
        return switch (watched.outcome()) {
            case WON -> Canvas.Mood.CHEERING;
            case LOST -> Canvas.Mood.WORRIED;
            case RUNNING ->
                    piece.body().velocityY() < -FEARED ? Canvas.Mood.WORRIED : Canvas.Mood.PLAIN;
        };
    }

    /** Draws it above the bodies. */
    void draw(Canvas canvas, Camera camera, Motion motion) {
        boolean isFull = motion == Motion.FULL;
        canvas.veil(isFull ? grey / (double) GREYING_TURNS : grey > 0 ? 1 : 0);
        for (Squashed body : squashed) {
            body.remains.draw(canvas, Math.min(1, body.turns / (double) SQUASH_TURNS));
        }
        dust.draw(canvas);
        glow(canvas, isFull ? flash / (double) FLASH_TURNS : 0);
        splinters.draw(canvas);
        if (isFull) {
            flashes.draw(canvas, camera);
        }
    }

    /** Draws the glow of every ball, which grows while the ball is held and flashes at the end. */
    private void glow(Canvas canvas, double flashing) {
        double held = watched.held();
        if (held > 0 && watched.outcome() != Outcome.LOST) {
            double strength = 0.08 + 0.24 * held * held + 0.3 * flashing;
            Color color = Color.BRASS.alpha(Math.min(1, strength));
            for (RigidBody ball : watched.balls()) {
                Pose pose = session.pose(ball);
                double size = GLOW * ball.shape().boundingRadius() * (1 + 0.6 * flashing);
                canvas.glow(pose.x(), pose.y(), size, color);
            }
        }
    }
}
