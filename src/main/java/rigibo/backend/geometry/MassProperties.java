package rigibo.backend.geometry;

/**
 * Mass, moment of inertia and centroid of a rigid plate; all 0 for a shape without mass.
 *
 * <pre>{@code
 * MassProperties plate = Polygon.box(2, 1).massProperties(10); // 20 kg
 * }</pre>
 *
 * @param mass kg, positive
 * @param inertia about the centroid, kg·m², positive
 * @param centroidX m, in the frame the points were given in
 * @param centroidY m, in the frame the points were given in
 */
public record MassProperties(double mass, double inertia, double centroidX, double centroidY) {

    /**
     * Mass properties of a polygonal plate, by the shoelace sums over triangles (p₀, pᵢ, pᵢ₊₁):
     * area Σ½cross, centroid Σ(area·(a+b)/3), second moment Σ(cross/12)(a·a + a·b + b·b), about p₀
     * and then moved to the centroid by Steiner's theorem. Summing about p₀ instead of the frame's
     * origin keeps full precision for a small polygon far from the origin.
     *
     * @param density kg/m², positive
     * @param xy corner coordinates x₀, y₀, x₁, … in m, counter-clockwise
     */
    static MassProperties ofPolygon(double density, double... xy) {
        double x0 = xy[0];
        double y0 = xy[1];
        double twiceArea = 0;
        double momentX = 0;
        double momentY = 0;
        double polar = 0;
        for (int i = 2; i + 3 < xy.length; i += 2) {
            double ax = xy[i] - x0;
            double ay = xy[i + 1] - y0;
            double bx = xy[i + 2] - x0;
            double by = xy[i + 3] - y0;
            double cross = ax * by - ay * bx;
            twiceArea += cross;
            momentX += cross * (ax + bx);
            momentY += cross * (ay + by);
            polar += cross * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by);
        }
        double area = twiceArea / 2;
        double cx = momentX / (6 * area);
        double cy = momentY / (6 * area);
        double inertia = density * (polar / 12 - area * (cx * cx + cy * cy));
        return new MassProperties(density * area, inertia, x0 + cx, y0 + cy);
    }
}
