package rigibo.frontend.display;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Skin;

import java.util.Arrays;

/**
 * Measures the time of drawing in a real window. Each frame shows rows of bodies of every skin,
 * boxes and discs alternating, a bar of words and numbers, and a graph. Nothing is simulated.
 */
public final class DrawingTiming {

    private static final int WARM_FRAMES = 120;
    private static final int TIMED_FRAMES = 300;

    private final int bodies;
    private final double pixels;
    private final double[] millis = new double[TIMED_FRAMES];

    private DrawingTiming(int bodies, double pixels) {
        this.bodies = bodies;
        this.pixels = pixels;
    }

    /**
     * Draws some hundred frames with a number of bodies of a given width, px, in a given detail.
     *
     * @return the time that half of the frames stayed below, and 99 % of them, ms
     * @throws DisplayException when no window can be opened
     */
    public static double[] millis(int bodies, double pixels, Settings.Detail detail) {
        DrawingTiming timing = new DrawingTiming(bodies, pixels);
        Display display = new Display(director -> timing.new Rows(director), false);
        display.settings(display.settings().withDetail(detail));
        display.run(null);
        Arrays.sort(timing.millis);
        return new double[] {
            timing.millis[TIMED_FRAMES / 2], timing.millis[TIMED_FRAMES * 99 / 100]
        };
    }

    /** The measured picture. */
    private final class Rows implements Scene {

        private final Director director;
        private final double pitch = 1.2 * pixels / Camera.DEFAULT_SCALE;
        private final int columns = (int) (WIDTH / (1.2 * pixels));
        private final Shape box = Polygon.box(pitch / 1.2, pitch / 1.2);
        private final Shape disc = new Circle(pitch / 2.4);
        private final double[] graph = new double[120];
        private int frame = -WARM_FRAMES;

        Rows(Director director) {
            this.director = director;
            Arrays.setAll(graph, i -> 0.5 + 0.4 * Math.sin(i / 9.0));
        }

        @Override
        public String title() {
            return bodies + " bodies";
        }

        @Override
        public void step() {}

        @Override
        public void draw(Canvas canvas) {
            canvas.camera(Camera.ofPuzzle());
            for (int i = 0; i < bodies; i++) {
                double x = (i % columns + 0.5) * pitch;
                double y = (i / columns + 0.5) * pitch;
                Skin skin = Skin.values()[i % Skin.values().length];
                canvas.body(i % 2 == 0 ? box : disc, x, y, 0.01 * i, skin, Canvas.Mood.PLAIN);
            }
            canvas.panel(8, 8, WIDTH - 16, 48, 14, Color.PANEL);
            canvas.text(title(), 26, 32, 20, Canvas.Font.WORDS, Canvas.Align.LEFT, Color.BRASS);
            canvas.text(
                    "2 clicks    3.4 s",
                    WIDTH - 70,
                    32,
                    18,
                    Canvas.Font.NUMBERS,
                    Canvas.Align.RIGHT,
                    Color.TEXT);
            canvas.ring(WIDTH - 38, 32, 13, 5, 0.7, Color.GOOD);
            canvas.graph(graph, graph.length, 250, 14, 200, 36, Color.GOOD);
        }

        @Override
        public void drawn(long nanos) {
            if (frame >= 0 && frame < TIMED_FRAMES) {
                millis[frame] = nanos / 1e6;
            }
            frame++;
            if (frame == TIMED_FRAMES) {
                director.quit();
            }
        }
    }
}
