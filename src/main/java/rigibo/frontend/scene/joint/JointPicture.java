package rigibo.frontend.scene.joint;

import rigibo.backend.DistanceJoint;
import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.MouseJoint;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.PulleyJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Layout;

import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;

/** Draws the joints of a pool over its bodies, each kind as a workshop would make it. */
public final class JointPicture {

    /** A pin is as thick as this share of the thinner body, within bounds, m. */
    private static final double PIN_SHARE = 0.55;

    private static final double THINNEST_PIN = 0.02;
    private static final double THICKEST_PIN = 0.09;

    /** The arrow of a motor, as a multiple of its pin. */
    private static final double ARROW = 2.3;

    /** Height of a strut's upper end over the axle, in radii of the wheel. */
    private static final double STRUT = 1.25;

    /** A rail without an end reaches so far beyond what slides on it, m. */
    private static final double RAIL_BEYOND = 0.3;

    private static final double PULLEY = 0.16;

    /** A joint is drawn whose ends are no farther from the window, px. */
    private static final double BESIDE = 300;

    private final JointPen pen;
    private final GearPicture gears;
    private final Function<RigidBody, Placement> poses;
    private final Predicate<Placement> isShown;
    private final Aabb bounds = new Aabb();

    private JointPicture(
            Canvas canvas,
            Camera camera,
            Function<RigidBody, Placement> poses,
            Predicate<Placement> isShown) {
        pen = new JointPen(canvas, camera);
        gears = new GearPicture(canvas, pen);
        this.poses = poses;
        this.isShown = isShown;
    }

    /** Draws joints where their bodies are now. */
    public static void draw(Canvas canvas, Camera camera, List<Joint> joints) {
        draw(canvas, camera, joints, JointPicture::pose);
    }

    /** Draws joints with their bodies somewhere else, such as between two steps. */
    public static void draw(
            Canvas canvas,
            Camera camera,
            List<Joint> joints,
            Function<RigidBody, Placement> poses) {
        Layout layout = canvas.layout();
        new JointPicture(canvas, camera, poses, at -> isNear(layout, camera, at)).draw(joints);
    }

    /** Whether a point is in the window, or outside it by at most the window's own size. */
    private static boolean isNear(Layout layout, Camera camera, Placement at) {
        return layout.shows(camera.screenX(at.x()), camera.screenY(at.y()), BESIDE);
    }

    /** Draws those joints that have both ends in a window of the world, m. */
    public static void drawInside(Canvas canvas, Camera camera, List<Joint> joints, Aabb window) {
        Predicate<Placement> isInside = at -> window.contains(at.x(), at.y());
        new JointPicture(canvas, camera, JointPicture::pose, isInside).draw(joints);
    }

    private static Placement pose(RigidBody body) {
        return new Placement(body.x(), body.y(), body.angle());
    }

    /** Cords and rods first, so that pins lie over their ends. */
    private void draw(List<Joint> joints) {
        for (Joint joint : joints) {
            drawBetween(joint.definition());
        }
        for (Joint joint : joints) {
            drawAt(joint.definition());
        }
    }

    private void drawBetween(JointDefinition of) {
        switch (of.kind()) {
            case DISTANCE -> distance((DistanceJoint) of);
            case PRISMATIC -> slide((PrismaticJoint) of);
            case WHEEL -> strut((WheelJoint) of);
            case PULLEY -> pulley((PulleyJoint) of);
            case GEAR -> gears.draw((GearJoint) of, poses, isShown);
            case MOUSE -> hand((MouseJoint) of);
            case REVOLUTE, WELD, MOTOR, FILTER -> {}
        }
    }

    private void drawAt(JointDefinition of) {
        switch (of.kind()) {
            case REVOLUTE -> hinge((RevoluteJoint) of);
            case WELD -> weld((WeldJoint) of);
            case DISTANCE -> ends((DistanceJoint) of);
            case WHEEL -> axle((WheelJoint) of);
            case PRISMATIC, MOTOR, MOUSE, GEAR, PULLEY, FILTER -> {}
        }
    }

    /** Where a frame of a body is in the world. */
    static Placement place(Placement body, JointFrame frame) {
        double cos = Math.cos(body.angle());
        double sin = Math.sin(body.angle());
        return new Placement(
                body.x() + cos * frame.x() - sin * frame.y(),
                body.y() + sin * frame.x() + cos * frame.y(),
                body.angle() + frame.angle());
    }

    private Placement place(RigidBody body, JointFrame frame) {
        return place(poses.apply(body), frame);
    }

    private boolean areShown(Placement one, Placement other) {
        return isShown.test(one) && isShown.test(other);
    }

    /** Radius of a pin through both bodies, m. */
    private double pin(JointDefinition of) {
        double thin = Math.min(thinness(of.a()), thinness(of.b()));
        return Math.max(THINNEST_PIN, Math.min(THICKEST_PIN, PIN_SHARE * thin));
    }

    /** Half of the smaller side of what moves, m. */
    private double thinness(RigidBody body) {
        if (body.type() == BodyType.STATIC) {
            return Double.POSITIVE_INFINITY;
        }
        Shape shape = body.shape();
        shape.bounds(0, 0, 1, 0, bounds);
        return Math.min(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY) / 2;
    }

    private void distance(DistanceJoint of) {
        Placement a = place(of.a(), of.frameA());
        Placement b = place(of.b(), of.frameB());
        if (!areShown(a, b)) {
            return;
        }
        JointLimits limits = of.settings().limits();
        if (of.settings().spring().isThere()) {
            pen.spring(a.x(), a.y(), b.x(), b.y(), of.length());
        } else if (limits.areAny() && limits.lower() <= 0) {
            pen.rope(a.x(), a.y(), b.x(), b.y(), limits.upper());
        } else {
            pen.rod(a.x(), a.y(), b.x(), b.y());
        }
    }

    private void ends(DistanceJoint of) {
        end(of, place(of.a(), of.frameA()), of.a());
        end(of, place(of.b(), of.frameB()), of.b());
    }

    private void end(DistanceJoint of, Placement at, RigidBody body) {
        if (isShown.test(at)) {
            double least = Math.min(THICKEST_PIN, PIN_SHARE * thinness(body));
            double radius = of.isRod() ? least : 0.7 * least;
            pen.pin(at.x(), at.y(), Math.max(THINNEST_PIN, radius), at.angle());
        }
    }

    private void hinge(RevoluteJoint of) {
        Placement at = place(of.b(), of.frameB());
        if (isShown.test(at)) {
            double radius = pin(of);
            turning(of, at, ARROW * radius);
            pen.pin(at.x(), at.y(), radius, at.angle());
        }
    }

    /** The arrow of a motor that does more than hold. */
    private void turning(JointDefinition of, Placement at, double radius) {
        JointMotor motor = of.settings().motor();
        if (motor.drives() && motor.speed() != 0) {
            pen.motor(at.x(), at.y(), radius, at.angle(), motor.speed());
        }
    }

    private void weld(WeldJoint of) {
        Placement at = place(of.b(), of.frameB());
        if (isShown.test(at)) {
            pen.weld(at.x(), at.y(), pin(of), at.angle());
        }
    }

    private void slide(PrismaticJoint of) {
        Placement a = place(of.a(), of.frameA());
        Placement b = place(of.b(), of.frameB());
        double cos = Math.cos(a.angle());
        double sin = Math.sin(a.angle());
        double way = (b.x() - a.x()) * cos + (b.y() - a.y()) * sin;
        JointLimits limits = of.settings().limits();
        double lower = finite(limits.lower(), Math.min(0, way) - RAIL_BEYOND);
        double upper = finite(limits.upper(), Math.max(0, way) + RAIL_BEYOND);
        Placement from = Placement.at(a.x() + lower * cos, a.y() + lower * sin);
        Placement to = Placement.at(a.x() + upper * cos, a.y() + upper * sin);
        if (!areShown(from, to)) {
            return;
        }
        pen.rail(from.x(), from.y(), to.x(), to.y());
        if (of.settings().spring().isThere()) {
            pen.spring(from.x(), from.y(), b.x(), b.y(), -lower);
        }
        pen.pin(b.x(), b.y(), THICKEST_PIN, b.angle());
    }

    private static double finite(double limit, double otherwise) {
        return Math.abs(limit) < Double.POSITIVE_INFINITY ? limit : otherwise;
    }

    /** From the chassis down to the axle. */
    private void strut(WheelJoint of) {
        Placement a = place(of.a(), of.frameA());
        Placement b = place(of.b(), of.frameB());
        Placement chassis = poses.apply(of.a());
        double cos = Math.cos(a.angle());
        double sin = Math.sin(a.angle());
        double towards = (chassis.x() - a.x()) * cos + (chassis.y() - a.y()) * sin;
        double up = towards < 0 ? -1 : 1;
        double length = STRUT * thinness(of.b());
        double topX = a.x() + up * length * cos;
        double topY = a.y() + up * length * sin;
        if (areShown(b, Placement.at(topX, topY))) {
            pen.spring(b.x(), b.y(), topX, topY, length);
            pen.pin(topX, topY, THICKEST_PIN * 0.6, a.angle());
        }
    }

    private void axle(WheelJoint of) {
        Placement at = place(of.b(), of.frameB());
        if (isShown.test(at)) {
            double radius = Math.min(THICKEST_PIN, 0.3 * thinness(of.b()));
            turning(of, at, 0.6 * thinness(of.b()));
            pen.pin(at.x(), at.y(), radius, at.angle());
        }
    }

    private void pulley(PulleyJoint of) {
        Placement a = place(of.a(), of.frameA());
        Placement b = place(of.b(), of.frameB());
        Placement overA = Placement.at(of.groundAX(), of.groundAY());
        Placement overB = Placement.at(of.groundBX(), of.groundBY());
        if (!areShown(a, b) || !areShown(overA, overB)) {
            return;
        }
        double lengthA = Math.hypot(a.x() - overA.x(), a.y() - overA.y());
        double turned = lengthA / PULLEY;
        cord(a, overA);
        cord(overA, overB);
        cord(overB, b);
        pen.pulley(overA.x(), overA.y(), PULLEY, turned);
        pen.pulley(overB.x(), overB.y(), PULLEY, turned);
        pen.pin(a.x(), a.y(), THICKEST_PIN * 0.7, a.angle());
        pen.pin(b.x(), b.y(), THICKEST_PIN * 0.7, b.angle());
    }

    private void cord(Placement from, Placement to) {
        double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
        pen.rope(from.x(), from.y(), to.x(), to.y(), length);
    }

    private void hand(MouseJoint of) {
        Placement b = place(of.b(), of.frameB());
        pen.hand(b.x(), b.y(), of.targetX(), of.targetY());
    }
}
