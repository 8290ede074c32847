package rigibo.frontend.puzzle.show;

import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Magnet;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** Draws the effects of fans and magnets: streaks of air, and rings that close in on a magnet. */
final class Streams {

    /** Streaks side by side for each metre of a stream's width, and their length, m. */
    private static final double PER_METRE = 5;

    private static final double STREAK = 0.45;

    /** Speed of the air on the screen, m/s. */
    private static final double SPEED = 4;

    /** Distance between two streaks in a line, m. */
    private static final double PITCH = 1.3;

    /** By the golden ratio, neighbouring streaks are never at the same height. */
    private static final double GOLDEN = 0.618034;

    private static final double AIR = 0.5;

    private static final int RINGS = 3;
    private static final double PULSE = 0.4;

    /** Radius of the horseshoe on a magnet, and its stroke, px. */
    private static final double SHOE = 19;

    private static final double STROKE = 6;

    private Streams() {}

    static void draw(Canvas canvas, Camera camera, Piece piece, int steps) {
        piece.definition()
                .source()
                .jet()
                .ifPresent(jet -> air(canvas, camera, jet, piece.isOn(), steps));
        piece.definition()
                .source()
                .pole()
                .ifPresent(pole -> pull(canvas, camera, pole, piece.isOn(), steps));
    }

    private static void air(Canvas canvas, Camera camera, Fan.Jet jet, boolean isOn, int steps) {
        double ux = Math.cos(jet.angle());
        double uy = Math.sin(jet.angle());
        int count = Math.max(2, (int) Math.round(PER_METRE * jet.width()));
        for (int i = 0; i < count; i++) {
            double aside = ((i + 0.5) / count - 0.5) * jet.width();
            double x = jet.x() - aside * uy;
            double y = jet.y() + aside * ux;
            double begun = isOn ? SPEED * Steps.seconds(steps) : 0;
            double first = (begun + GOLDEN * i * PITCH) % PITCH;
            double last = isOn ? jet.reach() : PITCH;
            for (double way = first; way < last; way += PITCH) {
                double end = Math.min(jet.reach(), way + STREAK);
                double left = 1 - way / jet.reach();
                Color color = (isOn ? Color.ICE : Color.EDGE).alpha(AIR * left);
                double toX = x + end * ux;
                double toY = y + end * uy;
                canvas.line(camera, x + way * ux, y + way * uy, toX, toY, 2, color);
            }
        }
    }

    private static void pull(
            Canvas canvas, Camera camera, Magnet.Pole pole, boolean isOn, int steps) {
        double x = camera.screenX(pole.x());
        double y = camera.screenY(pole.y());
        for (int i = 0; i < RINGS && isOn; i++) {
            double share = 1 - (PULSE * Steps.seconds(steps) + i / (double) RINGS) % 1;
            double radius = share * pole.reach() * camera.scale();
            canvas.ring(x, y, radius, 2, 1, Color.BAD.alpha(0.45 * (1 - share)));
        }
        canvas.ring(x, y, pole.reach() * camera.scale(), 1, 1, Color.EDGE.alpha(0.5));
        shoe(canvas, x, y, isOn);
    }

    /** A horseshoe about a point, open below, with a red pole on the left and a blue one. */
    private static void shoe(Canvas canvas, double x, double y, boolean isOn) {
        for (int side = -1; side <= 1; side += 2) {
            double[] arm = new double[2 * 9];
            for (int i = 0; i < 9; i++) {
                double angle = Math.PI / 2 * i / 7.0;
                arm[2 * i] = x + side * SHOE * Math.sin(Math.min(angle, Math.PI / 2));
                arm[2 * i + 1] = i == 8 ? y + SHOE * 0.7 : y - SHOE * Math.cos(angle);
            }
            Color on = side < 0 ? Color.BAD : Color.ICE;
            canvas.curve(arm, 9, STROKE + 2, Color.NIGHT);
            canvas.curve(arm, 9, STROKE, isOn ? on : Color.STONE);
        }
    }
}
