package rigibo.frontend.draw;

import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

import java.nio.FloatBuffer;

/** Small discs that belong to bodies: pupils and rivets. */
final class DotBatch {

    private static final double RIVET = 0.045;
    private static final double RIVET_INSET = 0.11;
    private static final double RIVET_IN_DISC = 0.25;

    /** Radius below which a rivet is a stray pixel and left out, px. */
    private static final double LEAST_RIVET = 1.5;

    private static final Color RIVET_SHADE = Color.of(0x1E232D);
    private static final Color RIVET_COLOR = Color.of(0x8A94A6);
    private static final Color RIVET_GLINT = Color.of(0xC4CCD8);

    private final Triangles triangles = PlateVertex.triangles();

    /** Adds a disc about a point of a body, m. */
    void add(OnScreen at, double localX, double localY, double radius, Color color) {
        double scale = at.scale();
        // Draws one pixel more than the disc, for its smooth edge.
        double drawn = radius + 1 / scale;
        double reach = radius * scale;
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            double dx = Triangles.SQUARE[i] * drawn;
            double dy = Triangles.SQUARE[i + 1] * drawn;
            FloatBuffer to = at.vertex(triangles, localX + dx, localY + dy);
            PlateVertex.put(to, dx * scale, dy * scale, reach, reach, reach, color);
        }
    }

    /** Rivets in the corners of a plate, or one in the middle of a disc. */
    void rivets(Figure figure, OnScreen at) {
        if (figure.isDisc) {
            rivet(at, 0, 0, RIVET_IN_DISC * figure.halfWidth);
            return;
        }
        double dx = figure.halfWidth - RIVET_INSET;
        double dy = figure.halfHeight - RIVET_INSET;
        if (figure.isBox && dx > 0 && dy > 0) {
            for (int i = 0; i < 4; i++) {
                rivet(at, i % 2 == 0 ? dx : -dx, i < 2 ? dy : -dy, RIVET);
            }
        }
    }

    /** A head with a shadow below and the lamp's glint above. */
    private void rivet(OnScreen at, double localX, double localY, double radius) {
        if (radius * at.scale() < LEAST_RIVET) {
            return;
        }
        double upX = at.alongX(0, 1);
        double upY = at.alongY(0, 1);
        double aside = 0.3 * radius;
        add(at, localX - upX * aside, localY - upY * aside, 1.15 * radius, RIVET_SHADE);
        add(at, localX, localY, radius, RIVET_COLOR);
        add(at, localX + upX * aside, localY + upY * aside, 0.5 * radius, RIVET_GLINT);
    }

    void draw(Program program, Layout layout) {
        triangles.draw(program, layout);
    }

    void free() {
        triangles.free();
    }
}
