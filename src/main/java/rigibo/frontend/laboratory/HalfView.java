package rigibo.frontend.laboratory;

import rigibo.backend.RigidBody;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;

/** Draws a half: a plate with its switch and readouts, and the room below. */
final class HalfView {

    /** Width of plate and room, px. */
    static final double WIDTH = 348;

    static final double PLATE_HEIGHT = 68;

    /** Distance from the plate's upper edge to the room's, px. */
    private static final double ROOM_TOP = PLATE_HEIGHT + 6;

    /** Pixels per metre at which the room with its walls is as wide as the plate. */
    private static final double SCALE = WIDTH / (2 * (Room.REACH + Room.WALL));

    /** px. */
    static final double HEIGHT = ROOM_TOP + SCALE * (Room.HEIGHT + 2 * Room.WALL);

    private static final double SWITCH_WIDTH = 132;
    private static final double SWITCH_HEIGHT = 30;

    /** Before the name on the switch and after its last dot, and between name and dots, px. */
    private static final double INSET = 14;

    private static final double BESIDE = 9;

    /** Between two dots, as far as the name leaves room, px. */
    private static final double DOTS = 14;

    private static final double PADDING = 8;
    private static final double SIZE = 16;

    private final Half half;
    private final Words words;
    private final double x;
    private final double y;
    private final Camera camera;
    private boolean isHot;

    /** A view with its upper left corner at (x, y), px. */
    HalfView(Half half, Words words, double x, double y) {
        this.half = half;
        this.words = words;
        this.x = x;
        this.y = y;
        double middleX = x + WIDTH / 2;
        double floorY = y + HEIGHT - SCALE * Room.WALL;
        Camera plain = new Camera(0, 0, SCALE);
        camera = new Camera(-plain.worldX(middleX), -plain.worldY(floorY), SCALE);
    }

    void draw(Canvas canvas, List<Skin> skins) {
        drawRoom(canvas, skins);
        canvas.panel(x, y, WIDTH, PLATE_HEIGHT, 12, Color.PANEL);
        drawSwitch(canvas);
        double upper = y + PADDING + SWITCH_HEIGHT / 2;
        double lower = y + PLATE_HEIGHT - 15;
        double right = x + WIDTH - PADDING - 4;
        number(canvas, words.of("laboratory.step", millis(canvas.layout())), right, upper);
        words(
                canvas,
                words.of("fold.energy"),
                x + PADDING + 4,
                lower,
                Canvas.Align.LEFT,
                Color.TEXT_DIM);
        number(canvas, energy(canvas.layout()), right, lower);
    }

    private void drawRoom(Canvas canvas, List<Skin> skins) {
        canvas.camera(camera);
        int i = 0;
        for (RigidBody body : half.pool().bodies()) {
            Skin skin = skins.get(i++);
            canvas.gaze(0, Room.HEIGHT);
            canvas.body(body.shape(), body.x(), body.y(), body.angle(), skin, Canvas.Mood.PLAIN);
        }
    }

    /** The accuracy's name over four dots, of which the one in its place is lit. */
    private void drawSwitch(Canvas canvas) {
        double left = x + PADDING;
        double top = y + PADDING;
        Color plate = isHot ? Color.BRASS.alpha(0.8) : Color.BRASS;
        canvas.panel(left, top, SWITCH_WIDTH, SWITCH_HEIGHT, SWITCH_HEIGHT / 2, plate);
        double middle = top + SWITCH_HEIGHT / 2;
        words(canvas, name(), left + INSET, middle, Canvas.Align.LEFT, Color.DUSK_TOP);
        double end = left + INSET + canvas.textWidth(name(), SIZE, Canvas.Font.WORDS);
        double last = left + SWITCH_WIDTH - INSET;
        int between = Preset.values().length - 1;
        double pitch = Math.min(DOTS, (last - end - BESIDE) / between);
        for (Preset preset : Preset.values()) {
            boolean isLit = preset == half.preset() && !half.isOwn();
            double dot = last - pitch * (between - preset.ordinal());
            Color color = isLit ? Color.DUSK_TOP : Color.DUSK_TOP.alpha(0.3);
            canvas.disc(dot, middle, isLit ? 5 : 4, color);
        }
    }

    /** Name of its accuracy. */
    String name() {
        return half.isOwn() ? words.of("laboratory.own") : half.preset().name();
    }

    private String millis(Layout layout) {
        String digits = layout.type() > 1.2 ? "%.2f ms" : "%.3f ms";
        return words.number(digits, half.medianMillis());
    }

    /** With as many digits as there is room for beside its name. */
    private String energy(Layout layout) {
        String digits = layout.type() > 1.2 ? "%.2f %%" : layout.type() > 1 ? "%.4f %%" : "%.7f %%";
        double percent = 100 * half.energyShare();
        return words.of("laboratory.share", words.number(digits, percent));
    }

    private static void words(
            Canvas canvas, String words, double x, double y, Canvas.Align align, Color color) {
        canvas.text(words, x, y, SIZE, Canvas.Font.WORDS, align, color);
    }

    private static void number(Canvas canvas, String words, double x, double y) {
        canvas.text(words, x, y, SIZE, Canvas.Font.NUMBERS, Canvas.Align.RIGHT, Color.TEXT);
    }

    void pointerMoved(double px, double py) {
        isHot =
                px >= x + PADDING
                        && px <= x + PADDING + SWITCH_WIDTH
                        && py >= y + PADDING
                        && py <= y + PADDING + SWITCH_HEIGHT;
    }

    /** Handles a press of the pointer, which turns the switch if it is on it. */
    void pointerPressed(double px, double py) {
        pointerMoved(px, py);
        if (isHot) {
            half.choose(half.preset().next());
        }
    }
}
