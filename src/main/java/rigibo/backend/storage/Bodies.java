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
 * Columns of the bodies, one slot each. A slot whose {@link #type} is null is empty. Whatever is
 * done to every column, {@link BodyColumns} does.
 */
public final class Bodies {

    private static final int FIRST_CAPACITY = 16;

    public final Slots slots = new Slots();

    /** What was stated. */
    public BodyType[] type = new BodyType[FIRST_CAPACITY];

    public Shape[] shape = new Shape[FIRST_CAPACITY];

    /** The shape as collisions see it. */
    public Outline[] outline = new Outline[FIRST_CAPACITY];

    public Material[] material = new Material[FIRST_CAPACITY];
    public int[] group = new int[FIRST_CAPACITY];
    public double[] gravityScale = new double[FIRST_CAPACITY];

    /**
     * kg and kg·m² stated in place of the material's density; 0 where none was. They stay whatever
     * is declared, as all that was stated does: who declares rotation later gets what was stated.
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

    /** Mass in kg and its inverse, 0 for what cannot be moved. */
    public double[] mass = new double[FIRST_CAPACITY];

    public double[] inverseMass = new double[FIRST_CAPACITY];

    /** From the shape: farthest point, m. */
    public double[] boundingRadius = new double[FIRST_CAPACITY];

    /** Whether the body is simulated. */
    public boolean[] awake = new boolean[FIRST_CAPACITY];

    /** Where the step began, m: what a body returns to when its state stops being finite. */
    public double[] startX = new double[FIRST_CAPACITY];

    public double[] startY = new double[FIRST_CAPACITY];

    // From here on columns of declared effects only, else null.

    /** Of rotation: rad/s, what the effects make of it in this step, rad/s², and the start, rad. */
    public double[] spin;

    public double[] angularAcceleration;
    public double[] startAngle;

    /** Inertia in kg·m² and its inverse, 0 for what cannot be turned. */
    public double[] inertia;

    public double[] inverseInertia;

    /** Of contacts, from the shape: smallest width, m. */
    public double[] smallestWidth;

    /** Of contacts and rotation: how far turning moves the outline, m per rad; 0 for a disc. */
    public double[] sweepRadius;

    /** The size fixture, m, and its leaf in the broadphase. */
    public double[] fixtureMinX;

    public double[] fixtureMinY;
    public double[] fixtureMaxX;
    public double[] fixtureMaxY;
    public int[] leaf;

    /** Whether the fixture was laid anew since pairs were last sought. */
    public boolean[] refitted;

    /**
     * Of bodies of more than one shape: the body of each shape's slot, and the slot of its next
     * shape or {@link Pairs#NONE}. A body's own slot is that of its first shape; the others hold a
     * shape, a material and a fixture, and nothing that moves. Null where every body has one shape.
     */
    public int[] owner;

    public int[] nextShape;

    /** Which part of its body's shape a slot holds, from 0. */
    public int[] part;

    /**
     * Of which categories a shape is, one bit each, and which it meets; null where every shape is
     * of the first and meets all.
     */
    public int[] category;

    public int[] mask;

    /** Whether a body is kept from turning; null where none is. */
    public boolean[] rotationLocked;

    /** Whether a body is kept from moving along x or y; null where none is. */
    public boolean[] lockedX;

    public boolean[] lockedY;

    /** Where a body is driven to, m and rad, and in how many s; 0 s where it is not. */
    public double[] driveX;

    public double[] driveY;
    public double[] driveAngle;
    public double[] driveTime;

    /** Whether a body is neither moved nor met by anybody; null where none is. */
    public boolean[] disabled;

    /** Head of the list of the body's pairs; see {@link Pairs}. */
    public int[] firstPair;

    /** Whether the body is part of a pile in this step, and since when, s after its start. */
    public boolean[] piled;

    public double[] pileTime;

    /** Of sleep: for how long (s) the body has stayed by an anchor pose, and which. */
    public double[] stillTime;

    public double[] stillX;
    public double[] stillY;

    /** Of sleep and rotation. */
    public double[] stillAngle;

    /** From the material, so that a loop over contacts reads flat columns. */
    public double[] friction;

    public double[] elasticity;

    /**
     * The normal of a surface that is solid on its side alone, in the body's frame, 0 where it is
     * solid all round; null where no shape is solid on one side alone.
     */
    public double[] oneWayX;

    public double[] oneWayY;

    /** Whether a shape touches nothing and tells who is inside; null where none does. */
    public boolean[] sensor;

    /** N asked for, and N·m where bodies turn. */
    public double[] forceX;

    public double[] forceY;
    public double[] torque;

    /** Rolling lever in m, speed of the outline in m/s, drag in 1/s. */
    public double[] rollingResistance;

    public double[] surfaceSpeed;
    public double[] drag;

    /**
     * Of the accelerations, what forces add that change along the way, m/s², and rad/s² where
     * bodies turn; null where no path is integrated.
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

    /** Shows every column to a visitor, which may put others in their place. */
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

    /** Whether the columns are there that integrated paths need. */
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

    /** Makes columns that a body needs, whatever is declared; for all others they say nothing. */
    public void hold(Need need) {
        if (!asked.contains(need)) {
            ask(need, true);
            declare(effects);
            for (int slot = 0; slot < slots.high; slot++) {
                begin(slot, need);
            }
        }
    }

    /** Whether the columns are there that a body needed, whatever is declared. */
    public boolean holds(Need need) {
        return asked.contains(need);
    }

    /** Whether a body may have more than one shape. */
    public boolean holdsCompounds() {
        return owner != null;
    }

    /** Writes into a slot of columns that a body needed what holds for all others. */
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

    /** A free slot with room in every column, of a body with its first shape. */
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

    /** A slot for one more shape of a body, behind the shape that was its last so far. */
    public int takeShape(int body, int last) {
        int slot = take();
        owner[slot] = body;
        nextShape[last] = slot;
        part[slot] = part[last] + 1;
        return slot;
    }

    /** The slot of the body that a shape's slot belongs to. */
    public int bodyOf(int slot) {
        return owner == null ? slot : owner[slot];
    }

    /** Whether there may be bodies of more than one shape. */
    public boolean mayHaveParts() {
        return owner != null;
    }

    /** The slot of the next shape of the same body, or {@link Pairs#NONE}. */
    public int nextShapeOf(int slot) {
        return owner == null ? Pairs.NONE : nextShape[slot];
    }

    /** Which part of its body's shape a slot holds, from 0. */
    public int partOf(int slot) {
        return part == null ? 0 : part[slot];
    }

    /** The slot of a part of a body, or {@link Pairs#NONE} where it has no such part. */
    public int shapeOf(int body, int number) {
        int slot = body;
        for (int i = 0; i < number && slot != Pairs.NONE; i++) {
            slot = nextShapeOf(slot);
        }
        return slot;
    }

    /** Whether a body is a single disc about its centre of mass: turning changes nothing. */
    public boolean isCentredDisc(int body) {
        return outline[body].isCentredDisc() && nextShapeOf(body) == Pairs.NONE;
    }

    /** Whether a slot is that of a body, not only of one more shape of one. */
    public boolean isBody(int slot) {
        return type[slot] != null && bodyOf(slot) == slot;
    }

    /** How many bodies there are, each once, of however many shapes it is. */
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

    /** Makes room for so many slots. */
    public void reserve(int slotCount) {
        room.reserve(slotCount);
    }

    /** Whether bodies turn: rotation is declared, and all columns of turning are there. */
    public boolean turns() {
        return spin != null;
    }

    /** rad/s; 0 where nothing turns. Whoever reads it for body after body asks {@link #turns}. */
    public double spinOf(int slot) {
        return spin == null ? 0 : spin[slot];
    }

    /** 1/(kg·m²), 0 for what cannot be turned; likewise. */
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
     * When in the step a dynamic body becomes part of a pile, s after its start; 0 for a sleeper,
     * which nothing moves.
     */
    public double pileTimeOf(int slot) {
        return awake[slot] ? pileTime[slot] : 0;
    }

    /** Makes of a slot what holds one more shape of its body, and moves nothing itself. */
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

    /** Forgets the forces asked for. */
    public void clearForces(int slot) {
        if (forceX != null) {
            forceX[slot] = 0;
            forceY[slot] = 0;
        }
        if (torque != null) {
            torque[slot] = 0;
        }
    }

    /** Whether a force or a torque was asked for. */
    public boolean isThrust(int slot) {
        return forceX != null
                && (forceX[slot] != 0 || forceY[slot] != 0 || torque != null && torque[slot] != 0);
    }

    /** Takes all accelerations of the centre of mass from a body. */
    public void clearAccelerations(int slot) {
        accelerationX[slot] = 0;
        accelerationY[slot] = 0;
        if (pullX != null) {
            pullX[slot] = 0;
            pullY[slot] = 0;
        }
    }

    /** Takes the angular acceleration from a body, where bodies turn. */
    public void clearAngularAcceleration(int slot) {
        angularAcceleration[slot] = 0;
        if (pullTurn != null) {
            pullTurn[slot] = 0;
        }
    }

    /** Whether a body is kept from turning. */
    public boolean isRotationLocked(int slot) {
        return rotationLocked != null && rotationLocked[slot];
    }

    /** Whether a body is kept from moving to the left and right. */
    public boolean isLockedInX(int slot) {
        return lockedX != null && lockedX[slot];
    }

    /** Whether a body is kept from moving up and down. */
    public boolean isLockedInY(int slot) {
        return lockedY != null && lockedY[slot];
    }

    /** Whether a body is kept from moving along an axis. */
    public boolean isHeldByAxis(int slot) {
        return lockedX != null && (lockedX[slot] || lockedY[slot]);
    }

    /** Takes from a vector of a body, in two columns, what it has along locked axes. */
    public void holdAxes(int slot, double[] alongX, double[] alongY) {
        if (isLockedInX(slot)) {
            alongX[slot] = 0;
        }
        if (isLockedInY(slot)) {
            alongY[slot] = 0;
        }
    }

    /** Whether a body is neither moved nor met by anybody. */
    public boolean isDisabled(int slot) {
        return disabled != null && disabled[slot];
    }

    /** Whether a shape touches nothing and tells who is inside. */
    public boolean isSensor(int slot) {
        return sensor != null && sensor[slot];
    }

    /** Whether a body is on its way to a place. */
    public boolean isSteered(int slot) {
        return driveTime != null && driveTime[slot] > 0;
    }

    /** Whether two shapes meet, as far as their groups, categories and masks say. */
    public boolean meet(int a, int b) {
        boolean areApart = group[a] != 0 && group[a] == group[b];
        return !areApart
                && (category == null
                        || (category[a] & mask[b]) != 0 && (category[b] & mask[a]) != 0);
    }

    /** Takes all spin from a body. */
    public void haltTurning(int slot) {
        if (turns()) {
            spin[slot] = 0;
        }
    }

    /** Takes all velocity from a body. */
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

    /** Takes cosine and sine from the angle. */
    public void aim(int slot) {
        cos[slot] = Angle.cos(angle[slot]);
        sin[slot] = Angle.sin(angle[slot]);
    }

    /** Remembers the place the step begins with. */
    public void keepStart(int slot) {
        startX[slot] = x[slot];
        startY[slot] = y[slot];
    }

    /** Remembers the angle the step begins with, where bodies turn. */
    public void keepStartAngle(int slot) {
        startAngle[slot] = angle[slot];
    }

    /** Begins to measure anew how long the body stays where it is. */
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

    /** J of motion and rotation; 0 for what is not dynamic. */
    public double kineticEnergy(int slot) {
        if (type[slot] != BodyType.DYNAMIC) {
            return 0;
        }
        double vx = velocityX[slot];
        double vy = velocityY[slot];
        double twiceLinear = mass[slot] * (vx * vx + vy * vy);
        return (turns() ? twiceLinear + inertia[slot] * spin[slot] * spin[slot] : twiceLinear) / 2;
    }

    /** kg·m²/s about the centre of mass; 0 for what is not dynamic, and where nothing turns. */
    public double angularMomentum(int slot) {
        return turns() && isDynamic(slot) ? inertia[slot] * spin[slot] : 0;
    }

    /** The first pair in the list of a body, or {@link Pairs#NONE}. */
    public int firstPairOf(int slot) {
        return firstPair == null ? Pairs.NONE : firstPair[slot];
    }

    /** Names of the columns there are. */
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

    /** How many bits the columns hold for each body; what they refer to is not counted. */
    public int bitsPerBody() {
        return SlotSize.of(this::visitColumns);
    }
}
