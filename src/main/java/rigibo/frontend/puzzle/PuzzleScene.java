package rigibo.frontend.puzzle;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** A level as it is played. */
public final class PuzzleScene implements Scene {

    /** How long a refused click shakes the ring, in turns. */
    private static final int SHAKE_TURNS = 18;

    private final Director director;
    private final List<Level> levels;
    private final int number;
    private final Level level;
    private final Session session;
    private final Hud hud;
    private final Splinters splinters = new Splinters();
    private final Camera camera;
    private final EffectsDrawer drawer;
    private double pointerX = WIDTH / 2.0;
    private double pointerY = HEIGHT / 2.0;
    private int chosen = -1;
    private int shake;
    private Outcome seen = Outcome.RUNNING;

    /** One of some levels, to be played in their order. */
    public PuzzleScene(Director director, List<Level> levels, int number) {
        this.director = director;
        this.levels = levels;
        this.number = number;
        level = levels.get(number);
        session = new Session(level, Accuracy.GAME);
        hud = new Hud(level);
        double width = level.world().width();
        double height = level.world().height();
        camera = new Camera(width / 2, height / 2, Math.min(WIDTH / width, HEIGHT / height));
        drawer = new EffectsDrawer(new LevelEffects(level, session), level.world(), camera);
    }

    @Override
    public String title() {
        return "RigiBo – " + level.title().in(Locale.getDefault());
    }

    @Override
    public void step() {
        session.frame();
        splinters.step();
        shake = Math.max(0, shake - 1);
        PuzzleGame game = session.game();
        if (game.isSolved() && seen != Outcome.WON) {
            splinters.celebrate(game.ball().x(), game.ball().y());
        }
        seen = game.outcome();
    }

    @Override
    public void draw(Canvas canvas) {
        PuzzleGame game = session.game();
        canvas.camera(camera);
        canvas.gaze(game.ball().x(), game.ball().y());
        body(canvas, game.platform(), Skin.WOOD, Canvas.Mood.PLAIN);
        for (Piece piece : game.pieces()) {
            if (piece.body().isAlive()) {
                body(canvas, piece.body(), skin(piece), mood(piece));
            }
        }
        body(canvas, game.ball(), Skin.BALL, Canvas.Mood.PLAIN);
        splinters.draw(canvas);
        drawRings(canvas, game);
        hud.drawBar(canvas, session);
        drawer.draw(canvas, hud.titleEnd(canvas));
        hud.drawKeys(canvas);
        if (game.outcome() != Outcome.RUNNING) {
            double above = drawer.isOpen() ? EffectsDrawer.FOOT : Hud.foot();
            hud.drawEnd(canvas, game, number + 1 < levels.size(), above);
        }
    }

    @Override
    public void drawn(long nanos) {
        drawer.drawn();
    }

    @Override
    public void closed() {
        drawer.close();
    }

    private static void body(Canvas canvas, RigidBody body, Skin skin, Canvas.Mood mood) {
        canvas.body(body.shape(), body.x(), body.y(), body.angle(), skin, mood);
    }

    /** The hold's ring round the ball, the cooldown's at the pointer. */
    private void drawRings(Canvas canvas, PuzzleGame game) {
        RigidBody ball = game.ball();
        double radius = ball.shape().boundingRadius() * camera.scale() + 8;
        double held = game.held();
        if (held > 0) {
            double x = camera.screenX(ball.x());
            double y = camera.screenY(ball.y());
            canvas.ring(x, y, radius, 6, 1, Color.PANEL_LIT);
            canvas.ring(x, y, radius, 6, held, Color.GOOD);
        }
        if (game.cooldownLeft() > 0) {
            double aside = shake > 0 ? 5 * Math.sin(shake * 1.4) : 0;
            hud.drawCooldown(canvas, pointerX + aside, pointerY, 16, game);
        }
    }

    private static Skin skin(Piece piece) {
        Substance substance = piece.definition().substance();
        return switch (substance) {
            case RIGIBO -> Skin.RIGIBO;
            case STONE -> Skin.STONE;
            case PLANK -> Skin.WOOD;
            case ICE -> Skin.ICE;
            case RUBBER -> Skin.RUBBER;
            case IRON -> Skin.IRON;
            case BALL -> Skin.BALL;
        };
    }

    private Canvas.Mood mood(Piece piece) {
        boolean isUnder = piece.isDeletable() && hovered().filter(piece::equals).isPresent();
        return isUnder ? Canvas.Mood.HOVERED : Canvas.Mood.PLAIN;
    }

    /** The piece chosen by keys, or under the pointer. */
    private Optional<Piece> hovered() {
        PuzzleGame game = session.game();
        if (chosen >= 0 && chosen < game.pieces().size()) {
            return Optional.of(game.pieces().get(chosen));
        }
        return game.pieceAt(camera.worldX(pointerX), camera.worldY(pointerY));
    }

    @Override
    public void pointerMoved(double x, double y) {
        pointerX = x;
        pointerY = y;
        chosen = -1;
        drawer.pointerMoved(x, y);
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        pointerMoved(x, y);
        if (button == PointerButton.LEFT && !drawer.pointerPressed(x, y)) {
            double worldX = camera.worldX(x);
            double worldY = camera.worldY(y);
            Optional<Piece> under = session.game().pieceAt(worldX, worldY);
            answer(session.game().click(worldX, worldY), under);
        }
    }

    private void answer(ClickResult result, Optional<Piece> piece) {
        switch (result) {
            case DELETED -> piece.ifPresent(this::burst);
            case COOLING_DOWN, NO_CLICKS_LEFT -> shake = SHAKE_TURNS;
            case NOT_DELETABLE, NOTHING_THERE, OVER -> {}
        }
    }

    /** The body is gone by now; its size and last place are the definition's and the pointer's. */
    private void burst(Piece piece) {
        double width = piece.definition().shape().smallestWidth();
        splinters.burst(camera.worldX(pointerX), camera.worldY(pointerY), width);
    }

    @Override
    public void keyPressed(Key key) {
        switch (key) {
            case R -> session.restart();
            case P -> session.togglePause();
            case E -> drawer.toggle();
            case BACKSPACE -> session.undo();
            case TAB -> chooseNext();
            case S -> session.pace(session.pace().slower());
            case N -> session.pace(session.pace().faster());
            case ENTER -> enter();
            default -> {}
        }
    }

    private void chooseNext() {
        List<Piece> pieces = session.game().pieces();
        for (int i = 1; i <= pieces.size(); i++) {
            int next = Math.floorMod(chosen + i, pieces.size());
            if (pieces.get(next).isDeletable()) {
                chosen = next;
                Piece piece = pieces.get(next);
                pointerX = camera.screenX(piece.body().x());
                pointerY = camera.screenY(piece.body().y());
                return;
            }
        }
    }

    /** Deletes the chosen box, or goes on to the next level. */
    private void enter() {
        PuzzleGame game = session.game();
        if (game.isSolved() && number + 1 < levels.size()) {
            director.show(new PuzzleScene(director, levels, number + 1));
        } else if (chosen >= 0) {
            Piece piece = game.pieces().get(chosen);
            answer(game.delete(piece.definition().id()), Optional.of(piece));
            chosen = -1;
        }
    }

    @Override
    public Optional<Demonstration> demonstration() {
        return level.solutions().isEmpty()
                ? Optional.empty()
                : Optional.of(new SolutionShow(session, camera, level.solutions().get(0)));
    }
}
