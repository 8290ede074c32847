package rigibo.frontend.scene.joint;

import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.JointKind;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;

import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Draws the coupling of two hinges: toothed wheels if they turn in opposite directions, with radii
 * from the ratio and the distance, or a belt if they turn in the same one.
 */
final class GearPicture {

    /** Teeth of the smaller wheel. */
    private static final int FEWEST_TEETH = 12;

    private final Canvas canvas;
    private final JointPen pen;

    GearPicture(Canvas canvas, JointPen pen) {
        this.canvas = canvas;
        this.pen = pen;
    }

    void draw(GearJoint gear, Function<RigidBody, Placement> poses, Predicate<Placement> isShown) {
        if (!isHinge(gear.first()) || !isHinge(gear.second())) {
            return;
        }
        Placement one = centre(gear.first(), poses);
        Placement other = centre(gear.second(), poses);
        if (!isShown.test(one) || !isShown.test(other)) {
            return;
        }
        if (gear.ratio() < 0) {
            belt(gear, one, other);
        } else {
            wheels(gear, one, other);
        }
    }

    private static boolean isHinge(Joint joint) {
        return joint.kind() == JointKind.REVOLUTE;
    }

    private static Placement centre(Joint joint, Function<RigidBody, Placement> poses) {
        RevoluteJoint hinge = (RevoluteJoint) joint.definition();
        return JointPicture.place(poses.apply(hinge.b()), hinge.frameB());
    }

    /**
     * On circles that touch the rims run alike: r₁·ω₁ = −r₂·ω₂ with ω₁ = −ratio·ω₂, so that r₂ is
     * ratio·r₁, and the second has turned by −1/ratio of the first's angle.
     */
    private void wheels(GearJoint gear, Placement one, Placement other) {
        double dx = other.x() - one.x();
        double dy = other.y() - one.y();
        double radius = Math.hypot(dx, dy) / (1 + gear.ratio());
        double second = radius * gear.ratio();
        double pitch = 2 * Math.PI * Math.min(radius, second) / FEWEST_TEETH;
        double direction = Math.atan2(dy, dx);
        double turned = gear.first().angle();
        int teeth = (int) Math.round(2 * Math.PI * radius / pitch);
        int others = (int) Math.round(2 * Math.PI * second / pitch);
        Polygon tooth = tooth(pitch);
        wheel(one, radius, direction + turned, teeth, tooth);
        // Where the first has a tooth, the second has a gap.
        double gap = Math.PI + Math.PI / others;
        wheel(other, second, direction + gap - turned / gear.ratio(), others, tooth);
    }

    /** Half of the pitch wide at the root, a third of it at the tip. */
    private static Polygon tooth(double pitch) {
        double root = -0.34 * pitch;
        double tip = 0.28 * pitch;
        return Polygon.of(
                root, -0.27 * pitch, tip, -0.14 * pitch, tip, 0.14 * pitch, root, 0.27 * pitch);
    }

    private void wheel(Placement at, double radius, double turned, int teeth, Polygon tooth) {
        for (int i = 0; i < teeth; i++) {
            double angle = turned + 2 * Math.PI * i / teeth;
            canvas.body(
                    tooth,
                    at.x() + radius * Math.cos(angle),
                    at.y() + radius * Math.sin(angle),
                    angle,
                    Skin.STONE,
                    Canvas.Mood.PLAIN);
        }
    }

    /** Two tangents, taken as parallel to the line of centres where the wheels are alike. */
    private void belt(GearJoint gear, Placement one, Placement other) {
        double distance = Math.hypot(other.x() - one.x(), other.y() - one.y());
        double radius = gear.first().b().shape().boundingRadius();
        double second = radius * -gear.ratio();
        if (distance <= Math.abs(radius - second)) {
            return;
        }
        double direction = Math.atan2(other.y() - one.y(), other.x() - one.x());
        double leaning = Math.acos((radius - second) / distance);
        for (int side = -1; side <= 1; side += 2) {
            double cos = Math.cos(direction + side * leaning);
            double sin = Math.sin(direction + side * leaning);
            pen.belt(
                    one.x() + radius * cos,
                    one.y() + radius * sin,
                    other.x() + second * cos,
                    other.y() + second * sin);
        }
    }
}
