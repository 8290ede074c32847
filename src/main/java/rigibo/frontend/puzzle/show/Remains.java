package rigibo.frontend.puzzle.show;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/**
 * The last appearance of a deleted body.
 *
 * @param shape its outline
 * @param pose its last pose
 * @param skin its skin
 */
record Remains(Shape shape, Pose pose, Skin skin) {

    /** Factors by which it becomes flatter and wider. */
    private static final double FLATTER = 0.7;

    private static final double WIDER = 0.3;

    double width() {
        Aabb bounds = bounds();
        return bounds.maxX - bounds.minX;
    }

    double height() {
        Aabb bounds = bounds();
        return bounds.maxY - bounds.minY;
    }

    private Aabb bounds() {
        Aabb bounds = new Aabb();
        shape.bounds(0, 0, 1, 0, bounds);
        return bounds;
    }

    /** Draws it squashed towards its support, by a share from 0 (unchanged) to 1. */
    void draw(Canvas canvas, double squashed) {
        boolean isUpright = Math.abs(Math.cos(pose.angle())) > Math.abs(Math.sin(pose.angle()));
        double flat = 1 - FLATTER * squashed;
        double wide = 1 + WIDER * squashed;
        double across = isUpright ? wide : flat;
        double along = isUpright ? flat : wide;
        double sunk = (isUpright ? height() : width()) / 2 * (1 - flat);
        Shape flattened = scaled(shape, across, along);
        canvas.body(flattened, pose.x(), pose.y() - sunk, pose.angle(), skin, Canvas.Mood.HOVERED);
    }

    private static Shape scaled(Shape shape, double across, double along) {
        if (shape instanceof Compound compound) {
            return scaled(compound, across, along);
        }
        // A chain is drawn unchanged, since it has no middle to be squashed towards.
        return shape instanceof Convex convex ? scaled(convex, across, along) : shape;
    }

    /**
     * Squashes oblique parts along their own axes, which is not noticeable in a tenth of a second.
     */
    private static Shape scaled(Compound compound, double across, double along) {
        List<Part> parts = new ArrayList<>();
        for (int i = 0; i < compound.parts(); i++) {
            Part part = compound.part(i);
            parts.add(
                    Part.of(scaled(part.shape(), across, along))
                            .at(across * part.x(), along * part.y())
                            .angle(part.angle()));
        }
        return Compound.of(parts)
                .centredAt(across * compound.centroidX(), along * compound.centroidY());
    }

    private static Convex scaled(Convex shape, double across, double along) {
        Outline outline = shape.outline();
        double radius = outline.radius() * Math.min(across, along);
        if (outline.isDisc()) {
            return new Circle(radius);
        }
        if (shape instanceof Capsule capsule) {
            return new Capsule(across * capsule.halfLength(), radius);
        }
        double[] corners = new double[2 * outline.corners()];
        for (int i = 0; i < outline.corners(); i++) {
            corners[2 * i] = across * outline.cornerX(i);
            corners[2 * i + 1] = along * outline.cornerY(i);
        }
        return Polygon.of(corners).rounded(radius);
    }
}
