package rigibo.frontend.draw;

import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

import java.nio.FloatBuffer;

/** Particles such as splinters, dust and glows, drawn by one call with an instance each. */
final class ParticleBatch {

    /** The kinds of particles, in the shader's order. */
    enum Kind {
        /** A square that turns. */
        SPLINTER,
        /** Fades towards its edge. */
        PUFF,
        /** Adds its light to the picture. */
        GLOW
    }

    private static final int CORNERS = 4;

    private final Program program = new Program("particle", "particle");

    /** Place and half extents, cosine and sine, colour, kind. */
    private final Instances instances = new Instances(CORNERS, 4, 2, 4, 1);

    /** Adds a particle at a position on the screen, px and rad. */
    void add(Kind kind, double x, double y, double halfSize, double angle, Color color) {
        FloatBuffer to = instances.next();
        to.put((float) x).put((float) y).put((float) halfSize).put((float) halfSize);
        to.put((float) Math.cos(angle)).put((float) Math.sin(angle));
        to.put(color.red()).put(color.green()).put(color.blue()).put(color.alpha());
        to.put(kind.ordinal());
    }

    void draw(Layout layout) {
        instances.draw(program, layout);
    }

    void free() {
        program.free();
        instances.free();
    }
}
