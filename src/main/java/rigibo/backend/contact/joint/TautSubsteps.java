package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Pairs;

/**
 * The number of substeps that tension needs. A load F at an arm r turns back a body of inertia I
 * with F·r per radian, so that it oscillates at ω² = ΣF·r/I: a light link between a hook and a
 * heavy weight does so a thousand times a second. A rod or rope of length l that pulls with F also
 * draws a body of mass m back across its line, at ω² = ΣF/(l·m). Kicks along the rows of a
 * substep's start follow that as long as ω·h is below 2.
 */
final class TautSubsteps {

    /** Phase of the oscillation in a substep, rad. */
    static final double MOST_PHASE = 0.8;

    /** Most substeps, as a multiple of the usual number. */
    private static final int MOST_MORE = 32;

    /**
     * Factor on the substeps of an island in which anything touches: an impact does not last as a
     * load does. With 2.2 rad in a substep, joints of a taut bridge that something rolled over
     * opened by decimetres.
     */
    private static final int MOST_MORE_IF_TOUCHED = 4;

    /**
     * Phase in a substep at EXACT if anything touches, so that substeps are of the second order,
     * rad. The error of their energy goes with its square: bridges under a rolling disc gain less
     * than a millionth of their energy in a step, and 23 millionths with a phase of 0.13.
     */
    private static final double EXACT_PHASE = 0.012;

    private static final int MOST_MORE_IF_EXACT = 12;

    /**
     * Most substeps, as a multiple of the usual number, that are worth following at the accuracy of
     * a game if anything touches, and in islands of many bodies. An island that would need more may
     * just as well stand still.
     */
    private static final int MOST_FOLLOWED = 2;

    /**
     * Tension up to which the loads of all bodies together explain it, as a multiple of them; a bob
     * that goes full circle pulls with six times its weight.
     */
    private static final double MOST_LOADS = 8;

    /**
     * Most bodies of an island that gets more substeps; one loose joint of a crowd would slow down
     * all of it.
     */
    private static final int MOST_BODIES = 64;

    /** Number of substeps that tension needs above which passes over contacts do not suffice. */
    private static final double TIGHT = 2;

    private static final int REVOLUTE = JointKind.REVOLUTE.ordinal();

    private final Bodies bodies;
    private final JointStore joints;
    private final Islands islands;
    private final Pairs pairs;

    /** Most substeps if anything touches, as a multiple of the usual number. */
    private final int mostMoreIfTouched;

    /** Factor on the substeps that tension needs if anything touches. */
    private final double finerIfTouched;

    /** By slot: the square of its angular frequency under tension, 1/s². */
    private double[] square = new double[16];

    TautSubsteps(DataStorage data, Accuracy accuracy) {
        boolean isExact = Effort.isExact(accuracy);
        mostMoreIfTouched = isExact ? MOST_MORE_IF_EXACT : MOST_MORE_IF_TOUCHED;
        finerIfTouched = isExact ? MOST_PHASE / EXACT_PHASE : 1;
        bodies = data.bodies;
        joints = data.jointsOrNone();
        islands = data.islands;
        pairs = data.pairs;
    }

    /**
     * Number of substeps of an island that wants some to follow its vibration.
     *
     * @param isTurning whether the pull of what turns explains the vibration: unlike an impact it
     *     lasts
     */
    int count(int island, double wanted, int usual, boolean isTurning) {
        if (areMany(island)) {
            return usual;
        }
        boolean isTouched = meetsOthers(island);
        int most = isTouched && !isTurning ? mostMoreIfTouched : MOST_MORE;
        double finer = isTouched ? finerIfTouched : 1;
        return (int) Math.ceil(Math.max(usual, Math.min(most * usual, finer * wanted)));
    }

    /**
     * Whether bodies are light compared with their load, so that tension turns them back fast.
     * Passes over their contacts then converge while bodies are drawn into each other.
     */
    boolean isTight(int island, double dt) {
        return wanted(island, dt) > TIGHT;
    }

    /** Whether an island vibrates faster than is worth following in a game. */
    boolean isBeyond(int island, double wanted, int usual) {
        return wanted > MOST_FOLLOWED * usual && (areMany(island) || meetsOthers(island));
    }

    /** Whether an island in which nothing touches vibrates faster than any substeps follow. */
    boolean isBeyondAny(int island, double wanted, int usual) {
        return wanted > MOST_MORE * usual && !areMany(island) && !meetsOthers(island);
    }

    /**
     * Whether an island is tauter than its loads explain: the forces on its bodies, those that bend
     * their paths to a radius of their width, those of its motors and springs, and those with which
     * its contacts press, also in an impact. Such an island is as long as its span, and its motion
     * is the error of its joints.
     *
     * @param loads the forces on its bodies, N
     * @param contactForce the mean forces of its contacts in an attempt at the step, N
     */
    boolean isUnexplained(int island, double loads, double contactForce) {
        double strongest = 0;
        double others = Math.max(contactForce, pressed(island));
        for (int i = islands.jointStart[island]; i < islands.jointStart[island + 1]; i++) {
            int joint = islands.joints[i];
            double force = joints.pull[joint];
            strongest = Math.max(strongest, force);
            others += ofMotor(joint) + ofSpring(joint, force);
        }
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            if (bodies.inverseMass[slot] > 0) {
                double x = bodies.velocityX[slot];
                double y = bodies.velocityY[slot];
                others += (x * x + y * y) / (bodies.smallestWidth[slot] * bodies.inverseMass[slot]);
            }
        }
        return strongest > MOST_LOADS * (loads + others);
    }

    /** Sum of the forces with which contacts of an island pressed in the last kick, N. */
    private double pressed(int island) {
        double sum = 0;
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            int pair = islands.pairs[i];
            sum += pairs.normalForce[2 * pair] + pairs.normalForce[2 * pair + 1];
        }
        return sum;
    }

    /** Sum of the forces on the bodies of an island, N. */
    double loads(int island) {
        double sum = 0;
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            if (bodies.inverseMass[slot] > 0) {
                double pull = length(bodies.accelerationX[slot], bodies.accelerationY[slot]);
                sum += pull / bodies.inverseMass[slot];
            }
        }
        return sum;
    }

    /** Largest force of a joint's motor, N. */
    private double ofMotor(int joint) {
        int kind = joints.kind[joint];
        if (kind == JointKind.MOTOR.ordinal()) {
            return joints.parameter[JointStore.MOST_FORCE][joint];
        }
        double most = joints.motorMost[joint];
        boolean turns = kind == REVOLUTE || kind == JointKind.WHEEL.ordinal();
        return turns && most > 0 ? atWidth(joint, most) : most;
    }

    /** Largest force of a joint's spring, N, in a joint that pulled with a force in N. */
    private double ofSpring(int joint, double force) {
        if (!(joints.stiffness[joint] > 0)) {
            return 0;
        }
        int kind = joints.kind[joint];
        boolean turns = kind == REVOLUTE || kind == JointKind.WELD.ordinal();
        return turns ? atWidth(joint, Math.abs(joints.reactionTurn[joint])) : force;
    }

    /** Force of a torque at an arm of the thinner body's width, N. */
    private double atWidth(int joint, double torque) {
        double widthA = bodies.smallestWidth[joints.bodyA[joint]];
        return torque / Math.min(widthA, bodies.smallestWidth[joints.bodyB[joint]]);
    }

    /**
     * Number of substeps that follow the vibration in a step of dt seconds, by the impulses of
     * joints in the last step.
     */
    double wanted(int island, double dt) {
        return Math.sqrt(square(island)) * dt / MOST_PHASE;
    }

    private boolean areMany(int island) {
        return islands.bodyStart[island + 1] - islands.bodyStart[island] > MOST_BODIES;
    }

    /** Whether anything touches in an island, or may touch. */
    boolean meetsOthers(int island) {
        return islands.pairStart[island + 1] > islands.pairStart[island];
    }

    /** Square of the fastest oscillation by the last impulses of an island's joints, 1/s². */
    double square(int island) {
        if (square.length < bodies.type.length) {
            square = new double[bodies.type.length];
        }
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            square[islands.bodies[i]] = 0;
        }
        double most = 0;
        for (int i = islands.jointStart[island]; i < islands.jointStart[island + 1]; i++) {
            most = Math.max(most, add(islands.joints[i]));
        }
        return most;
    }

    private double add(int joint) {
        double force = joints.pull[joint];
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        double armA = joints.armA(joint);
        double armB = joints.armB(joint);
        double across = stiffnessAcross(joint, force);
        double onA = squareOf(a, force * armA, armA, across);
        double onB = squareOf(b, force * armB, armB, across);
        if (bodies.isDynamic(a)) {
            square[a] += onA;
            onA = square[a];
        }
        if (bodies.isDynamic(b)) {
            square[b] += onB;
            onB = square[b];
        }
        return Math.max(onA, onB);
    }

    /**
     * Square of the frequency of a body that is turned back by {@code turn} N·m per radian, and
     * drawn back by {@code across} N/m at an arm in m, 1/s².
     */
    private double squareOf(int body, double turn, double arm, double across) {
        if (!bodies.isDynamic(body)) {
            return 0;
        }
        double turning = (turn + across * arm * arm) * bodies.inverseInertiaOf(body);
        return turning + across * bodies.inverseMass[body];
    }

    /** Stiffness with which a rod or rope draws its ends back to its line, N/m. */
    private double stiffnessAcross(int joint, double force) {
        if (joints.kind[joint] != JointKind.DISTANCE.ordinal()) {
            return 0;
        }
        double length = joints.tautLength(joint);
        return length > 0 ? force / length : 0;
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }
}
