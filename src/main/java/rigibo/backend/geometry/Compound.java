package rigibo.backend.geometry;

import java.util.Arrays;
import java.util.List;

/**
 * One rigid body of 1 to 256 convex shapes: a hammer, a cup, an L. Its parts never collide with
 * each other. The parts are stated in a frame of the caller's choice; the centre of mass, which is
 * the body's position, lies at {@link #centroidX}, {@link #centroidY} of that frame. Where parts
 * overlap, their masses add up.
 *
 * <pre>{@code
 * Compound hammer =
 *         Compound.of(
 *                 Part.of(Polygon.box(0.08, 1)),
 *                 Part.of(Polygon.box(0.5, 0.2)).at(0, 0.5).relativeDensity(8));
 * pool.add(BodyDefinition.dynamic(hammer).at(0, 3));
 * }</pre>
 */
public final class Compound implements Shape {

    /** Most parts of a compound. */
    public static final int MAX_PARTS = 256;

    private final List<Part> parts;
    private final Outline[] outlines;
    private final MassProperties plate;
    private final double area;
    private final boolean statesCentre;
    private final double boundingRadius;
    private final double smallestWidth;

    private Compound(List<Part> parts, MassProperties plate, boolean statesCentre) {
        this.parts = parts;
        this.plate = plate;
        this.statesCentre = statesCentre;
        outlines =
                parts.stream()
                        .map(part -> part.outlineFrom(plate.centroidX(), plate.centroidY()))
                        .toArray(Outline[]::new);
        InnerEdges.note(parts, outlines);
        double reach = 0;
        double narrowest = Double.POSITIVE_INFINITY;
        double covered = 0;
        for (int i = 0; i < outlines.length; i++) {
            reach = Math.max(reach, outlines[i].boundingRadius());
            if (!parts.get(i).isSensor()) {
                narrowest = Math.min(narrowest, outlines[i].openWidth());
            }
            covered += parts.get(i).shape().area();
        }
        boundingRadius = reach;
        smallestWidth = narrowest;
        area = covered;
    }

    /**
     * A compound of these parts.
     *
     * @throws IllegalArgumentException when there are none or more than 256, one is null, or they
     *     weigh nothing
     */
    public static Compound of(Part... parts) {
        PolygonCheck.requirePresent("Compound.of parts", parts);
        return of(Arrays.asList(parts));
    }

    /**
     * A compound of these parts.
     *
     * @throws IllegalArgumentException when there are none or more than 256, one is null, or they
     *     weigh nothing
     */
    public static Compound of(List<Part> parts) {
        PolygonCheck.requirePresent("Compound.of parts", parts);
        for (int i = 0; i < parts.size(); i++) {
            PolygonCheck.requirePresent("Compound.of part " + i, parts.get(i));
        }
        if (parts.isEmpty() || parts.size() > MAX_PARTS) {
            throw new IllegalArgumentException(
                    "Compound.of takes 1 to " + MAX_PARTS + " parts, was " + parts.size());
        }
        return new Compound(List.copyOf(parts), massOf(parts), false);
    }

    /**
     * A simple polygon, convex or not, cut into convex pieces.
     *
     * <pre>{@code
     * Compound star = Compound.ofOutline(0, 1, -0.3, 0.3, -1, 0.2, 0, -1, 1, 0.2, 0.3, 0.3);
     * }</pre>
     *
     * @param xy corner coordinates x₀, y₀, x₁, y₁, … in m, counter-clockwise, 3 to 256 corners
     * @throws IllegalArgumentException naming the corner that is repeated or not finite, or the
     *     edges that cross
     */
    public static Compound ofOutline(double... xy) {
        return of(
                Decomposition.of(xy).stream()
                        .map(piece -> Part.of(piece).at(piece.centroidX(), piece.centroidY()))
                        .toList());
    }

    /**
     * Returns this compound with its centre of mass at a stated point, such as below the middle of
     * a tumbler that rights itself. The inertia about the new centre follows from that of the parts
     * by Steiner's theorem.
     *
     * @param x in the frame the parts were stated in, m, finite
     * @param y in the frame the parts were stated in, m, finite
     * @throws IllegalArgumentException when a coordinate is not finite
     */
    public Compound centredAt(double x, double y) {
        if (!(Math.abs(x) + Math.abs(y) < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Compound.centredAt must be finite (m), was (" + x + ", " + y + ")");
        }
        MassProperties natural = massOf(parts);
        double dx = x - natural.centroidX();
        double dy = y - natural.centroidY();
        double inertia = natural.inertia() + natural.mass() * (dx * dx + dy * dy);
        return new Compound(parts, new MassProperties(natural.mass(), inertia, x, y), true);
    }

    /**
     * Sums the parts by Steiner's theorem, about the first part, since all may be far from the
     * frame's origin.
     */
    private static MassProperties massOf(List<Part> parts) {
        double fromX = parts.get(0).x();
        double fromY = parts.get(0).y();
        double mass = 0;
        double momentX = 0;
        double momentY = 0;
        double polar = 0;
        for (Part part : parts) {
            if (part.relativeDensity() > 0) {
                MassProperties plate = part.shape().massProperties(part.relativeDensity());
                double x = part.x() - fromX;
                double y = part.y() - fromY;
                mass += plate.mass();
                momentX += plate.mass() * x;
                momentY += plate.mass() * y;
                polar += plate.inertia() + plate.mass() * (x * x + y * y);
            }
        }
        double x = momentX / mass;
        double y = momentY / mass;
        double inertia = polar - mass * (x * x + y * y);
        if (!(mass > 0 && inertia > 0 && inertia < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Compound.of must have a positive, finite mass and inertia for a density of"
                            + " 1 kg/m², had "
                            + mass
                            + " kg and "
                            + inertia
                            + " kg·m²");
        }
        return new MassProperties(mass, inertia, fromX + x, fromY + y);
    }

    /** A part as the caller stated it. */
    public Part part(int i) {
        return parts.get(i);
    }

    /** The centre of mass in the frame the parts were stated in, m. */
    public double centroidX() {
        return plate.centroidX();
    }

    /** The centre of mass in the frame the parts were stated in, m. */
    public double centroidY() {
        return plate.centroidY();
    }

    @Override
    public double originX() {
        return 0 - plate.centroidX();
    }

    @Override
    public double originY() {
        return 0 - plate.centroidY();
    }

    /** Whether the caller stated the centre of mass. */
    public boolean statesCentre() {
        return statesCentre;
    }

    @Override
    public int parts() {
        return outlines.length;
    }

    @Override
    public boolean isSensor(int part) {
        return parts.get(part).isSensor();
    }

    @Override
    public Outline outline(int part) {
        return outlines[part];
    }

    @Override
    public ShapeKind kind() {
        return ShapeKind.COMPOUND;
    }

    /** Area in m² of all parts; an overlap of two parts counts twice. */
    @Override
    public double area() {
        return area;
    }

    @Override
    public MassProperties massProperties(double density) {
        Polygon.requireDensity(density);
        return new MassProperties(density * plate.mass(), density * plate.inertia(), 0, 0);
    }

    @Override
    public double boundingRadius() {
        return boundingRadius;
    }

    /**
     * The smallest width in m at any part that is not a sensor; where two parts meet, the shape
     * goes on.
     */
    @Override
    public double smallestWidth() {
        return smallestWidth;
    }

    @Override
    public void bounds(double x, double y, double cos, double sin, Aabb out) {
        Outline.bounds(outlines, x, y, cos, sin, out);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Compound compound
                && parts.equals(compound.parts)
                && plate.equals(compound.plate);
    }

    @Override
    public int hashCode() {
        return parts.hashCode();
    }

    @Override
    public String toString() {
        return "Compound" + parts;
    }
}
