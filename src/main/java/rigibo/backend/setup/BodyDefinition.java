package rigibo.backend.setup;

import rigibo.backend.geometry.MassProperties;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;

/**
 * A body as its creator states it. Immutable: every verb returns another definition, so one may be
 * the pattern for many. Static and kinematic bodies have no mass: nothing moves them.
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

    /** Of the parts of a compound that have their own; null elsewhere, or where none has. */
    private Material[] surfaces;

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
     * A body that forces and contacts move.
     *
     * @throws IllegalArgumentException when the shape is a {@code Chain}, which has no mass
     */
    public static BodyDefinition dynamic(Shape shape) {
        return new BodyDefinition(BodyType.DYNAMIC, shape);
    }

    /** A body that never moves. */
    public static BodyDefinition fixed(Shape shape) {
        return new BodyDefinition(BodyType.STATIC, shape);
    }

    /** A body that moves with the velocity it is given and is never pushed. */
    public static BodyDefinition kinematic(Shape shape) {
        return new BodyDefinition(BodyType.KINEMATIC, shape);
    }

    /**
     * Where the centre of mass is.
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

    /**
     * The angle in rad, counter-clockwise; at most a million turns, where doubles resolve 1 nrad.
     */
    public BodyDefinition angle(double radians) {
        BodyDefinition next = new BodyDefinition(this);
        next.angle =
                Require.within("BodyDefinition.angle", radians, -MOST_ANGLE, MOST_ANGLE, "rad");
        return next;
    }

    /**
     * Velocity of the centre of mass; a static body's must be 0.
     *
     * @param metresPerSecondX m/s
     * @param metresPerSecondY m/s, up
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
     * Angular velocity in rad/s, counter-clockwise; a static body's must be 0. It is passed over
     * where the effect {@code Rotation} is not declared.
     */
    public BodyDefinition spin(double radiansPerSecond) {
        BodyDefinition next = new BodyDefinition(this);
        next.spin =
                Require.within(
                        "BodyDefinition.spin", radiansPerSecond, -MOST_SPIN, MOST_SPIN, "rad/s");
        next.requireStill("spin", radiansPerSecond != 0);
        return next;
    }

    /** The same body with another shape; one of as many parts keeps what they have of their own. */
    public BodyDefinition shape(Shape other) {
        return new BodyDefinition(this, Require.present("BodyDefinition.shape", other));
    }

    /** What the body is made of. */
    public BodyDefinition material(Material substance) {
        BodyDefinition next = new BodyDefinition(this);
        next.material = Require.present("BodyDefinition.material", substance);
        return next;
    }

    /** A name for messages and levels; may be empty, need not be unique. */
    public BodyDefinition name(String words) {
        BodyDefinition next = new BodyDefinition(this);
        next.name = Require.present("BodyDefinition.name", words);
        return next;
    }

    /** A mass in kg in place of density times area, positive; the inertia scales with it. */
    public BodyDefinition mass(double kilograms) {
        BodyDefinition next = new BodyDefinition(this);
        next.mass = Require.positive("BodyDefinition.mass", kilograms, "kg");
        return next;
    }

    /** An inertia in kg·m² about the centre of mass in place of the shape's, positive. */
    public BodyDefinition inertia(double kilogramSquareMetres) {
        BodyDefinition next = new BodyDefinition(this);
        next.inertia = Require.positive("BodyDefinition.inertia", kilogramSquareMetres, "kg·m²");
        return next;
    }

    /** A factor on the declared gravity: 0 floats, -1 rises. */
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
     * What the surface of one part is made of: its friction, elasticity, rolling resistance and
     * surface speed. Density and drag are those of the body; what a part weighs, its own relative
     * density says.
     *
     * @param part from 0
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

    /** Whom the body meets. */
    public BodyDefinition filter(Filter whom) {
        BodyDefinition next = new BodyDefinition(this);
        next.filter = Require.present("BodyDefinition.filter", whom);
        return next;
    }

    /**
     * Whom one part meets.
     *
     * @param part from 0
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

    /** Bodies of the same group other than 0 never meet each other; their filter's group. */
    public BodyDefinition group(int number) {
        return filter(filter.group(number));
    }

    /** Keeps the body from turning, whatever pushes it: a player, a lift. */
    public BodyDefinition lockRotation() {
        BodyDefinition next = new BodyDefinition(this);
        next.rotationLocked = true;
        return next;
    }

    /**
     * Keeps the body's centre of mass from moving to the left and right, whatever pushes it: a
     * piston, a float in a pipe. Its velocity along x is 0, whatever is stated; along x it is as
     * heavy as the ground. Of a static body that says nothing until its type changes; a kinematic
     * one does not move along x either.
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

    /** Keeps the body's centre of mass from moving up and down likewise: a trolley, a bead. */
    public BodyDefinition lockY() {
        BodyDefinition next = new BodyDefinition(this);
        next.yLocked = true;
        return next;
    }

    /**
     * Makes the whole body a sensor, which touches nothing and tells who is inside. {@code Sensors}
     * have to be declared where it is added, and a dynamic one has to state its mass.
     */
    public BodyDefinition sensor() {
        BodyDefinition next = new BodyDefinition(this);
        next.sensor = true;
        return next;
    }

    /** Whether the whole body touches nothing and tells who is inside. */
    public boolean isSensor() {
        return sensor;
    }

    /** Whether the body starts awake; one that starts asleep waits for a touch. */
    public BodyDefinition awake(boolean isAwake) {
        BodyDefinition next = new BodyDefinition(this);
        next.awake = isAwake;
        return next;
    }

    /** What may move the body. */
    public BodyType type() {
        return type;
    }

    /** The shape, whose centre of mass is at (x, y). */
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

    /** rad, counter-clockwise. */
    public double angle() {
        return angle;
    }

    /** m/s. */
    public double velocityX() {
        return velocityX;
    }

    /** m/s, up. */
    public double velocityY() {
        return velocityY;
    }

    /** rad/s, counter-clockwise. */
    public double spin() {
        return spin;
    }

    /** {@link Material#DEFAULT} unless another was stated. */
    public Material material() {
        return material;
    }

    /** Empty unless one was stated. */
    public String name() {
        return name;
    }

    /** kg: the mass stated, else density times area. */
    public double mass() {
        return massProperties().mass();
    }

    /** kg·m² about the centre of mass: the inertia stated, else the shape's at this mass. */
    public double inertia() {
        return massProperties().inertia();
    }

    /** Whether a mass was stated in place of the material's density. */
    public boolean statesMass() {
        return mass > 0;
    }

    /** Whether an inertia was stated in place of the shape's. */
    public boolean statesInertia() {
        return inertia > 0;
    }

    /** Factor on the declared gravity. */
    public double gravityScale() {
        return gravityScale;
    }

    /** What the surface of a part is made of: the body's material unless another was stated. */
    public Material material(int part) {
        requirePart("material", part);
        return surfaces == null || surfaces[part] == null ? material : surfaces[part];
    }

    /** Whom the body meets: {@link Filter#ALL} unless another was stated. */
    public Filter filter() {
        return filter;
    }

    /** Whom a part meets: as the body unless another was stated. */
    public Filter filter(int part) {
        requirePart("filter", part);
        return filters == null || filters[part] == null ? filter : filters[part];
    }

    /** Group of the body's filter, 0 for none. */
    public int group() {
        return filter.group();
    }

    /** Whether the body is kept from turning. */
    public boolean rotationLocked() {
        return rotationLocked;
    }

    /** Whether the body is kept from moving to the left and right. */
    public boolean xLocked() {
        return xLocked;
    }

    /** Whether the body is kept from moving up and down. */
    public boolean yLocked() {
        return yLocked;
    }

    /** Whether the body begins awake. */
    public boolean awake() {
        return awake;
    }

    /**
     * Mass and inertia together.
     *
     * @throws IllegalArgumentException when density and size give no positive, finite number
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

    /** Highest speed accepted, m/s: light's. Beyond it squares of speeds soon overflow. */
    public static final double MOST_SPEED = 299_792_458;

    /**
     * Least and greatest mass in kg and inertia in kg·m²: their squares and inverses are finite.
     */
    public static final double LEAST_MASS = 1e-100;

    /** The greatest. */
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
