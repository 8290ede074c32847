package rigibo.backend.impact;

/**
 * Solves all rows of tied impacts that carry something at once, as passes have found them: points
 * that push, friction within its cone, and friction at its cone, which goes with what presses. The
 * passes tell well which rows these are, and come to their impulses slowly: Newton's method on
 * Coulomb's law (P. Alart and A. Curnier, 1991) started from them.
 */
final class TiedElimination {

    /** Rows beyond which elimination takes longer than passes. */
    private static final int MOST_ROWS = 96;

    /** By what share of its response a row gives way: redundant rows share what they carry. */
    private static final double GIVE = 1e-10;

    /**
     * How many times the fastest approach the impulse of a row may change its own speed by: what
     * lies farther contradicts itself, and only what rows give way by bounds it.
     */
    private static final double FARTHEST = 1e4;

    private final TiedRows rows;

    /** The rows that are equations, and the place of each row among them. */
    private int[] set = new int[16];

    private int[] place = new int[16];
    private int size;

    /** L by rows and U by columns, and the inverse of U's diagonal. */
    private double[] lower = new double[16 * 16];

    private double[] upper = new double[16 * 16];

    private double[] inverse = new double[16];

    /** What each row's impulse lacks, N·s. */
    private double[] lacks = new double[16];

    TiedElimination(TiedRows rows) {
        this.rows = rows;
    }

    /**
     * Goes to the impulses that give every row that carries something the speed it asks for, or up
     * to the first bound on the way, where nothing approached faster than {@code fastest} m/s.
     *
     * @return multiplications that this took, 0 where there is nothing to be solved at once
     */
    double solve(double fastest) {
        choose();
        if (size < 2 || size > MOST_ROWS) {
            return 0;
        }
        factorize();
        substitute();
        if (isFartherThan(FARTHEST * fastest)) {
            return 0;
        }
        double share = shareToFirstBound();
        for (int i = 0; i < size; i++) {
            rows.push(set[i], share * lacks[i]);
        }
        for (int row = 0; row < rows.count; row++) {
            if (isSliding(row)) {
                rows.push(
                        row, slides(row) * rows.cone(row) / rows.friction[row] - rows.impulse[row]);
            }
        }
        return size * (double) size * size / 3;
    }

    private void choose() {
        if (set.length < rows.count) {
            set = new int[rows.pair.length];
            place = new int[rows.pair.length];
            lacks = new double[rows.pair.length];
            inverse = new double[rows.pair.length];
        }
        size = 0;
        for (int row = 0; row < rows.count; row++) {
            boolean isNormal = rows.points[row] == 0;
            double impulse = rows.impulse[row];
            boolean isEquation = isNormal ? impulse > 0 : Math.abs(impulse) < rows.cone(row);
            place[row] = isEquation ? size : TiedRows.NONE;
            if (isEquation) {
                set[size++] = row;
            }
        }
        if (size <= MOST_ROWS && lower.length < size * size) {
            lower = new double[MOST_ROWS * MOST_ROWS];
            upper = new double[MOST_ROWS * MOST_ROWS];
        }
    }

    /** Whether a tangent rubs as much as it can. */
    private boolean isSliding(int row) {
        return rows.points[row] > 0 && place[row] == TiedRows.NONE && rows.impulse[row] != 0;
    }

    /** The friction that comes with a unit impulse of a tangent's normals. */
    private double slides(int tangent) {
        return Math.copySign(rows.friction[tangent], rows.impulse[tangent]);
    }

    /** What a unit impulse of one row, and the friction with it, gives another, 1/kg. */
    private double answer(int i, int j) {
        double direct = rows.response(i, j);
        int tangent = rows.tangent[j];
        boolean slides = rows.points[j] == 0 && tangent != TiedRows.NONE && isSliding(tangent);
        return slides ? direct + slides(tangent) * rows.response(i, tangent) : direct;
    }

    /** Row i of L and column i of U by those before them (Doolittle), in the order of the rows. */
    private void factorize() {
        for (int i = 0; i < size; i++) {
            int own = i * size;
            for (int j = 0; j < i; j++) {
                int other = j * size;
                double l = answer(set[i], set[j]);
                double u = answer(set[j], set[i]);
                for (int k = 0; k < j; k++) {
                    l -= lower[own + k] * upper[other + k];
                    u -= lower[other + k] * upper[own + k];
                }
                lower[own + j] = l * inverse[j];
                upper[own + j] = u;
            }
            double gives = GIVE * rows.response[set[i]];
            double left = answer(set[i], set[i]) + gives;
            for (int k = 0; k < i; k++) {
                left -= lower[own + k] * upper[own + k];
            }
            inverse[i] = 1 / (Math.abs(left) > gives ? left : gives);
        }
    }

    private void substitute() {
        for (int i = 0; i < size; i++) {
            lacks[i] = rows.target[set[i]] - rows.speed(set[i]);
            for (int k = 0; k < i; k++) {
                lacks[i] -= lower[i * size + k] * lacks[k];
            }
        }
        for (int i = size - 1; i >= 0; i--) {
            lacks[i] *= inverse[i];
            for (int k = 0; k < i; k++) {
                lacks[k] -= upper[i * size + k] * lacks[i];
            }
        }
    }

    private boolean isFartherThan(double speed) {
        for (int i = 0; i < size; i++) {
            if (!(Math.abs(lacks[i]) * rows.response[set[i]] <= speed)) {
                return true;
            }
        }
        return false;
    }

    /** Up to where no point pulls, and no friction leaves its cone. */
    private double shareToFirstBound() {
        double share = 1;
        for (int i = 0; i < size; i++) {
            int row = set[i];
            if (rows.points[row] == 0) {
                if (rows.impulse[row] + lacks[i] < 0) {
                    share = Math.min(share, -rows.impulse[row] / lacks[i]);
                }
            } else {
                share = Math.min(share, shareToCone(row, lacks[i]));
            }
        }
        return share;
    }

    private double shareToCone(int tangent, double lack) {
        double grows = 0;
        for (int row = tangent - rows.points[tangent]; row < tangent; row++) {
            grows += place[row] == TiedRows.NONE ? 0 : lacks[place[row]];
        }
        grows *= rows.friction[tangent];
        double cone = rows.cone(tangent);
        double side = Math.signum(rows.impulse[tangent] + lack);
        double room = cone - side * rows.impulse[tangent];
        double taken = side * lack - grows;
        return taken > room ? Math.max(0, room) / taken : 1;
    }
}
