package rigibo.frontend.draw;

import rigibo.backend.geometry.Polygon;
import rigibo.frontend.scene.Canvas.Mood;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Skin;

import java.nio.FloatBuffer;

/**
 * Bodies, drawn by one call. A disc is a square whose shader cuts out the circle; a box is two
 * triangles; any other polygon is a fan about its centre. The corners carry the distance to the
 * outline, so that edges are smooth without multisampling.
 */
final class SkinBatch {

    /**
     * Size of a skin's texture, m, after which it repeats; the shader that bakes it uses the same
     * number.
     */
    private static final double TILE = 4;

    /** Direction towards the lamp, in the world. */
    private static final double LIGHT_X = -0.45;

    private static final double LIGHT_Y = 0.89;

    /**
     * Stands for the reach upwards if the body reaches equally far all round, flat or as a dome.
     */
    private static final double ROUND = -1;

    private static final double DOME = -2;

    /** Largest share of a side by which corners are drawn rounded. */
    private static final double MOST_ROUNDED = 0.3;

    /** Position, texture, way from the centre (px), how far it reaches there, light, kind. */
    private final Triangles triangles = new Triangles(2, 2, 2, 2, 2, 3);

    private OnScreen at = new OnScreen();
    private float skin;
    private float mood;
    private float corner;
    private double lightX;
    private double lightY;
    private boolean isUpright;
    private double textureScale;
    private double textureOffset;

    void add(Figure figure, OnScreen place, Skin of, Mood in) {
        at = place;
        skin = of.ordinal();
        mood = in.ordinal();
        double most = MOST_ROUNDED * figure.halfSize() * at.scale();
        corner = (float) Math.min(most, rounding(of) * at.scale());
        lightX = at.alongX(LIGHT_X, LIGHT_Y);
        lightY = at.alongY(LIGHT_X, LIGHT_Y);
        // Fits a ball's stripes to the ball; all other textures are cut from an endless sheet.
        boolean isBall = of == Skin.BALL;
        double reach = Math.max(figure.halfWidth, figure.halfHeight);
        textureScale = isBall ? 0.5 / reach : 1 / TILE;
        textureOffset = isBall ? 0.5 : 0;
        isUpright = of == Skin.WOOD && figure.halfHeight > figure.halfWidth;
        double scale = at.scale();
        if (figure.isDisc) {
            // Draws one pixel more than the disc, for its smooth edge.
            double drawn = figure.halfWidth + 1 / scale;
            square(drawn, drawn, figure.halfWidth * scale, DOME);
        } else if (figure.isBox) {
            double halfWidth = figure.halfWidth;
            double halfHeight = figure.halfHeight;
            square(halfWidth, halfHeight, halfWidth * scale, halfHeight * scale);
        } else {
            fan(figure.polygon);
        }
    }

    /** Radius of the corners that a box is drawn with, m. */
    private static double rounding(Skin of) {
        return switch (of) {
            case RIGIBO -> 0.075;
            case RUBBER, GOAL -> 0.06;
            case ICE, IRON, EMBER -> 0.03;
            case STONE, WOOD, BALL -> 0.02;
        };
    }

    void draw(Program program, Layout layout) {
        triangles.draw(program, layout);
    }

    void free() {
        triangles.free();
    }

    private void square(double halfWidth, double halfHeight, double reachX, double reachY) {
        double scale = at.scale();
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            double localX = Triangles.SQUARE[i] * halfWidth;
            double localY = Triangles.SQUARE[i + 1] * halfHeight;
            vertex(localX, localY, localX * scale, localY * scale, reachX, reachY);
        }
    }

    /**
     * Along the spokes of the fan, the distance to the outline is the rest of the longest distance.
     */
    private void fan(Polygon polygon) {
        double scale = at.scale();
        double reach = polygon.boundingRadius() * scale;
        double fromX = lightX;
        double fromY = lightY;
        for (int i = 0; i < polygon.corners(); i++) {
            int next = (i + 1) % polygon.corners();
            double normalX = polygon.normalX(i);
            double normalY = polygon.normalY(i);
            double inward = normalX * polygon.cornerX(i) + normalY * polygon.cornerY(i);
            // The way counts along the side's normal, and so does the light.
            lightX = normalX * fromX + normalY * fromY;
            lightY = 0;
            vertex(0, 0, reach - inward * scale, 0, reach, ROUND);
            vertex(polygon.cornerX(i), polygon.cornerY(i), reach, 0, reach, ROUND);
            vertex(polygon.cornerX(next), polygon.cornerY(next), reach, 0, reach, ROUND);
        }
    }

    private void vertex(
            double localX, double localY, double wayX, double wayY, double reachX, double reachY) {
        double u = textureOffset + textureScale * (isUpright ? localY : localX);
        double v = textureOffset + textureScale * (isUpright ? localX : localY);
        FloatBuffer to = at.vertex(triangles, localX, localY);
        to.put((float) u).put((float) v).put((float) wayX).put((float) wayY);
        to.put((float) reachX).put((float) reachY).put((float) lightX).put((float) lightY);
        to.put(skin).put(mood).put(corner);
    }
}
