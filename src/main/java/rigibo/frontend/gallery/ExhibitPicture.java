package rigibo.frontend.gallery;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.ChainBand;
import rigibo.frontend.scene.joint.JointPicture;

/** An exhibit at the size of a card; bodies that extend beyond the card are clipped at its edge. */
final class ExhibitPicture {

    /** Share of a view that the plates around a running exhibit leave free. */
    private static final double FREE = 0.8;

    /** Boldness of lines and points, as a share of that in a running exhibit. */
    private static final double FINE = 0.5;

    private final Camera camera;
    private final Aabb window = new Aabb();
    private final Aabb own = new Aabb();

    /** A picture of a view in a rectangle of the screen, px. */
    ExhibitPicture(View view, double x, double y, double width, double height) {
        double scale = height / (FREE * view.height());
        Camera plain = new Camera(0, 0, scale);
        double centreX = view.x() - plain.worldX(x + width / 2);
        double centreY = view.y() - plain.worldY(y + height / 2);
        camera = new Camera(centreX, centreY, scale);
        double halfWidth = width / 2 / scale;
        double halfHeight = height / 2 / scale;
        window.set(
                view.x() - halfWidth,
                view.y() - halfHeight,
                view.x() + halfWidth,
                view.y() + halfHeight);
    }

    void draw(Canvas canvas, Showing showing) {
        canvas.camera(camera);
        canvas.gaze((window.minX + window.maxX) / 2, (window.minY + window.maxY) / 2);
        for (RigidBody body : showing.pool().bodies()) {
            draw(canvas, body);
        }
        JointPicture.drawInside(canvas, camera, showing.pool().joints(), window);
        Sketch sketch = new PictureSketch(new CanvasSketch(canvas, camera, FINE), window);
        showing.exhibit().sketch(showing.pool(), sketch);
    }

    private void draw(Canvas canvas, RigidBody body) {
        Shape shape = body.shape();
        shape.bounds(body.x(), body.y(), Math.cos(body.angle()), Math.sin(body.angle()), own);
        if (window.contains(own.minX, own.minY) && window.contains(own.maxX, own.maxY)) {
            canvas.body(
                    shape, body.x(), body.y(), body.angle(), Looks.of(body), Showing.mood(body));
        } else if (own.overlaps(window)) {
            Placement at = new Placement(body.x(), body.y(), body.angle());
            if (shape instanceof Chain chain) {
                drawBand(canvas, body, chain);
                return;
            }
            for (int part = 0; part < shape.parts(); part++) {
                drawInside(canvas, body, new Cut(shape.outline(part), at));
            }
        }
    }

    private void drawBand(Canvas canvas, RigidBody body, Chain chain) {
        for (ChainBand.Piece piece : ChainBand.of(chain)) {
            double x = body.worldX(piece.x(), piece.y());
            double y = body.worldY(piece.x(), piece.y());
            Placement at = new Placement(x, y, body.angle());
            drawInside(canvas, body, new Cut(piece.polygon().outline(), at));
        }
    }

    private void drawInside(Canvas canvas, RigidBody body, Cut cut) {
        cut.inside(window)
                .ifPresent(
                        piece -> {
                            Polygon rest = Polygon.hull(piece);
                            canvas.body(
                                    rest,
                                    rest.centroidX(),
                                    rest.centroidY(),
                                    0,
                                    Looks.of(body),
                                    Showing.mood(body));
                        });
    }
}
