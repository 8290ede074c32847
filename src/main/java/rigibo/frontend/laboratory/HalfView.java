package rigibo.frontend.laboratory;

import rigibo.backend.RigidBody;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.widget.Plate;

import java.util.List;

/** Draws a half: a plate with its switch and readouts, and the room below. */
final class HalfView {

    /** Width of plate and room in a desktop window, px. */
    static final double WIDTH = 348;

    static final double PLATE_HEIGHT = 68;

    /** Between plate and room, px. */
    private static final double GAP = 6;

    /** Height in a desktop window, px. */
    static final double HEIGHT = height(Layout.ALONE, WIDTH);

    private static final double SWITCH_WIDTH = 132;
    private static final double SWITCH_HEIGHT = 30;

    /** Before the name on the switch and after its last dot, and between name and dots, px. */
    private static final double INSET = 14;

    private static final double BESIDE = 9;

    /** Between two dots, as far as the name leaves room, px. */
    private static final double DOTS = 14;

    private static final double PADDING = 8;
    private static final double SIZE = 16;

    /** A line of words in a handheld window, px. */
    private static final double LINE = 22;

    private final Half half;
    private final Words words;

    /** Where plate and room are as they were last drawn. */
    private Plate place = Plate.NONE;

    private Plate turned = Plate.NONE;
    private boolean isHot;

    HalfView(Half half, Words words) {
        this.half = half;
        this.words = words;
    }

    /** Median of what a step of the half takes, ms; 0 before the first. */
    double medianMillis() {
        return half.medianMillis();
    }

    /** Height of the plate, px: in a handheld window the readouts are below the switch. */
    private static double plateHeight(Layout layout) {
        return layout.isInHand() ? 2 * PADDING + layout.clickable(0) + 2 * LINE : PLATE_HEIGHT;
    }

    /** Height at which the room is so wide, px. */
    static double height(Layout layout, double width) {
        double scale = width / (2 * (Room.REACH + Room.WALL));
        return plateHeight(layout) + GAP + scale * (Room.HEIGHT + 2 * Room.WALL);
    }

    /** Width at which the room is so high that all of it is, px. */
    static double width(Layout layout, double height) {
        double scale = (height - plateHeight(layout) - GAP) / (Room.HEIGHT + 2 * Room.WALL);
        return scale * 2 * (Room.REACH + Room.WALL);
    }

    /** Draws it at a place, px, with the room as large as fits below the plate. */
    void draw(Canvas canvas, Plate at, List<Skin> skins) {
        place = at;
        Layout layout = canvas.layout();
        double plate = plateHeight(layout);
        drawRoom(canvas, at.y() + plate + GAP, skins);
        canvas.panel(at.x(), at.y(), at.width(), plate, 12, Color.PANEL);
        double width = layout.isInHand() ? at.width() - 2 * PADDING : SWITCH_WIDTH;
        double height = layout.clickable(SWITCH_HEIGHT);
        turned = new Plate(at.x() + PADDING, at.y() + PADDING, width, height);
        drawSwitch(canvas);
        double lower = at.y() + plate - 15;
        double upper = layout.isInHand() ? lower - LINE : at.y() + PADDING + SWITCH_HEIGHT / 2;
        double right = at.right() - PADDING - 4;
        number(canvas, words.of("laboratory.step", millis(layout)), right, upper);
        double left = at.x() + PADDING + 4;
        words(canvas, words.of("fold.energy"), left, lower, Color.TEXT_DIM);
        number(canvas, energy(layout), right, lower);
    }

    private void drawRoom(Canvas canvas, double top, List<Skin> skins) {
        double across = place.width() / (2 * (Room.REACH + Room.WALL));
        double down = (place.bottom() - top) / (Room.HEIGHT + 2 * Room.WALL);
        double scale = Math.min(across, down);
        double middleX = place.x() + place.width() / 2;
        double floorY = place.bottom() - scale * Room.WALL;
        Camera plain = new Camera(0, 0, scale);
        canvas.camera(new Camera(-plain.worldX(middleX), -plain.worldY(floorY), scale));
        int i = 0;
        for (RigidBody body : half.pool().bodies()) {
            Skin skin = skins.get(i++);
            canvas.gaze(0, Room.HEIGHT);
            canvas.body(body.shape(), body.x(), body.y(), body.angle(), skin, Canvas.Mood.PLAIN);
        }
    }

    /** The accuracy's name over four dots, of which the one in its place is lit. */
    private void drawSwitch(Canvas canvas) {
        double left = turned.x();
        double corner = turned.height() / 2;
        Color plate = isHot ? Color.BRASS.alpha(0.8) : Color.BRASS;
        canvas.panel(left, turned.y(), turned.width(), turned.height(), corner, plate);
        double middle = turned.y() + turned.height() / 2;
        words(canvas, name(), left + INSET, middle, Color.DUSK_TOP);
        double end = left + INSET + canvas.textWidth(name(), SIZE, Canvas.Font.WORDS);
        double last = turned.right() - INSET;
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
        double percent = 100 * half.energyShare();
        if (layout.isInHand()) {
            return words.number("%.1f %%", percent);
        }
        String digits = layout.type() > 1.2 ? "%.2f %%" : layout.type() > 1 ? "%.4f %%" : "%.7f %%";
        return words.of("laboratory.share", words.number(digits, percent));
    }

    private static void words(Canvas canvas, String words, double x, double y, Color color) {
        canvas.text(words, x, y, SIZE, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
    }

    private static void number(Canvas canvas, String words, double x, double y) {
        canvas.text(words, x, y, SIZE, Canvas.Font.NUMBERS, Canvas.Align.RIGHT, Color.TEXT);
    }

    /** Tells of its switch. */
    void describe(Narrator narrator, String which) {
        narrator.offers(turned.button(words.of(which, name()), false));
    }

    void pointerMoved(double px, double py) {
        isHot = turned.contains(px, py);
    }

    /** Handles a press of the pointer, which turns the switch if it is on it. */
    void pointerPressed(double px, double py) {
        pointerMoved(px, py);
        if (isHot) {
            half.choose(half.preset().next());
        }
    }
}
