package rigibo.backend.storage;

import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.EnumSet;
import java.util.Set;

/**
 * Columns of the bodies, one slot each. A slot whose {@link #type} is null is empty. {@link
 * BodyColumns} lists all columns, for operations on every one of them.
 */
public final class Bodies {

    private static final int FIRST_CAPACITY = 16;

    public final Slots slots = new Slots();

    /** As the caller stated it. */
    public BodyType[] type = new BodyType[FIRST_CAPACITY];

    public Shape[] shape = new Shape[FIRST_CAPACITY];

    /** The outline that collision detection uses. */
    public Outline[] outline = new Outline[FIRST_CAPACITY];

    public Material[] material = new Material[FIRST_CAPACITY];
    public int[] group = new int[FIRST_CAPACITY];
    public double[] gravityScale = new double[FIRST_CAPACITY];

    /**
     * Mass in kg and inertia in kg·m² stated in place of the material's density; 0 where none was.
     * They are kept whatever effects are declared, so that rotation declared later finds the stated
     * inertia.
     */
    public double[] statedMass = new double[FIRST_CAPACITY];

    public double[] statedInertia = new double[FIRST_CAPACITY];

    /** Pose: centre of mass in m, angle in rad, its cosine and sine. */
    public double[] x = new double[FIRST_CAPACITY];

    public double[] y = new double[FIRST_CAPACITY];
    public double[] angle = new double[FIRST_CAPACITY];
    public double[] cos = new double[FIRST_CAPACITY];
    public double[] sin = new double[FIRST_CAPACITY];

    /** Motion: m/s. */
    public double[] velocityX = new double[FIRST_CAPACITY];

    public double[] velocityY = new double[FIRST_CAPACITY];

    /** What the declared effects make of it: m/s², of this step. */
    public double[] accelerationX = new double[FIRST_CAPACITY];

    public double[] accelerationY = new double[FIRST_CAPACITY];

    /** Mass in kg and its inverse in 1/kg; 0 for bodies that forces cannot move. */
    public double[] mass = new double[FIRST_CAPACITY];

    public double[] inverseMass = new double[FIRST_CAPACITY];

    /** Distance from the centre of mass to the farthest point of the shape, m. */
    public double[] boundingRadius = new double[FIRST_CAPACITY];

    /** Whether the body is awake, so that steps simulate it. */
    public boolean[] awake = new boolean[FIRST_CAPACITY];

    /**
     * Position at the start of the step, m; a body returns to it when its state stops being finite.
     */
    public double[] startX = new double[FIRST_CAPACITY];

    public double[] startY = new double[FIRST_CAPACITY];

    // The columns below exist only if an effect that needs them is declared; otherwise they are
    // null.

    /**
     * With rotation: angular velocity in rad/s, angular acceleration in this step in rad/s², and
     * the angle at the start of the step in rad.
     */
    public double[] spin;

    public double[] angularAcceleration;
    public double[] startAngle;

    /** Inertia in kg·m² and its inverse; 0 for bodies that torques cannot turn. */
    public double[] inertia;

    public double[] inverseInertia;

    /** With contacts: smallest width of the shape, m. */
    public double[] smallestWidth;

    /**
     * With contacts and rotation: speed at which turning moves the outline, m per rad; 0 for a
     * disc.
     */
    public double[] sweepRadius;

    /** The fixture, m, and its leaf in the tree of the broad phase. */
    public double[] fixtureMinX;

    public double[] fixtureMinY;
    public double[] fixtureMaxX;
    public double[] fixtureMaxY;
    public int[] leaf;

    /** Whether the fixture was replaced since the broad phase last searched for pairs. */
    public boolean[] refitted;

    /**
     * For bodies with several shapes: the body of each shape's slot, and the slot of that body's
     * next shape or {@link Pairs#NONE}. A body's own slot holds its first shape. The other slots
     * hold a shape, a material and a fixture, but no motion. Null where every body has one shape.
     */
    public int[] owner;

    public int[] nextShape;

    /** The number, from 0, of the part of its body's shape that a slot holds. */
    public int[] part;

    /**
     * Categories of a shape, one bit each, and the categories with which it collides; null where
     * every shape is in the first category and collides with all.
     */
    public int[] category;

    public int[] mask;

    /** Whether the rotation of a body is locked; null where none is. */
    public boolean[] rotationLocked;

    /** Whether a body's motion along x or y is locked; null where none is. */
    public boolean[] lockedX;

    public boolean[] lockedY;

    /** Target pose of a driven body, m and rad, and time to reach it, s; 0 s if it has none. */
    public double[] driveX;

    public double[] driveY;
    public double[] driveAngle;
    public double[] driveTime;

    /** Whether a body is disabled: it neither moves nor collides; null where none is. */
    public boolean[] disabled;

    /** First pair in the list of the body's pairs; see {@link Pairs}. */
    public int[] firstPair;

    /**
     * Whether the body is part of a pile in this step, and since when, s after the step's start.
     */
    public boolean[] piled;

    public double[] pileTime;

    /** With sleep: how long (s) the body has stayed near an anchor pose, and that pose, m. */
    public double[] stillTime;

    public double[] stillX;
    public double[] stillY;

    /** With sleep and rotation: the angle of the anchor pose, rad. */
    public double[] stillAngle;

    /** Copied from the material, so that a loop over contacts reads flat columns. */
    public double[] friction;

    public double[] elasticity;

    /**
     * Normal of a surface that is solid on one side only, in the body's frame; 0 for a shape that
     * is solid all round. Null where no shape is solid on one side only.
     */
    public double[] oneWayX;

    public double[] oneWayY;

    /** Whether a shape is a sensor; null where none is. */
    public boolean[] sensor;

    /** Applied force, N, and, with rotation, applied torque, N·m. */
    public double[] forceX;

    public double[] forceY;
    public double[] torque;

    /** Rolling resistance lever in m, surface speed in m/s, drag in 1/s. */
    public double[] rollingResistance;

    public double[] surfaceSpeed;
    public double[] drag;

    /**
     * The share of the accelerations that comes from forces that vary along the path, m/s² and,
     * with rotation, rad/s²; null where no path is integrated.
     */
    public double[] pullX;

    public double[] pullY;
    public double[] pullTurn;

    private final Room room = new Room(FIRST_CAPACITY, this::visitColumns);
    private Effects effects;
    private final Set<Need> asked = EnumSet.noneOf(Need.class);

    /** Creates the columns that a set of effects needs. */
    public Bodies(Effects effects) {
        declare(effects);
    }

    /** Passes every column to a visitor, which may replace the arrays. */
    public void visitColumns(ColumnVisitor visitor) {
        BodyColumns.visit(this, visitor);
    }

    /**
     * Makes the columns of newly declared effects and drops those of effects no longer declared.
     */
    public void declare(Effects declared) {
        effects = declared;
        visitColumns(new Declaring(effects, asked, room.slots()));
    }

    /** Makes or drops the columns that integrated paths need. */
    public void integratePaths(boolean isNeeded) {
        ask(Need.PATHS, isNeeded);
        ask(Need.TURNING_PATHS, isNeeded);
        declare(effects);
    }

    /** Whether the columns for integrated paths exist. */
    public boolean integratesPaths() {
        return asked.contains(Need.PATHS);
    }

    private void ask(Need need, boolean isNeeded) {
        if (isNeeded) {
            asked.add(need);
        } else {
            asked.remove(need);
        }
    }

    /**
     * Makes columns that a body needs, whatever effects are declared; all other bodies get neutral
     * values.
     */
    public void hold(Need need) {
        if (!asked.contains(need)) {
            ask(need, true);
            declare(effects);
            for (int slot = 0; slot < slots.high; slot++) {
                begin(slot, need);
            }
        }
    }

    /** Whether the columns for such a need exist. */
    public boolean holds(Need need) {
        return asked.contains(need);
    }

    /** Whether a body may have more than one shape. */
    public boolean holdsCompounds() {
        return owner != null;
    }

    /** Writes the neutral value of such a need into a slot. */
    private void begin(int slot, Need need) {
        switch (need) {
            case COMPOUNDS -> {
                owner[slot] = slot;
                nextShape[slot] = Pairs.NONE;
                part[slot] = 0;
            }
            case FILTERS -> {
                category[slot] = 1;
                mask[slot] = ~0;
            }
            case LOCKS -> rotationLocked[slot] = false;
            case AXES -> {
                lockedX[slot] = false;
                lockedY[slot] = false;
            }
            case DRIVES -> driveTime[slot] = 0;
            case ABSENCES -> disabled[slot] = false;
            case SENSORS -> sensor[slot] = false;
            case ONE_SIDED -> {
                oneWayX[slot] = 0;
                oneWayY[slot] = 0;
            }
            default -> throw new AssertionError(need + " follows from effects");
        }
    }

    /** Returns a free slot, with room in every column, for a body with its first shape. */
    public int take() {
        int slot = slots.take();
        room.hold(slot);
        for (Need need : Need.OF_BODIES) {
            if (asked.contains(need)) {
                begin(slot, need);
            }
        }
        return slot;
    }

    /** Returns a slot for a further shape of a body, after the shape that has been its last. */
    public int takeShape(int body, int last) {
        int slot = take();
        owner[slot] = body;
        nextShape[last] = slot;
        part[slot] = part[last] + 1;
        return slot;
    }

    /** The slot of the body to which a shape's slot belongs. */
    public int bodyOf(int slot) {
        return owner == null ? slot : owner[slot];
    }

    /** Whether a body may have more than one shape. */
    public boolean mayHaveParts() {
        return owner != null;
    }

    /** The slot of the next shape of the same body, or {@link Pairs#NONE}. */
    public int nextShapeOf(int slot) {
        return owner == null ? Pairs.NONE : nextShape[slot];
    }

    /** The number, from 0, of the part of its body's shape that a slot holds. */
    public int partOf(int slot) {
        return part == null ? 0 : part[slot];
    }

    /** The slot of a part of a body, or {@link Pairs#NONE} if there is no such part. */
    public int shapeOf(int body, int number) {
        int slot = body;
        for (int i = 0; i < number && slot != Pairs.NONE; i++) {
            slot = nextShapeOf(slot);
        }
        return slot;
    }

    /**
     * Whether a body is a single disc centred on its centre of mass, which turning does not change.
     */
    public boolean isCentredDisc(int body) {
        return outline[body].isCentredDisc() && nextShapeOf(body) == Pairs.NONE;
    }

    /** Whether a slot holds a body, not a further shape of one. */
    public boolean isBody(int slot) {
        return type[slot] != null && bodyOf(slot) == slot;
    }

    /** Number of bodies, each counted once, however many shapes it has. */
    public int count() {
        if (owner == null) {
            return slots.inUse();
        }
        int count = 0;
        for (int slot = 0; slot < slots.high; slot++) {
            count += isBody(slot) ? 1 : 0;
        }
        return count;
    }

    /** Makes room for a number of slots. */
    public void reserve(int slotCount) {
        room.reserve(slotCount);
    }

    /** Whether bodies turn: rotation is declared, so all columns of turning exist. */
    public boolean turns() {
        return spin != null;
    }

    /**
     * Angular velocity, rad/s; 0 without rotation. Loops over bodies test {@link #turns} once
     * instead.
     */
    public double spinOf(int slot) {
        return spin == null ? 0 : spin[slot];
    }

    /**
     * Inverse inertia, 1/(kg·m²); 0 for a body that cannot be turned. Loops over bodies test {@link
     * #turns} once instead.
     */
    public double inverseInertiaOf(int slot) {
        return inverseInertia == null ? 0 : inverseInertia[slot];
    }

    /** Whether a body is dynamic. */
    public boolean isDynamic(int slot) {
        return type[slot] == BodyType.DYNAMIC;
    }

    /** Whether a body is kinematic and its velocity is not 0. */
    public boolean isDriven(int slot) {
        return type[slot] == BodyType.KINEMATIC
                && (velocityX[slot] != 0 || velocityY[slot] != 0 || spinOf(slot) != 0)
                && !isDisabled(slot);
    }

    /** Whether a step moves the body: awake and dynamic, or driven. */
    public boolean isMoved(int slot) {
        return isDynamic(slot) ? awake[slot] : isDriven(slot);
    }

    /**
     * Time at which a dynamic body becomes part of a pile, s after the step's start; 0 for a
     * sleeping one, which does not move.
     */
    public double pileTimeOf(int slot) {
        return awake[slot] ? pileTime[slot] : 0;
    }

    /** Sets up a slot that holds a further shape of its body and has no motion of its own. */
    public void standBy(int slot) {
        int body = owner[slot];
        type[slot] = type[body];
        gravityScale[slot] = 0;
        statedMass[slot] = 0;
        statedInertia[slot] = 0;
        awake[slot] = false;
        x[slot] = 0;
        y[slot] = 0;
        angle[slot] = 0;
        mass[slot] = 0;
        inverseMass[slot] = 0;
        halt(slot);
        clearForces(slot);
        clearAccelerations(slot);
        if (turns()) {
            clearAngularAcceleration(slot);
            inertia[slot] = 0;
            inverseInertia[slot] = 0;
        }
        if (firstPair != null) {
            firstPair[slot] = Pairs.NONE;
        }
        restartStillness(slot);
    }

    /** Empties a slot. */
    public void release(int slot) {
        type[slot] = null;
        shape[slot] = null;
        outline[slot] = null;
        material[slot] = null;
        awake[slot] = false;
        slots.giveBack(slot);
    }

    /** Clears the applied forces. */
    public void clearForces(int slot) {
        if (forceX != null) {
            forceX[slot] = 0;
            forceY[slot] = 0;
        }
        if (torque != null) {
            torque[slot] = 0;
        }
    }

    /** Whether a force or a torque is applied. */
    public boolean isThrust(int slot) {
        return forceX != null
                && (forceX[slot] != 0 || forceY[slot] != 0 || torque != null && torque[slot] != 0);
    }

    /** Clears the accelerations of a body's centre of mass. */
    public void clearAccelerations(int slot) {
        accelerationX[slot] = 0;
        accelerationY[slot] = 0;
        if (pullX != null) {
            pullX[slot] = 0;
            pullY[slot] = 0;
        }
    }

    /** Clears a body's angular acceleration; needs rotation. */
    public void clearAngularAcceleration(int slot) {
        angularAcceleration[slot] = 0;
        if (pullTurn != null) {
            pullTurn[slot] = 0;
        }
    }

    /** Whether the rotation of a body is locked. */
    public boolean isRotationLocked(int slot) {
        return rotationLocked != null && rotationLocked[slot];
    }

    /** Whether a body's motion along x is locked. */
    public boolean isLockedInX(int slot) {
        return lockedX != null && lockedX[slot];
    }

    /** Whether a body's motion along y is locked. */
    public boolean isLockedInY(int slot) {
        return lockedY != null && lockedY[slot];
    }

    /** Whether a body's motion along some axis is locked. */
    public boolean isHeldByAxis(int slot) {
        return lockedX != null && (lockedX[slot] || lockedY[slot]);
    }

    /** Clears the components along locked axes of a body's vector, given as two columns. */
    public void holdAxes(int slot, double[] alongX, double[] alongY) {
        if (isLockedInX(slot)) {
            alongX[slot] = 0;
        }
        if (isLockedInY(slot)) {
            alongY[slot] = 0;
        }
    }

    /** Whether a body is disabled: it neither moves nor collides. */
    public boolean isDisabled(int slot) {
        return disabled != null && disabled[slot];
    }

    /** Whether a shape is a sensor, which touches nothing and reports the bodies inside it. */
    public boolean isSensor(int slot) {
        return sensor != null && sensor[slot];
    }

    /** Whether a body is being driven to a target pose. */
    public boolean isSteered(int slot) {
        return driveTime != null && driveTime[slot] > 0;
    }

    /** Whether the groups, categories and masks of two shapes let them collide. */
    public boolean meet(int a, int b) {
        boolean areApart = group[a] != 0 && group[a] == group[b];
        return !areApart
                && (category == null
                        || (category[a] & mask[b]) != 0 && (category[b] & mask[a]) != 0);
    }

    /** Sets a body's angular velocity to 0. */
    public void haltTurning(int slot) {
        if (turns()) {
            spin[slot] = 0;
        }
    }

    /** Sets a body's velocity and angular velocity to 0. */
    public void halt(int slot) {
        velocityX[slot] = 0;
        velocityY[slot] = 0;
        haltTurning(slot);
    }

    /** Turns a body by an angle in rad, counter-clockwise. */
    public void turn(int slot, double radians) {
        angle[slot] += radians;
        aim(slot);
    }

    /** Computes cosine and sine from the angle. */
    public void aim(int slot) {
        cos[slot] = Angle.cos(angle[slot]);
        sin[slot] = Angle.sin(angle[slot]);
    }

    /** Stores the position at the start of the step. */
    public void keepStart(int slot) {
        startX[slot] = x[slot];
        startY[slot] = y[slot];
    }

    /** Stores the angle at the start of the step; needs rotation. */
    public void keepStartAngle(int slot) {
        startAngle[slot] = angle[slot];
    }

    /** Restarts the measurement of how long the body stays where it is. */
    public void restartStillness(int slot) {
        if (stillTime == null) {
            return;
        }
        stillTime[slot] = 0;
        stillX[slot] = x[slot];
        stillY[slot] = y[slot];
        if (stillAngle != null) {
            stillAngle[slot] = angle[slot];
        }
    }

    /** Kinetic energy of translation and rotation, J; 0 unless the body is dynamic. */
    public double kineticEnergy(int slot) {
        if (type[slot] != BodyType.DYNAMIC) {
            return 0;
        }
        double vx = velocityX[slot];
        double vy = velocityY[slot];
        double twiceLinear = mass[slot] * (vx * vx + vy * vy);
        return (turns() ? twiceLinear + inertia[slot] * spin[slot] * spin[slot] : twiceLinear) / 2;
    }

    /**
     * Angular momentum about the centre of mass, kg·m²/s; 0 unless the body is dynamic and rotation
     * is declared.
     */
    public double angularMomentum(int slot) {
        return turns() && isDynamic(slot) ? inertia[slot] * spin[slot] : 0;
    }

    /** The first pair in the list of a body, or {@link Pairs#NONE}. */
    public int firstPairOf(int slot) {
        return firstPair == null ? Pairs.NONE : firstPair[slot];
    }

    /** Names of the columns that exist. */
    public String declaredColumns() {
        return "pose, motion, mass"
                + (turns() ? ", turning" : "")
                + (firstPair == null ? "" : ", fixture, contact")
                + (stillTime == null ? "" : ", stillness")
                + (friction == null ? "" : ", friction")
                + (elasticity == null ? "" : ", elasticity")
                + (forceX == null ? "" : ", force")
                + (rollingResistance == null ? "" : ", rolling resistance")
                + (surfaceSpeed == null ? "" : ", surface speed")
                + (drag == null ? "" : ", drag")
                + (pullX == null ? "" : ", changing forces");
    }

    /**
     * Bits that the columns take for each body; a reference counts, the object behind it does not.
     */
    public int bitsPerBody() {
        return SlotSize.of(this::visitColumns);
    }
}
