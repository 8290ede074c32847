package rigibo.backend.geometry;

/**
 * Mass properties of a rounded polygon: the sharp polygon, a strip along each edge and a sector of
 * a disc at each corner, combined by Steiner's theorem.
 */
final class RoundedMass {

    private double mass;
    private double momentX;
    private double momentY;

    /** Second moment of area about the core's centroid, m⁴. */
    private double polar;

    private RoundedMass() {}

    /**
     * Adds the rounding to a polygon with a density of 1 kg/m².
     *
     * @param core mass, inertia and centroid of the polygon
     * @param xy its corners, m, counter-clockwise
     * @param radius of the rounding, m, positive
     */
    static MassProperties around(MassProperties core, double[] xy, double radius) {
        RoundedMass sum = new RoundedMass();
        // Positions are relative to the core's centroid; far from the origin they would lose
        // digits.
        sum.add(core.mass(), 0, 0, core.inertia());
        int count = xy.length / 2;
        for (int i = 0; i < count; i++) {
            int before = (i + count - 1) % count;
            int next = (i + 1) % count;
            double x = xy[2 * i] - core.centroidX();
            double y = xy[2 * i + 1] - core.centroidY();
            double inX = xy[2 * i] - xy[2 * before];
            double inY = xy[2 * i + 1] - xy[2 * before + 1];
            double outX = xy[2 * next] - xy[2 * i];
            double outY = xy[2 * next + 1] - xy[2 * i + 1];
            sum.addStrip(x, y, outX, outY, radius);
            sum.addSector(x, y, inX, inY, outX, outY, radius);
        }
        double offX = sum.momentX / sum.mass;
        double offY = sum.momentY / sum.mass;
        return new MassProperties(
                sum.mass,
                sum.polar - sum.mass * (offX * offX + offY * offY),
                core.centroidX() + offX,
                core.centroidY() + offY);
    }

    private void add(double area, double x, double y, double own) {
        mass += area;
        momentX += area * x;
        momentY += area * y;
        polar += own + area * (x * x + y * y);
    }

    /** Adds the rectangle along an edge: the edge's length times the radius. */
    private void addStrip(double x, double y, double ex, double ey, double radius) {
        double length = Math.sqrt(ex * ex + ey * ey);
        double out = radius / (2 * length);
        double area = length * radius;
        add(
                area,
                x + ex / 2 + out * ey,
                y + ey / 2 - out * ex,
                area * (length * length + radius * radius) / 12);
    }

    /**
     * Adds the sector between the normals of two edges that meet at an angle φ: its area is φr²/2,
     * its centroid lies 4r·sin(φ/2)/(3φ) from the corner, its second moment about the corner is
     * φr⁴/4.
     */
    private void addSector(
            double x, double y, double inX, double inY, double outX, double outY, double radius) {
        double phi = Angle.atan2(inX * outY - inY * outX, inX * outX + inY * outY);
        double inLength = Math.sqrt(inX * inX + inY * inY);
        double outLength = Math.sqrt(outX * outX + outY * outY);
        double alongX = inY / inLength + outY / outLength;
        double alongY = -(inX / inLength + outX / outLength);
        double length = Math.sqrt(alongX * alongX + alongY * alongY);
        double far = 4 * radius * Angle.sin(phi / 2) / (3 * phi);
        double area = phi * radius * radius / 2;
        add(
                area,
                x + far * alongX / length,
                y + far * alongY / length,
                area * (radius * radius / 2 - far * far));
    }
}
