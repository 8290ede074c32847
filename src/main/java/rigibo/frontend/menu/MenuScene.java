package rigibo.frontend.menu;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/**
 * The main menu: levels on the left, demos on the right, and a few RigiBos that watch the pointer.
 */
public final class MenuScene implements Scene {

    private static final double TOP = 292;
    private static final double ROW = 62;
    private static final double CARD_HEIGHT = 54;
    private static final double CARD_WIDTH = 316;
    private static final double LEFT = 32;
    private static final double RIGHT = WIDTH - LEFT - CARD_WIDTH;
    private static final double STEP = 1.0 / 60;

    private final Director director;
    private final List<Card> cards = new ArrayList<>();
    private final Camera camera = Camera.ofPuzzle();
    private final Pool pool = new Pool();
    private final List<RigidBody> boxes = new ArrayList<>();
    private final RigidBody ball;
    private int chosen;
    private double pointerX = WIDTH / 2.0;
    private double pointerY = HEIGHT / 2.0;

    /** One thing to choose. */
    private record Card(SceneEntry entry, double x, double y) {
        boolean contains(double px, double py) {
            return px >= x && px <= x + CARD_WIDTH && py >= y && py <= y + CARD_HEIGHT;
        }
    }

    /** A menu of the catalog's entries. */
    public MenuScene(Director director, List<SceneEntry> entries) {
        this.director = director;
        layOut(entries, SceneEntry.Kind.LEVEL, LEFT);
        layOut(entries, SceneEntry.Kind.DEMO, RIGHT);
        pool.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(4.5, -0.2));
        for (int i = 0; i < 3; i++) {
            boxes.add(box(0.8 + 0.9 * i, 0.7, 0.75));
        }
        boxes.add(box(1.25, 3, 0.75));
        boxes.add(box(7.6, 2, 1.0));
        ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.35))
                                .at(5.2, 4)
                                .velocity(0.4, 0)
                                .material(new Material(1, 0.5, 0.75)));
    }

    private RigidBody box(double x, double y, double size) {
        return pool.add(
                BodyDefinition.dynamic(Polygon.box(size, size))
                        .at(x, y)
                        .material(new Material(1, 0.5, 0.3)));
    }

    private void layOut(List<SceneEntry> entries, SceneEntry.Kind kind, double x) {
        double y = TOP;
        for (SceneEntry entry : entries) {
            if (entry.kind() == kind) {
                cards.add(new Card(entry, x, y));
                y += ROW;
            }
        }
    }

    @Override
    public String title() {
        return "RigiBo";
    }

    @Override
    public void step() {
        pool.step(STEP);
    }

    @Override
    public void draw(Canvas canvas) {
        canvas.camera(camera);
        canvas.gaze(camera.worldX(pointerX), camera.worldY(pointerY));
        canvas.body(Polygon.box(9.4, 1), 4.5, -0.2, 0, Skin.WOOD, Canvas.Mood.PLAIN);
        for (RigidBody box : boxes) {
            canvas.body(box.shape(), box.x(), box.y(), box.angle(), Skin.RIGIBO, Canvas.Mood.PLAIN);
        }
        canvas.body(ball.shape(), ball.x(), ball.y(), ball.angle(), Skin.BALL, Canvas.Mood.PLAIN);
        drawTitle(canvas);
        for (int i = 0; i < cards.size(); i++) {
            drawCard(canvas, cards.get(i), i == chosen);
        }
    }

    private void drawTitle(Canvas canvas) {
        words(canvas, "RigiBo", WIDTH / 2.0, 104, 92, Canvas.Align.CENTRE, Color.BRASS);
        words(
                canvas,
                "Delete boxes so that the ball comes to rest on the wood.",
                WIDTH / 2.0,
                172,
                20,
                Canvas.Align.CENTRE,
                Color.TEXT);
        words(canvas, "The puzzle", LEFT + 6, TOP - 26, 22, Canvas.Align.LEFT, Color.BRASS);
        words(canvas, "The physics", RIGHT + 6, TOP - 26, 22, Canvas.Align.LEFT, Color.BRASS);
        words(
                canvas,
                "Arrows and Enter, or the mouse. Esc leaves, F11 fills the screen.",
                WIDTH / 2.0,
                HEIGHT - 10,
                16,
                Canvas.Align.CENTRE,
                Color.TEXT);
    }

    private void drawCard(Canvas canvas, Card card, boolean isChosen) {
        Color plate = isChosen ? Color.PANEL_LIT : Color.PANEL;
        canvas.panel(card.x(), card.y(), CARD_WIDTH, CARD_HEIGHT, 12, plate);
        if (isChosen) {
            canvas.frame(card.x(), card.y(), CARD_WIDTH, CARD_HEIGHT, 12, Color.BRASS);
        }
        double x = card.x() + 16;
        words(canvas, card.entry().title(), x, card.y() + 18, 20, Canvas.Align.LEFT, Color.TEXT);
        words(
                canvas,
                card.entry().words(),
                x,
                card.y() + 39,
                16,
                Canvas.Align.LEFT,
                Color.TEXT_DIM);
    }

    private static void words(
            Canvas canvas,
            String words,
            double x,
            double y,
            double size,
            Canvas.Align align,
            Color color) {
        canvas.text(words, x, y, size, Canvas.Font.WORDS, align, color);
    }

    @Override
    public void pointerMoved(double x, double y) {
        pointerX = x;
        pointerY = y;
        int under = cardAt(x, y);
        chosen = under >= 0 ? under : chosen;
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        int under = cardAt(x, y);
        if (under >= 0 && button == PointerButton.LEFT) {
            open(under);
        }
    }

    @Override
    public void keyPressed(Key key) {
        if (cards.isEmpty()) {
            return;
        }
        switch (key) {
            case UP -> chosen = Math.floorMod(chosen - 1, cards.size());
            case DOWN, TAB -> chosen = Math.floorMod(chosen + 1, cards.size());
            case LEFT, RIGHT -> chosen = across();
            case ENTER, SPACE -> open(chosen);
            default -> {}
        }
    }

    /** The card of the other column nearest in height. */
    private int across() {
        Card from = cards.get(chosen);
        int best = chosen;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < cards.size(); i++) {
            double distance = Math.abs(cards.get(i).y() - from.y());
            if (cards.get(i).x() != from.x() && distance < least) {
                least = distance;
                best = i;
            }
        }
        return best;
    }

    private int cardAt(double x, double y) {
        for (int i = 0; i < cards.size(); i++) {
            if (cards.get(i).contains(x, y)) {
                return i;
            }
        }
        return -1;
    }

    private void open(int card) {
        director.show(cards.get(card).entry().open().apply(director));
    }
}
