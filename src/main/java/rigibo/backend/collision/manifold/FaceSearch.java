package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;

/**
 * Finds the face of a polygon with the greatest separation from another polygon, or the least
 * overlap (separating axis theorem; S. Gottschalk, Separating Axis Theorem, 1996).
 */
final class FaceSearch {

    /**
     * Cosine above which a face looks against a direction: half a right angle, between two faces.
     */
    private static final double AGAINST = Math.sqrt(0.5);

    /** The face found, its separation in m, and the corner of the other polygon nearest to it. */
    int face;

    double separation;
    int corner;

    /**
     * Searches all faces. Returns true, without a result, as soon as a separation exceeds {@code
     * reach} m; the other polygon's pose is in the frame of this one. It skips a face whose
     * separation, even with the other polygon's inner radius for its extent, would not exceed the
     * best one. The nearest corner walks around the other polygon as the face walks around this one
     * (rotating calipers).
     */
    boolean isApart(Outline polygon, Outline other, Pose place, double reach) {
        int nearest = 0;
        face = 0;
        corner = 0;
        separation = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < polygon.corners(); i++) {
            double nx = polygon.normalX(i);
            double ny = polygon.normalY(i);
            double front =
                    nx * (place.x - polygon.cornerX(i)) + ny * (place.y - polygon.cornerY(i));
            if (front - other.innerRadius() <= separation) {
                continue;
            }
            double x = place.cos * nx + place.sin * ny;
            double y = place.cos * ny - place.sin * nx;
            nearest = nearestTo(other, x, y, nearest);
            double gap = front + (x * other.cornerX(nearest) + y * other.cornerY(nearest));
            if (gap > separation) {
                if (gap > reach) {
                    return true;
                }
                separation = gap;
                face = i;
                corner = nearest;
            }
        }
        return false;
    }

    /**
     * Finds the face of greatest separation among those through which the other polygon can leave:
     * no other part covers the face, nor the last face of the other polygon to leave through it.
     * Returns that separation, −∞ if there is none. Of nearly equal faces, it takes the one whose
     * normal is nearest to a direction: {@code weight} m are added along it.
     */
    double findOuter(
            Outline polygon, Outline other, Pose place, double x, double y, double weight) {
        double best = Double.NEGATIVE_INFINITY;
        int nearest = 0;
        for (int i = 0; i < polygon.edges(); i++) {
            double nx = polygon.normalX(i);
            double ny = polygon.normalY(i);
            double localX = place.cos * nx + place.sin * ny;
            double localY = place.cos * ny - place.sin * nx;
            if (polygon.isInner(i) || isLastInner(other, localX, localY)) {
                continue;
            }
            nearest = nearestTo(other, localX, localY, nearest);
            double gap =
                    nx * (place.x - polygon.cornerX(i))
                            + ny * (place.y - polygon.cornerY(i))
                            + (localX * other.cornerX(nearest) + localY * other.cornerY(nearest));
            if (gap + weight * (x * nx + y * ny) > best) {
                best = gap + weight * (x * nx + y * ny);
                separation = gap;
                face = i;
                corner = nearest;
            }
        }
        return best;
    }

    /**
     * Whether another part covers the face that looks against a direction in the polygon's frame.
     */
    private static boolean isLastInner(Outline polygon, double x, double y) {
        boolean isInner = false;
        for (int i = 0; polygon.hasInner() && i < polygon.edges(); i++) {
            double along = x * polygon.normalX(i) + y * polygon.normalY(i);
            isInner |= polygon.isInner(i) && along < -AGAINST;
        }
        return isInner;
    }

    /**
     * Whether the corner found lies over the face found, at least {@code inside} m from both of its
     * ends.
     */
    boolean isOverFace(Outline polygon, Outline other, Pose place, double inside) {
        double x = place.x + place.cos * other.cornerX(corner) - place.sin * other.cornerY(corner);
        double y = place.y + place.sin * other.cornerX(corner) + place.cos * other.cornerY(corner);
        double nx = polygon.normalX(face);
        double ny = polygon.normalY(face);
        int end = face + 1 == polygon.corners() ? 0 : face + 1;
        return nx * (y - polygon.cornerY(face)) - ny * (x - polygon.cornerX(face)) > inside
                && ny * (x - polygon.cornerX(end)) - nx * (y - polygon.cornerY(end)) > inside;
    }

    /**
     * The corner nearest to a face with an inward normal, from a guess. It walks in strides, a
     * quarter of the way round at first and then ever smaller ones, as long as they lead nearer. On
     * a convex outline, a corner that is nearer than both its neighbours is the nearest of all.
     */
    private static int nearestTo(Outline polygon, double x, double y, int guess) {
        int corners = polygon.corners();
        int at = guess;
        double least = x * polygon.cornerX(at) + y * polygon.cornerY(at);
        int stride = Math.max(1, corners / 4);
        while (stride > 0) {
            int ahead = at + stride < corners ? at + stride : at + stride - corners;
            double height = x * polygon.cornerX(ahead) + y * polygon.cornerY(ahead);
            if (height >= least) {
                ahead = at >= stride ? at - stride : at - stride + corners;
                height = x * polygon.cornerX(ahead) + y * polygon.cornerY(ahead);
            }
            if (height < least) {
                least = height;
                at = ahead;
            } else {
                stride /= 2;
            }
        }
        return at;
    }
}
