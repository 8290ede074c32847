package rigibo.frontend.draw;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas.Mood;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Skin;

import java.nio.FloatBuffer;

/**
 * All bodies, faces and particles of a frame, drawn by three calls. A disc is a square whose shader
 * cuts the circle; a box is its own two triangles; any other polygon is a fan about its centre,
 * whose corners carry the distance to the outline. So edges are smooth without multisampling.
 */
final class BodyBatch {

    /** A skin's texture covers so many metres, again and again; the shader that bakes it agrees. */
    private static final double TILE = 4;

    private static final int TEXELS = 512;

    /** What shows half as much of a face does not show it, px. */
    private static final double LEAST_FACE = 5;

    /** A face is as large as the body, but no larger than this, m. */
    private static final double MOST_FACE = 0.5;

    private static final double RIVET = 0.05;
    private static final double RIVET_INSET = 0.11;
    private static final Color RIVET_COLOR = Color.of(0x9EA8B8);

    /** In place of the reach upwards: the body reaches equally far all round. */
    private static final double ROUND = -1;

    private final Program bodyProgram = new Program("body", "body");
    private final Program faceProgram = new Program("face", "face");
    private final Program dotProgram = new Program("plate", "plate");
    private final Baked skins = new Baked("skin", TEXELS, TEXELS, Skin.values().length);

    /** Position, texture, way from the centre (px), how far it reaches there, skin and mood. */
    private final Triangles bodies = new Triangles(2, 2, 2, 2, 2);

    /** Position, place on the face, px of its unit, where it looks, mood and number. */
    private final Triangles faces = new Triangles(2, 2, 1, 2, 2);

    /** Rivets and particles: plates that turn with the world. */
    private final Triangles dots = Plates.triangles();

    /** Of the body that is drawn, about its centre. */
    private final Aabb bounds = new Aabb();

    private Camera camera = Camera.ofPuzzle();
    private double gazeX;
    private double gazeY;
    private float skin;
    private float mood;
    private boolean isUpright;
    private double textureScale;
    private double textureOffset;
    private double x;
    private double y;
    private double cos;
    private double sin;

    void camera(Camera from) {
        camera = from;
    }

    void gaze(double worldX, double worldY) {
        gazeX = worldX;
        gazeY = worldY;
    }

    void body(Shape shape, double atX, double atY, double angle, Skin of, Mood in) {
        place(atX, atY, angle);
        skin = of.ordinal();
        mood = in.ordinal();
        shape.bounds(0, 0, 1, 0, bounds);
        double halfWidth = Math.max(bounds.maxX, -bounds.minX);
        double halfHeight = Math.max(bounds.maxY, -bounds.minY);
        // A ball's stripes fit the ball; everything else is cut from an endless sheet.
        textureScale = of == Skin.BALL ? 0.5 / Math.max(halfWidth, halfHeight) : 1 / TILE;
        textureOffset = of == Skin.BALL ? 0.5 : 0;
        isUpright = of == Skin.WOOD && halfHeight > halfWidth;
        if (shape instanceof Circle circle) {
            disc(circle.radius());
        } else if (isBox((Polygon) shape, halfWidth, halfHeight)) {
            box(halfWidth, halfHeight);
        } else {
            fan((Polygon) shape);
        }
        if (of == Skin.RIGIBO && in != Mood.GHOST) {
            face(Math.min(MOST_FACE, Math.min(halfWidth, halfHeight)), in);
        } else if (of == Skin.IRON && in != Mood.GHOST) {
            rivets(shape, halfWidth, halfHeight);
        }
    }

    /** A small square particle. */
    void particle(double atX, double atY, double size, double angle, Color color) {
        place(atX, atY, angle);
        dot(0, 0, size / 2, size / 2, 0, color);
    }

    /** Draws what was gathered, and empties the batch. */
    void draw(float pixelRatio, double seconds) {
        skins.bind();
        bodies.draw(bodyProgram, pixelRatio, seconds);
        faces.draw(faceProgram, pixelRatio, seconds);
        dots.draw(dotProgram, pixelRatio, seconds);
    }

    void free() {
        bodies.free();
        faces.free();
        dots.free();
        skins.free();
        bodyProgram.free();
        faceProgram.free();
        dotProgram.free();
    }

    private void place(double atX, double atY, double angle) {
        x = atX;
        y = atY;
        cos = Math.cos(angle);
        sin = Math.sin(angle);
    }

    private void disc(double radius) {
        // A pixel more than the disc, for its smooth edge.
        square(radius + 1 / camera.scale(), radius + 1 / camera.scale(), radius, ROUND);
    }

    private void box(double halfWidth, double halfHeight) {
        square(halfWidth, halfHeight, halfWidth, halfHeight);
    }

    private void square(double halfWidth, double halfHeight, double reachX, double reachY) {
        double scale = camera.scale();
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            double localX = Triangles.SQUARE[i] * halfWidth;
            double localY = Triangles.SQUARE[i + 1] * halfHeight;
            vertex(localX, localY, localX * scale, localY * scale, reachX * scale, reachY * scale);
        }
    }

    private static boolean isBox(Polygon polygon, double halfWidth, double halfHeight) {
        boolean isBox = polygon.corners() == 4;
        for (int i = 0; i < polygon.corners() && isBox; i++) {
            isBox =
                    Math.abs(polygon.cornerX(i)) == halfWidth
                            && Math.abs(polygon.cornerY(i)) == halfHeight;
        }
        return isBox;
    }

    /** Along the fan's spokes the way to the outline is what is left of the longest way. */
    private void fan(Polygon polygon) {
        double reach = polygon.boundingRadius() * camera.scale();
        for (int i = 0; i < polygon.corners(); i++) {
            int next = (i + 1) % polygon.corners();
            double inward =
                    polygon.normalX(i) * polygon.cornerX(i)
                            + polygon.normalY(i) * polygon.cornerY(i);
            vertex(0, 0, reach - inward * camera.scale(), 0, reach, ROUND);
            vertex(polygon.cornerX(i), polygon.cornerY(i), reach, 0, reach, ROUND);
            vertex(polygon.cornerX(next), polygon.cornerY(next), reach, 0, reach, ROUND);
        }
    }

    private void vertex(
            double localX, double localY, double wayX, double wayY, double reachX, double reachY) {
        double u = textureOffset + textureScale * (isUpright ? localY : localX);
        double v = textureOffset + textureScale * (isUpright ? localX : localY);
        FloatBuffer to = at(bodies, localX, localY);
        to.put((float) u).put((float) v).put((float) wayX).put((float) wayY);
        to.put((float) reachX).put((float) reachY).put(skin).put(mood);
    }

    /** Eyes and mouth, which look towards the gaze. */
    private void face(double unit, Mood in) {
        if (unit * camera.scale() < LEAST_FACE) {
            return;
        }
        double dx = gazeX - x;
        double dy = gazeY - y;
        double distance = Math.max(1e-9, Math.sqrt(dx * dx + dy * dy));
        float lookX = (float) ((cos * dx + sin * dy) / distance);
        float lookY = (float) ((cos * dy - sin * dx) / distance);
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            double faceX = 0.62 * Triangles.SQUARE[i];
            double faceY = 0.5 * Triangles.SQUARE[i + 1] - 0.06;
            FloatBuffer to = at(faces, faceX * unit, faceY * unit);
            to.put((float) faceX).put((float) faceY).put((float) (unit * camera.scale()));
            to.put(lookX).put(lookY).put(in.ordinal()).put((float) unit);
        }
    }

    /** Rivets in the corners of a plate, or one in the middle of a disc. */
    private void rivets(Shape shape, double halfWidth, double halfHeight) {
        if (shape instanceof Circle circle) {
            rivet(0, 0, 0.25 * circle.radius());
            return;
        }
        double dx = halfWidth - RIVET_INSET;
        double dy = halfHeight - RIVET_INSET;
        if (dx > 0 && dy > 0) {
            for (int i = 0; i < 4; i++) {
                rivet(i % 2 == 0 ? dx : -dx, i < 2 ? dy : -dy, RIVET);
            }
        }
    }

    private void rivet(double localX, double localY, double radius) {
        // A pixel more than the disc, for its smooth edge.
        double drawn = radius + 1 / camera.scale();
        dot(localX, localY, drawn, radius, radius, RIVET_COLOR);
    }

    /** A square that is drawn so far and cut to so much, with round corners, m. */
    private void dot(
            double localX, double localY, double drawn, double half, double corner, Color color) {
        double scale = camera.scale();
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            double dx = Triangles.SQUARE[i] * drawn;
            double dy = Triangles.SQUARE[i + 1] * drawn;
            FloatBuffer to = at(dots, localX + dx, localY + dy);
            Plates.put(
                    to, dx * scale, dy * scale, half * scale, half * scale, corner * scale, color);
        }
    }

    /** Begins a vertex: its place on the screen, px. */
    private FloatBuffer at(Triangles triangles, double localX, double localY) {
        double worldX = x + cos * localX - sin * localY;
        double worldY = y + sin * localX + cos * localY;
        return triangles
                .vertex()
                .put((float) camera.screenX(worldX))
                .put((float) camera.screenY(worldY));
    }
}
