package rigibo.backend.setup;

import rigibo.backend.geometry.MassProperties;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;

/**
 * The definition of a body, from which {@code Pool.add} makes one. Immutable: every method that
 * changes something returns a changed copy, so one definition can serve as a pattern for many
 * bodies. Static and kinematic bodies act as if their mass were infinite.
 *
 * <pre>{@code
 * BodyDefinition pattern =
 *         BodyDefinition.dynamic(Polygon.box(1, 1)).material(new Material(700, 0.5, 0.2));
 * for (int i = 0; i < 10; i++) {
 *     pool.add(pattern.at(0, 0.5 + i)); // a stack of ten
 * }
 * }</pre>
 */
public final class BodyDefinition {

    private final BodyType type;
    private final Shape shape;
    private double x;
    private double y;
    private double angle;
    private double velocityX;
    private double velocityY;
    private double spin;
    private Material material = Material.DEFAULT;
    private String name = "";
    private double mass;
    private double inertia;
    private double gravityScale = 1;
    private Filter filter = Filter.ALL;
    private boolean awake = true;
    private boolean rotationLocked;
    private boolean xLocked;
    private boolean yLocked;
    private boolean sensor;

    /** Surface of each part that has its own, null for the others; null if no part has its own. */
    private Material[] surfaces;

    /** Filter of each part that has its own, null for the others; null if no part has its own. */
    private Filter[] filters;

    private BodyDefinition(BodyType type, Shape shape) {
        this.type = type;
        this.shape = Require.present("BodyDefinition.shape", shape);
        requireMovable();
    }

    private BodyDefinition(BodyDefinition pattern) {
        this(pattern, pattern.shape);
    }

    private BodyDefinition(BodyDefinition pattern, Shape shape) {
        type = pattern.type;
        this.shape = shape;
        x = pattern.x;
        y = pattern.y;
        angle = pattern.angle;
        velocityX = pattern.velocityX;
        velocityY = pattern.velocityY;
        spin = pattern.spin;
        material = pattern.material;
        name = pattern.name;
        mass = pattern.mass;
        inertia = pattern.inertia;
        gravityScale = pattern.gravityScale;
        filter = pattern.filter;
        awake = pattern.awake;
        rotationLocked = pattern.rotationLocked;
        xLocked = pattern.xLocked;
        yLocked = pattern.yLocked;
        sensor = pattern.sensor;
        if (shape.parts() == pattern.shape.parts()) {
            surfaces = pattern.surfaces;
            filters = pattern.filters;
        }
        requireMovable();
    }

    private void requireMovable() {
        if (type == BodyType.DYNAMIC && shape.kind() == ShapeKind.CHAIN) {
            throw new IllegalArgumentException(
                    "BodyDefinition.shape must not be a Chain for a dynamic body: it has no mass");
        }
    }

    /**
     * A dynamic body: forces and contacts move it.
     *
     * @throws IllegalArgumentException when the shape is a {@code Chain}, which has no mass
     */
    public static BodyDefinition dynamic(Shape shape) {
        return new BodyDefinition(BodyType.DYNAMIC, shape);
    }

    /** A static body: it never moves. */
    public static BodyDefinition fixed(Shape shape) {
        return new BodyDefinition(BodyType.STATIC, shape);
    }

    /** A kinematic body: it moves with the velocity it is given, whatever it meets. */
    public static BodyDefinition kinematic(Shape shape) {
        return new BodyDefinition(BodyType.KINEMATIC, shape);
    }

    /**
     * A copy with another position of the centre of mass.
     *
     * @param metresX world x, m
     * @param metresY world y, m, up
     */
    public BodyDefinition at(double metresX, double metresY) {
        BodyDefinition next = new BodyDefinition(this);
        next.x = Require.finite("BodyDefinition.x", metresX, "m");
        next.y = Require.finite("BodyDefinition.y", metresY, "m");
        return next;
    }

    /** A copy with another angle in rad, counter-clockwise, within a million turns. */
    public BodyDefinition angle(double radians) {
        BodyDefinition next = new BodyDefinition(this);
        next.angle =
                Require.within("BodyDefinition.angle", radians, -MOST_ANGLE, MOST_ANGLE, "rad");
        return next;
    }

    /**
     * A copy with another velocity of the centre of mass; a static body's must be 0.
     *
     * @param metresPerSecondX m/s, to the right
     * @param metresPerSecondY m/s, up
     * @throws IllegalArgumentException when a component is not within ± the speed of light, or not
     *     0 for a static body
     */
    public BodyDefinition velocity(double metresPerSecondX, double metresPerSecondY) {
        BodyDefinition next = new BodyDefinition(this);
        next.velocityX =
                Require.within(
                        "BodyDefinition.velocityX",
                        metresPerSecondX,
                        -MOST_SPEED,
                        MOST_SPEED,
                        "m/s");
        next.velocityY =
                Require.within(
                        "BodyDefinition.velocityY",
                        metresPerSecondY,
                        -MOST_SPEED,
                        MOST_SPEED,
                        "m/s");
        next.requireStill("velocity", metresPerSecondX != 0 || metresPerSecondY != 0);
        return next;
    }

    /**
     * A copy with another angular velocity in rad/s, counter-clockwise; a static body's must be 0.
     * It is ignored where the effect {@code Rotation} is not declared.
     */
    public BodyDefinition spin(double radiansPerSecond) {
        BodyDefinition next = new BodyDefinition(this);
        next.spin =
                Require.within(
                        "BodyDefinition.spin", radiansPerSecond, -MOST_SPIN, MOST_SPIN, "rad/s");
        next.requireStill("spin", radiansPerSecond != 0);
        return next;
    }

    /**
     * A copy with another shape. If it has the same number of parts, the parts' own materials and
     * filters are kept.
     */
    public BodyDefinition shape(Shape other) {
        return new BodyDefinition(this, Require.present("BodyDefinition.shape", other));
    }

    /** A copy with another material. */
    public BodyDefinition material(Material substance) {
        BodyDefinition next = new BodyDefinition(this);
        next.material = Require.present("BodyDefinition.material", substance);
        return next;
    }

    /** A copy with a name for messages and levels, which may be empty and need not be unique. */
    public BodyDefinition name(String words) {
        BodyDefinition next = new BodyDefinition(this);
        next.name = Require.present("BodyDefinition.name", words);
        return next;
    }

    /**
     * A copy with a mass in kg, positive, in place of density times area; the moment of inertia
     * scales with it unless it is set too.
     */
    public BodyDefinition mass(double kilograms) {
        BodyDefinition next = new BodyDefinition(this);
        next.mass = Require.positive("BodyDefinition.mass", kilograms, "kg");
        return next;
    }

    /**
     * A copy with a moment of inertia about the centre of mass in kg·m², positive, in place of the
     * shape's.
     */
    public BodyDefinition inertia(double kilogramSquareMetres) {
        BodyDefinition next = new BodyDefinition(this);
        next.inertia = Require.positive("BodyDefinition.inertia", kilogramSquareMetres, "kg·m²");
        return next;
    }

    /** A copy with a factor on gravity, within ±1e6: with 0 the body floats, with -1 it rises. */
    public BodyDefinition gravityScale(double factor) {
        BodyDefinition next = new BodyDefinition(this);
        next.gravityScale =
                Require.within(
                        "BodyDefinition.gravityScale",
                        factor,
                        -MOST_GRAVITY_SCALE,
                        MOST_GRAVITY_SCALE,
                        "no unit");
        return next;
    }

    /**
     * A copy with another surface material of one part: its friction, elasticity, rolling
     * resistance, surface speed and one-way normal. Density and drag are the body's; the relative
     * density of a part is set where the compound is made.
     *
     * @param part index of the part, from 0
     * @throws IllegalArgumentException when the shape has no such part
     */
    public BodyDefinition material(int part, Material surface) {
        requirePart("material", part);
        Require.present("BodyDefinition.material", surface);
        BodyDefinition next = new BodyDefinition(this);
        next.surfaces = surfaces == null ? new Material[shape.parts()] : surfaces.clone();
        next.surfaces[part] = surface;
        return next;
    }

    /** A copy with another collision filter. */
    public BodyDefinition filter(Filter whom) {
        BodyDefinition next = new BodyDefinition(this);
        next.filter = Require.present("BodyDefinition.filter", whom);
        return next;
    }

    /**
     * A copy with another collision filter of one part.
     *
     * @param part index of the part, from 0
     * @throws IllegalArgumentException when the shape has no such part
     */
    public BodyDefinition filter(int part, Filter whom) {
        requirePart("filter", part);
        Require.present("BodyDefinition.filter", whom);
        BodyDefinition next = new BodyDefinition(this);
        next.filters = filters == null ? new Filter[shape.parts()] : filters.clone();
        next.filters[part] = whom;
        return next;
    }

    private void requirePart(String verb, int part) {
        Require.within("BodyDefinition." + verb + " part", part, 0, shape.parts() - 1);
    }

    /** A copy in another group: bodies of the same group, other than 0, never collide. */
    public BodyDefinition group(int number) {
        return filter(filter.group(number));
    }

    /** A copy with locked rotation, whatever acts on the body: for a player or a lift. */
    public BodyDefinition lockRotation() {
        BodyDefinition next = new BodyDefinition(this);
        next.rotationLocked = true;
        return next;
    }

    /**
     * A copy whose centre of mass is locked in x, whatever acts on it: for a piston or a float in a
     * pipe. Its velocity along x is 0 whatever is set, and along x it has infinite mass. A
     * kinematic body does not move along x either; for a static body the lock matters only once its
     * type changes.
     *
     * <pre>{@code
     * pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).lockX().lockRotation()); // slides up, down
     * }</pre>
     */
    public BodyDefinition lockX() {
        BodyDefinition next = new BodyDefinition(this);
        next.xLocked = true;
        return next;
    }

    /** A copy locked in y, as {@link #lockX} does in x: for a trolley or a bead. */
    public BodyDefinition lockY() {
        BodyDefinition next = new BodyDefinition(this);
        next.yLocked = true;
        return next;
    }

    /**
     * A copy that is a sensor as a whole: it touches nothing and reports which bodies are inside.
     * The pool it is added to must declare {@code Sensors}. A dynamic sensor must have its mass
     * set.
     */
    public BodyDefinition sensor() {
        BodyDefinition next = new BodyDefinition(this);
        next.sensor = true;
        return next;
    }

    /** Whether the whole body is a sensor. */
    public boolean isSensor() {
        return sensor;
    }

    /** A copy that starts awake, or asleep until it is touched. */
    public BodyDefinition awake(boolean isAwake) {
        BodyDefinition next = new BodyDefinition(this);
        next.awake = isAwake;
        return next;
    }

    /** Whether the body is dynamic, static or kinematic. */
    public BodyType type() {
        return type;
    }

    /** The shape; its centre of mass lies at (x, y). */
    public Shape shape() {
        return shape;
    }

    /** World x of the centre of mass, m. */
    public double x() {
        return x;
    }

    /** World y of the centre of mass, m, up. */
    public double y() {
        return y;
    }

    /** Angle in rad, counter-clockwise. */
    public double angle() {
        return angle;
    }

    /** Velocity of the centre of mass to the right, m/s. */
    public double velocityX() {
        return velocityX;
    }

    /** Velocity of the centre of mass upwards, m/s. */
    public double velocityY() {
        return velocityY;
    }

    /** Angular velocity in rad/s, counter-clockwise. */
    public double spin() {
        return spin;
    }

    /** The material of the body: {@link Material#DEFAULT} unless another was set. */
    public Material material() {
        return material;
    }

    /** The name; empty unless one was set. */
    public String name() {
        return name;
    }

    /** Mass in kg: as set, otherwise density times area. */
    public double mass() {
        return massProperties().mass();
    }

    /**
     * Moment of inertia about the centre of mass in kg·m²: as set, otherwise the shape's at this
     * mass.
     */
    public double inertia() {
        return massProperties().inertia();
    }

    /** Whether a mass was set in place of the material's density. */
    public boolean statesMass() {
        return mass > 0;
    }

    /** Whether a moment of inertia was set in place of the shape's. */
    public boolean statesInertia() {
        return inertia > 0;
    }

    /** Factor on the declared gravity. */
    public double gravityScale() {
        return gravityScale;
    }

    /** The surface material of a part: the body's material unless another was set for the part. */
    public Material material(int part) {
        requirePart("material", part);
        return surfaces == null || surfaces[part] == null ? material : surfaces[part];
    }

    /** The collision filter of the body: {@link Filter#ALL} unless another was set. */
    public Filter filter() {
        return filter;
    }

    /** The collision filter of a part: the body's unless another was set for the part. */
    public Filter filter(int part) {
        requirePart("filter", part);
        return filters == null || filters[part] == null ? filter : filters[part];
    }

    /** The group of the body's filter; 0 for none. */
    public int group() {
        return filter.group();
    }

    /** Whether the rotation of the body is locked. */
    public boolean rotationLocked() {
        return rotationLocked;
    }

    /** Whether the centre of mass is locked in x. */
    public boolean xLocked() {
        return xLocked;
    }

    /** Whether the centre of mass is locked in y. */
    public boolean yLocked() {
        return yLocked;
    }

    /** Whether the body starts awake. */
    public boolean awake() {
        return awake;
    }

    /**
     * Mass in kg and moment of inertia in kg·m² about the centre of mass.
     *
     * @throws IllegalArgumentException when one is outside 1e-100 to 1e100, or a dynamic sensor has
     *     no mass set
     */
    public MassProperties massProperties() {
        if (shape.kind() == ShapeKind.CHAIN) {
            return new MassProperties(mass, inertia, 0, 0);
        }
        if (sensor && type == BodyType.DYNAMIC && mass == 0) {
            throw new IllegalArgumentException(
                    "BodyDefinition.mass must be stated (kg) for a dynamic sensor");
        }
        MassProperties plate = shape.massProperties(material.density());
        double kilograms = mass > 0 ? mass : plate.mass();
        double aboutCentre = inertia > 0 ? inertia : plate.inertia() * (kilograms / plate.mass());
        String field = "BodyDefinition.mass, stated or from density and area,";
        Require.within(field, kilograms, LEAST_MASS, MOST_MASS, "kg");
        field = "BodyDefinition.inertia, stated or from mass and shape,";
        Require.within(field, aboutCentre, LEAST_MASS, MOST_MASS, "kg·m²");
        return new MassProperties(kilograms, aboutCentre, 0, 0);
    }

    /** Highest speed accepted, m/s: that of light. Squares of much higher speeds would overflow. */
    public static final double MOST_SPEED = 299_792_458;

    /**
     * Least mass in kg and moment of inertia in kg·m² accepted: squares and inverses stay finite.
     */
    public static final double LEAST_MASS = 1e-100;

    /** Greatest mass in kg and moment of inertia in kg·m² accepted: squares stay finite. */
    public static final double MOST_MASS = 1e100;

    /** Highest spin accepted, rad/s. */
    public static final double MOST_SPIN = 1e6;

    /** Largest angle accepted, rad: a million turns, where doubles still resolve a nanoradian. */
    public static final double MOST_ANGLE = 2 * Math.PI * 1e6;

    /** Largest factor on gravity accepted. */
    public static final double MOST_GRAVITY_SCALE = 1e6;

    private void requireStill(String field, boolean moves) {
        if (moves && type == BodyType.STATIC) {
            throw new IllegalArgumentException(
                    "BodyDefinition." + field + " must be 0 for a static body");
        }
    }
}
