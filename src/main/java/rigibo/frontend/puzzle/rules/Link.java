package rigibo.frontend.puzzle.rules;

import rigibo.backend.Joint;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Length;
import rigibo.backend.setup.JointMotor;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.scene.joint.RopeLine;

import java.util.Optional;

/** A joint of the level in play on which clicks act. */
public final class Link implements Target {

    private final LevelJoint definition;
    private final Joint joint;
    private final Anchor a;
    private final Anchor b;
    private boolean isOn;

    /**
     * A point of a body, which remains when the joint is gone.
     *
     * @param body on which it lies
     * @param localX m, in the body's frame
     * @param localY m, in the body's frame
     */
    public record Anchor(RigidBody body, double localX, double localY) {

        static Anchor at(RigidBody body, double x, double y) {
            return new Anchor(body, body.localX(x, y), body.localY(x, y));
        }

        /** World x, m. */
        public double x() {
            return body.worldX(localX, localY);
        }

        /** World y, m, up. */
        public double y() {
            return body.worldY(localX, localY);
        }
    }

    Link(LevelJoint definition, Joint joint) {
        this.definition = definition;
        this.joint = joint;
        isOn = definition.handling().isOn();
        a = Anchor.at(joint.a(), joint.xA(), joint.yA());
        b = Anchor.at(joint.b(), joint.xB(), joint.yB());
    }

    /** The level's definition. */
    public LevelJoint definition() {
        return definition;
    }

    /** Its handle; no longer alive after it was cut, pulled or broken. */
    public Joint joint() {
        return joint;
    }

    /** The point at which it holds, or held, its first body. */
    public Anchor a() {
        return a;
    }

    /** The point at which it holds, or held, its second body. */
    public Anchor b() {
        return b;
    }

    @Override
    public String id() {
        return definition.id().orElseThrow();
    }

    @Override
    public Optional<Verb> verb() {
        return definition.verb();
    }

    @Override
    public boolean isAlive() {
        return joint.isAlive();
    }

    @Override
    public boolean isOn() {
        return isOn;
    }

    /** Switches the motor; one that is off neither drives nor brakes. */
    void flip() {
        isOn = !isOn;
        JointMotor motor = isOn ? definition.settings().motor() : JointMotor.NONE;
        joint.settings(joint.definition().settings().motor(motor));
    }

    @Override
    public double x() {
        return isRope() ? line().x(0.5) : b.x();
    }

    @Override
    public double y() {
        return isRope() ? line().y(0.5) : b.y();
    }

    /** Whether it is drawn as a line between its ends. */
    public boolean isRope() {
        return definition.type() == LevelJoint.Type.ROPE;
    }

    /** The line along which a rope is drawn. */
    public RopeLine line() {
        return RopeLine.hanging(a.x(), a.y(), b.x(), b.y(), definition.length());
    }

    /** Distance of a point of the world from its drawing, m. */
    double distance(double x, double y) {
        return isRope() ? line().distance(x, y) : Length.hypot(x - b.x(), y - b.y());
    }
}
