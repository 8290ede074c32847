package rigibo.frontend.scene.joint;

import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** Draws the parts that joints are made of, over the bodies: world m and rad. */
public final class JointPen {

    private static final Color SHADE = Color.of(0x23190F);
    private static final Color STEEL = Color.of(0x98A3B5);
    private static final Color STEEL_DARK = Color.of(0x4A5263);
    private static final Color STEEL_GLINT = Color.of(0xDCE3EE);
    private static final Color BRASS_DARK = Color.of(0x8C6426);
    private static final Color BRASS_GLINT = Color.of(0xFFF0C4);
    private static final Color ROPE = Color.of(0xD6B27A);
    private static final Color ROPE_DARK = Color.of(0x7C5A33);

    /** Widths of rods, ropes and wires, m, and their least width, px. */
    private static final double ROD = 0.07;

    private static final double CORD = 0.055;
    private static final double WIRE = 0.028;
    private static final double LEAST_PX = 1.6;

    /** A pin whose radius is less shows no slot and no glint, px. */
    private static final double PLAIN_PIN = 3;

    /** A rope with more strands than these shows none: each is a stroke of its own. */
    private static final int MOST_STRANDS = 90;

    private final Canvas canvas;
    private final Camera camera;
    private final Strand strand = new Strand();

    /** A pen on a canvas, through a camera. */
    public JointPen(Canvas canvas, Camera camera) {
        this.canvas = canvas;
        this.camera = camera;
    }

    private double px(double metres) {
        return Math.max(LEAST_PX, metres * camera.scale());
    }

    private void line(double x1, double y1, double x2, double y2, double width, Color color) {
        canvas.line(camera, x1, y1, x2, y2, width, color);
    }

    private void disc(double x, double y, double radius, Color color) {
        canvas.disc(camera.screenX(x), camera.screenY(y), radius, color);
    }

    /** A steel rod between two points. */
    public void rod(double x1, double y1, double x2, double y2) {
        double width = px(ROD);
        line(x1, y1, x2, y2, width + 2, SHADE);
        line(x1, y1, x2, y2, width, STEEL);
        double aside = -0.22 * ROD;
        double length = Math.hypot(x2 - x1, y2 - y1);
        if (width > PLAIN_PIN && length > 0) {
            // The lamp hangs above: the glint is on the upper side.
            double nx = -(y2 - y1) / length;
            double ny = (x2 - x1) / length;
            double up = Math.copySign(aside, -ny);
            line(x1 + up * nx, y1 + up * ny, x2 + up * nx, y2 + up * ny, 0.25 * width, STEEL_GLINT);
        }
    }

    /** A rope of a length; where its ends are nearer it hangs through. */
    public void rope(double x1, double y1, double x2, double y2, double length) {
        strand.hang(x1, y1, x2, y2, length);
        rope();
    }

    /** A rope along points x₀, y₀, x₁, y₁, …, world m. */
    public void cord(double[] xy, int points) {
        strand.along(xy, points);
        rope();
    }

    private void rope() {
        double width = px(CORD);
        curve(strand, width + 2, SHADE);
        curve(strand, width, ROPE);
        double apart = 1.3 * width / camera.scale();
        int strands = (int) (strand.length() / apart);
        if (width <= PLAIN_PIN || strands > MOST_STRANDS) {
            return;
        }
        for (int i = 1; i < strands; i++) {
            strand.at(i * apart);
            double along = 0.32 * CORD;
            double across = 0.42 * CORD;
            line(
                    strand.x - along * strand.dx - across * strand.dy,
                    strand.y - along * strand.dy + across * strand.dx,
                    strand.x + along * strand.dx + across * strand.dy,
                    strand.y + along * strand.dy - across * strand.dx,
                    0.22 * width,
                    ROPE_DARK);
        }
    }

    /** A coil spring whose length without load tells how many coils it has. */
    public void spring(double x1, double y1, double x2, double y2, double rest) {
        double width = px(WIRE);
        strand.coil(x1, y1, x2, y2, rest);
        curve(strand, width + 1.6, SHADE);
        curve(strand, width, STEEL_DARK);
        for (int turn = 0; turn < strand.turns(); turn++) {
            strand.front(turn);
            curve(strand, width + 1.6, SHADE);
            curve(strand, width, STEEL_GLINT);
        }
    }

    private void curve(Strand of, double width, Color color) {
        int points = of.points();
        double[] screen = new double[2 * points];
        for (int i = 0; i < points; i++) {
            screen[2 * i] = camera.screenX(of.x(i));
            screen[2 * i + 1] = camera.screenY(of.y(i));
        }
        canvas.curve(screen, points, width, color);
    }

    /** Draws a brass pin of the given radius, whose slot turns with the body it holds. */
    public void pin(double x, double y, double radius, double angle) {
        double size = px(radius);
        disc(x, y, size + 1.2, SHADE);
        disc(x, y, size, Color.BRASS);
        if (size > PLAIN_PIN) {
            disc(x - 0.05 * radius, y + 0.12 * radius, 0.62 * size, BRASS_GLINT.alpha(0.55));
            double dx = 0.62 * radius * Math.cos(angle);
            double dy = 0.62 * radius * Math.sin(angle);
            line(x - dx, y - dy, x + dx, y + dy, Math.max(1, 0.28 * size), BRASS_DARK);
        }
    }

    /**
     * Draws a motor as an arrow about a pin, in the direction in which it turns; a speed of 0 is a
     * brake.
     */
    public void motor(double x, double y, double radius, double angle, double speed) {
        motor(x, y, radius, angle, speed, Color.GOOD);
    }

    /** Draws a motor's arrow, radius in m of the world, in a colour. */
    public void motor(double x, double y, double radius, double angle, double speed, Color color) {
        double way = speed < 0 ? -1 : 1;
        strand.arc(x, y, radius, angle, way);
        double width = Math.max(LEAST_PX, 0.16 * radius * camera.scale());
        curve(strand, width + 1.4, SHADE);
        curve(strand, width, color);
        if (speed != 0) {
            strand.arrow(radius);
            curve(strand, width + 1.4, SHADE);
            curve(strand, width, color);
        }
    }

    /** Rigidly joined: an iron plate with a screw. */
    public void weld(double x, double y, double radius, double angle) {
        double size = px(radius);
        disc(x, y, size + 1.2, SHADE);
        disc(x, y, size, STEEL);
        for (int i = 0; i < 2 && size > PLAIN_PIN; i++) {
            double turned = angle + Math.PI / 4 + i * Math.PI / 2;
            double dx = 0.6 * radius * Math.cos(turned);
            double dy = 0.6 * radius * Math.sin(turned);
            line(x - dx, y - dy, x + dx, y + dy, Math.max(1, 0.26 * size), STEEL_DARK);
        }
    }

    /** A rail from one point to another, with a stop at each end. */
    public void rail(double x1, double y1, double x2, double y2) {
        double width = px(ROD);
        line(x1, y1, x2, y2, width + 2, SHADE);
        line(x1, y1, x2, y2, width, STEEL_DARK);
        line(x1, y1, x2, y2, 0.35 * width, STEEL);
        double length = Math.hypot(x2 - x1, y2 - y1);
        if (length > 0) {
            double nx = -1.6 * ROD * (y2 - y1) / length;
            double ny = 1.6 * ROD * (x2 - x1) / length;
            line(x1 - nx, y1 - ny, x1 + nx, y1 + ny, width, STEEL_DARK);
            line(x2 - nx, y2 - ny, x2 + nx, y2 + ny, width, STEEL_DARK);
        }
    }

    /** A pulley of a radius, turned by an angle. */
    public void pulley(double x, double y, double radius, double angle) {
        double size = px(radius);
        disc(x, y, size + 1.2, SHADE);
        disc(x, y, size, STEEL_DARK);
        disc(x, y, 0.78 * size, STEEL);
        for (int i = 0; i < 3; i++) {
            double turned = angle + i * Math.PI / 3;
            double dx = 0.7 * radius * Math.cos(turned);
            double dy = 0.7 * radius * Math.sin(turned);
            line(x - dx, y - dy, x + dx, y + dy, 0.16 * size, STEEL_DARK);
        }
        pin(x, y, 0.3 * radius, angle);
    }

    /** A hand that pulls a point towards another. */
    public void hand(double x1, double y1, double x2, double y2) {
        line(x1, y1, x2, y2, 2.5, Color.TEXT.alpha(0.65));
        disc(x1, y1, 4, Color.TEXT);
        disc(x2, y2, 5.5, Color.TEXT.alpha(0.8));
    }

    /** A belt's free part. */
    void belt(double x1, double y1, double x2, double y2) {
        line(x1, y1, x2, y2, px(CORD) + 1.6, SHADE);
        line(x1, y1, x2, y2, px(CORD), Color.IRON);
    }
}
