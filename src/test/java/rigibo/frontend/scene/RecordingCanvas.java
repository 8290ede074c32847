package rigibo.frontend.scene;

import rigibo.backend.geometry.Shape;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;

/** Keeps what a scene draws, so that a test can tell whether it can be read. */
public final class RecordingCanvas implements Canvas {

    /** Below this opacity a panel lets what is under it shine through. */
    private static final double COVERING = 0.95;

    /** Below this opacity a panel hardly dims what is under it. */
    private static final double DIMMING = 0.5;

    /** The colours of plates that can be pressed. */
    private static final Set<Color> LIT = Set.of(Color.PANEL_LIT, Color.BRASS);

    /** Distance from a middle up to which a point counts as on it, px. */
    private static final double MIDDLE = 1;

    /** A panel, or a text as wide as it is drawn and as high as its size, in logical pixels. */
    record Mark(String words, Typeface face, double left, double top, double right, double bottom) {

        boolean isText() {
            return face != null;
        }

        boolean overlaps(Mark other) {
            return left < other.right
                    && other.left < right
                    && top < other.bottom
                    && other.top < bottom;
        }

        boolean contains(Mark other) {
            return left <= other.left
                    && other.right <= right
                    && top <= other.top
                    && other.bottom <= bottom;
        }

        boolean containsMiddleOf(Mark other) {
            double x = (other.left + other.right) / 2;
            double y = (other.top + other.bottom) / 2;
            return left <= x && x <= right && top <= y && y <= bottom;
        }

        double shorterSide() {
            return Math.min(right - left, bottom - top);
        }

        @Override
        public String toString() {
            String what = isText() ? "\"" + words + "\"" : "panel";
            return String.format("%s (%.0f to %.0f, %.0f to %.0f)", what, left, right, top, bottom);
        }
    }

    /** A line on the screen, logical pixels. */
    public record Line(double x1, double y1, double x2, double y2, Color color) {}

    /** A line through points x₀, y₀, x₁, y₁, … of the screen, logical pixels. */
    public record Curve(double[] xy) {}

    /** Part of a ring on the screen, logical pixels. */
    public record Ring(double x, double y, double radius, double fraction, Color color) {}

    /** A panel with its colour. */
    private record Plate(Mark place, Color color) {

        boolean isAbout(Mark text) {
            double aside = place.left + place.right - text.left - text.right;
            return Math.abs(aside) < 2 * MIDDLE;
        }
    }

    private final List<Mark> marks = new ArrayList<>();
    private final List<Plate> plates = new ArrayList<>();
    private final List<Mark> frames = new ArrayList<>();
    private final List<Line> lines = new ArrayList<>();
    private final List<Curve> curves = new ArrayList<>();
    private final List<Ring> rings = new ArrayList<>();
    private final List<Mood> moods = new ArrayList<>();
    private final Layout layout;
    private Camera camera = Camera.ofPuzzle();
    private final List<double[]> bodies = new ArrayList<>();
    private final List<Color> particles = new ArrayList<>();
    private int puffs;
    private int glows;
    private final List<Scenery> sceneries = new ArrayList<>();
    private double veil;

    /** A canvas as large as a scene. */
    public RecordingCanvas() {
        this(Layout.ALONE);
    }

    private RecordingCanvas(Layout layout) {
        this.layout = layout;
    }

    /** Records what a scene draws now. */
    public static RecordingCanvas of(Scene scene) {
        return of(scene, Layout.ALONE);
    }

    /** Records what a scene draws now in a window of another shape or size. */
    public static RecordingCanvas of(Scene scene, Layout layout) {
        RecordingCanvas canvas = new RecordingCanvas(layout);
        scene.draw(canvas);
        return canvas;
    }

    /** Panels and texts in the order they were drawn; texts that a panel covers are left out. */
    List<Mark> marks() {
        return marks;
    }

    /** Every text that can be seen, in the order they were drawn. */
    public List<String> texts() {
        List<String> texts = new ArrayList<>();
        for (Mark mark : marks) {
            if (mark.isText()) {
                texts.add(mark.words());
            }
        }
        return texts;
    }

    /** The middle of a text, of the last that was drawn of several, logical pixels: x, y. */
    public double[] middleOf(String words) {
        Mark text =
                marks.stream()
                        .filter(mark -> mark.words().equals(words))
                        .reduce((first, last) -> last)
                        .orElseThrow();
        return new double[] {(text.left + text.right) / 2, (text.top + text.bottom) / 2};
    }

    /** The middle of a text, of the first that was drawn of several, logical pixels: x, y. */
    public double[] firstMiddleOf(String words) {
        Mark text =
                marks.stream().filter(mark -> mark.words().equals(words)).findFirst().orElseThrow();
        return new double[] {(text.left + text.right) / 2, (text.top + text.bottom) / 2};
    }

    /** The colour of the uppermost panel under the middle of a text. */
    public Color plateOf(String words) {
        double[] at = middleOf(words);
        return plateAt(at[0], at[1]);
    }

    /** The colour of the uppermost panel at a point, logical pixels. */
    public Color plateAt(double x, double y) {
        Mark middle = point(new double[] {x, y});
        return plates.stream()
                .filter(plate -> plate.place.contains(middle))
                .reduce((below, above) -> above)
                .orElseThrow()
                .color;
    }

    /** The lit plates that have words in their middle. */
    List<Mark> buttons() {
        List<Mark> buttons = new ArrayList<>();
        for (Mark mark : marks) {
            if (mark.isText()) {
                plates.stream()
                        .filter(plate -> plate.place.containsMiddleOf(mark))
                        .reduce((below, above) -> above)
                        .filter(plate -> LIT.contains(plate.color) && plate.isAbout(mark))
                        .ifPresent(plate -> buttons.add(plate.place));
            }
        }
        return buttons;
    }

    /** How many frames there are round a text. */
    public long framesRound(String words) {
        Mark middle = point(middleOf(words));
        return frames.stream().filter(frame -> frame.contains(middle)).count();
    }

    private static Mark point(double[] at) {
        return new Mark("", null, at[0], at[1], at[0], at[1]);
    }

    /** Where the bodies of a frame have their middles, logical pixels: x, y. */
    public List<double[]> bodies() {
        return bodies;
    }

    /** How the bodies of a frame look, in the order of {@link #bodies()}. */
    public List<Mood> moods() {
        return moods;
    }

    /** The colours of the small squares of a frame. */
    public List<Color> particles() {
        return particles;
    }

    /** The lines of a frame. */
    public List<Line> lines() {
        return lines;
    }

    /** The curves of a frame. */
    public List<Curve> curves() {
        return curves;
    }

    /** The rings of a frame. */
    public List<Ring> rings() {
        return rings;
    }

    /** How many puffs there are in a frame. */
    public int puffs() {
        return puffs;
    }

    /** How many glows there are in a frame. */
    public int glows() {
        return glows;
    }

    /** How grey the world is, 0 to 1. */
    public double veil() {
        return veil;
    }

    /** Whether a point of the screen lies under a panel; water is none, one sees through it. */
    public boolean isUnderPanel(double x, double y) {
        Mark point = point(new double[] {x, y});
        return plates.stream()
                .anyMatch(plate -> plate.color.alpha() >= DIMMING && plate.place.contains(point));
    }

    @Override
    public Layout layout() {
        return layout;
    }

    @Override
    public void scenery(Scenery behind, double x, double y, double width, double height) {
        sceneries.add(behind);
    }

    /** The sceneries of parts of the window. */
    public List<Scenery> sceneries() {
        return sceneries;
    }

    @Override
    public void camera(Camera lens) {
        camera = lens;
    }

    @Override
    public void gaze(double worldX, double worldY) {}

    @Override
    public void body(Shape shape, double x, double y, double angle, Skin skin, Mood mood) {
        bodies.add(new double[] {camera.screenX(x), camera.screenY(y)});
        moods.add(mood);
    }

    @Override
    public void particle(double x, double y, double size, double angle, Color color) {
        particles.add(color);
    }

    @Override
    public void puff(double x, double y, double size, Color color) {
        puffs++;
    }

    @Override
    public void glow(double x, double y, double size, Color color) {
        glows++;
    }

    @Override
    public void veil(double share) {
        veil = share;
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, Color color) {
        lines.add(new Line(x1, y1, x2, y2, color));
    }

    @Override
    public void curve(double[] xy, int points, double width, Color color) {
        curves.add(new Curve(Arrays.copyOf(xy, 2 * points)));
    }

    @Override
    public void disc(double x, double y, double radius, Color color) {}

    @Override
    public void ring(
            double x, double y, double radius, double width, double fraction, Color color) {
        rings.add(new Ring(x, y, radius, fraction, color));
    }

    @Override
    public void panel(double x, double y, double width, double height, double corner, Color color) {
        Mark panel = new Mark("", null, x, y, x + width, y + height);
        if (color.alpha() >= COVERING) {
            marks.removeIf(mark -> mark.isText() && panel.contains(mark));
        }
        marks.add(panel);
        plates.add(new Plate(panel, color));
    }

    @Override
    public void frame(double x, double y, double width, double height, double corner, Color color) {
        frames.add(new Mark("", null, x, y, x + width, y + height));
    }

    @Override
    public void text(
            String words, double x, double y, double size, Font font, Align align, Color color) {
        double width = textWidth(words, size, font);
        double left =
                switch (align) {
                    case LEFT -> x;
                    case CENTRE -> x - width / 2;
                    case RIGHT -> x - width;
                };
        if (!words.isBlank()) {
            double half = layout.textSize(size) / 2;
            marks.add(new Mark(words, face(font), left, y - half, left + width, y + half));
        }
    }

    @Override
    public double textWidth(String words, double size, Font font) {
        return face(font).width(words, layout.textSize(size));
    }

    private static Typeface face(Font font) {
        return font == Font.WORDS ? Typeface.WORDS : Typeface.NUMBERS;
    }

    @Override
    public void graph(
            double[] values, int count, double x, double y, double w, double h, Color color) {}
}
