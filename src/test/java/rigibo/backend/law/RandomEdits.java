package rigibo.backend.law;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.JointKind;

import java.util.ArrayList;
import java.util.List;

/** Edits of a pool drawn from a seed. */
final class RandomEdits {

    /** Where bodies come and go, m: within every tray. */
    private static final double HALF_WIDTH = 1.9;

    private static final double HIGHEST = 8;

    /** Share of edits that concern joints, in scenes in which bodies may be joined. */
    private static final double JOINTS = 0.3;

    private final Pool pool;
    private final Draw draw;

    /** The first bodies, which hold the others and are left alone. */
    private final int tray;

    private final List<RigidBody> removed = new ArrayList<>();
    private long ofTouching;

    RandomEdits(Pool pool, int tray, long seed) {
        this.pool = pool;
        this.tray = tray;
        draw = new Draw(seed);
    }

    /** Every body taken out up to now. */
    List<RigidBody> removed() {
        return removed;
    }

    /** Edits up to now of bodies that touched another. */
    long ofTouching() {
        return ofTouching;
    }

    /** One edit that puts no body into another. */
    String gentle() {
        if (pool.bodies().size() <= tray) {
            return add();
        }
        RigidBody body = draw.chance(0.5) ? touching() : loose();
        ofTouching += touches(body) ? 1 : 0;
        if (pool.effects().declares(Joints.class) && draw.chance(JOINTS)) {
            return body.joints().isEmpty() ? join(body) : edit(draw.oneOf(body.joints()));
        }
        return switch (draw.whole(0, 7)) {
            case 0 -> remove(body);
            case 1 -> add();
            case 2 -> stop(body, BodyType.KINEMATIC);
            case 3 -> stop(body, BodyType.STATIC);
            case 4 -> free(body);
            case 5 -> shrink(body);
            case 6 -> change(body);
            default -> teleport(body);
        };
    }

    /** One edit that may put a body into others. */
    String rough() {
        if (pool.bodies().size() <= tray || draw.chance(0.5)) {
            return gentle();
        }
        RigidBody body = loose();
        if (!body.joints().isEmpty()) {
            // Elsewhere it would wind up springs.
            return change(body);
        }
        return switch (draw.whole(0, 2)) {
            case 0 -> {
                body.shape(draw.shape(draw.between(0.1, 1)));
                yield "reshaped " + body;
            }
            case 1 -> {
                body.moveTo(
                        draw.between(-HALF_WIDTH, HALF_WIDTH),
                        draw.between(-0.5, 2),
                        draw.between(-9, 9));
                yield "put into others " + body;
            }
            default -> {
                pool.add(matter().at(draw.between(-HALF_WIDTH, HALF_WIDTH), draw.between(0, 2)));
                yield "added into others";
            }
        };
    }

    /** One of the bodies that are not the tray. */
    RigidBody loose() {
        return pool.bodies().get(draw.whole(tray, pool.bodies().size() - 1));
    }

    /** One of them that touches another body; any where none does. */
    private RigidBody touching() {
        List<RigidBody> all = pool.bodies().stream().skip(tray).filter(this::touches).toList();
        return all.isEmpty() ? loose() : draw.oneOf(all);
    }

    String remove(RigidBody body) {
        pool.remove(body);
        removed.add(body);
        return "removed " + body;
    }

    private boolean touches(RigidBody body) {
        return pool.bodies().stream()
                .anyMatch(other -> other != body && pool.touching(body, other));
    }

    private String add() {
        BodyDefinition body = matter();
        double[] place = freePlace(body.shape());
        if (place.length > 0) {
            pool.add(body.at(place[0], place[1]));
        }
        return "added";
    }

    private String stop(RigidBody body, BodyType type) {
        body.type(type);
        if (type == BodyType.KINEMATIC) {
            body.velocity(0, 0);
            body.spin(0);
        }
        return "stopped " + body;
    }

    private String free(RigidBody body) {
        body.type(BodyType.DYNAMIC);
        return "freed " + body;
    }

    /** Another shape that lies within the one before; what has parts changes its matter. */
    private String shrink(RigidBody body) {
        Shape shape = body.shape();
        if (shape instanceof Circle circle) {
            body.shape(Polygon.regular(draw.whole(3, 9), 0.9 * circle.radius()));
        } else if (shape instanceof Compound) {
            return change(body);
        } else {
            Outline outline = shape.outline(0);
            double inner = Math.max(0, outline.innerRadius()) + outline.radius();
            body.shape(new Circle(0.9 * inner));
        }
        return "shrunk " + body;
    }

    private String change(RigidBody body) {
        body.material(draw.material());
        return "changed " + body;
    }

    /** To the body next to it, as both are placed. */
    private String join(RigidBody body) {
        RigidBody other = loose();
        if (other == body) {
            return "joined nothing";
        }
        double x = (body.x() + other.x()) / 2;
        double y = (body.y() + other.y()) / 2;
        pool.join(
                switch (draw.whole(0, 2)) {
                    case 0 -> RevoluteJoint.at(body, other, x, y);
                    case 1 -> WeldJoint.at(body, other, x, y);
                    default -> {
                        double ax = body.x();
                        double ay = body.y();
                        yield DistanceJoint.rod(body, ax, ay, other, other.x(), other.y());
                    }
                });
        return "joined " + body;
    }

    /** Edits that only take energy away; bodies that a joint let overlap stay joined. */
    private String edit(Joint joint) {
        JointKind kind = joint.kind();
        boolean bends = kind == JointKind.REVOLUTE;
        if (draw.chance(0.5) || !bends && kind != JointKind.PRISMATIC) {
            if (joint.definition().settings().collideConnected()) {
                pool.remove(joint);
            }
            return "parted";
        }
        double now = bends ? joint.angle() : joint.translation();
        if (draw.chance(0.5)) {
            joint.limits(now - draw.between(0, 0.3), now + draw.between(0, 0.3));
            return "limited " + joint;
        }
        joint.motor(0, draw.ofAnySize(0.01, 10));
        return "braked " + joint;
    }

    /**
     * Joined bodies stay where they are, since a stretched joint would pull them and add energy.
     */
    private String teleport(RigidBody body) {
        if (!body.joints().isEmpty()) {
            return "left " + body;
        }
        double[] place = freePlace(body.shape());
        if (place.length > 0) {
            body.moveTo(place[0], place[1], draw.between(-9, 9));
        }
        return "teleported " + body;
    }

    private BodyDefinition matter() {
        return BodyDefinition.dynamic(draw.shape(draw.between(0.15, 0.4)))
                .angle(draw.between(-3, 3))
                .material(draw.material());
    }

    /** x and y of a place where the shape meets nothing; none where none is found. */
    private double[] freePlace(Shape shape) {
        double reach = shape.boundingRadius() + 0.05;
        for (int i = 0; i < 20; i++) {
            double x = draw.between(-HALF_WIDTH, HALF_WIDTH);
            double y = draw.between(reach, HIGHEST);
            boolean[] isTaken = {false};
            Aabb box = new Aabb();
            box.set(x - reach, y - reach, x + reach, y + reach);
            pool.overlapping(box, other -> isTaken[0] = true);
            if (!isTaken[0]) {
                return new double[] {x, y};
            }
        }
        return new double[0];
    }
}
